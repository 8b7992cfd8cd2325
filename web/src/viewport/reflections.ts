// What metal mirrors: without surroundings it would be black. Made only for models that have some.

import { type Material, MeshStandardMaterial, PMREMGenerator, ShaderChunk, type WebGLRenderer } from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

/** The room is mirrored and lights nothing: what is not metal looks as it does beside materials that mirror none. */
const MIRRORED = ShaderChunk.lights_fragment_maps.replace(/iblIrradiance \+=.*;/, "");

/** Gives each of the materials a room to mirror; answers what to dispose of with them. */
export function reflect(materials: readonly Material[], renderer: WebGLRenderer): { dispose(): void } {
  const generator = new PMREMGenerator(renderer);
  const room = new RoomEnvironment();
  const target = generator.fromScene(room, 0.04);
  for (const material of materials) {
    if (!(material instanceof MeshStandardMaterial)) continue;
    material.envMap = target.texture;
    material.envMapIntensity = 0.7;
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace("#include <lights_fragment_maps>", MIRRORED);
    };
    material.customProgramCacheKey = () => "mirrors";
  }
  room.dispose();
  generator.dispose();
  return target;
}
