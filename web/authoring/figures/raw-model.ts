// A model as its file holds it, by three.js's own loaders: what ours makes of it is what is to be judged.

import { Group, Mesh, MeshStandardMaterial, type Object3D } from "three";
import { FBXLoader } from "three/examples/jsm/loaders/FBXLoader.js";
import { DRACOLoader } from "three/examples/jsm/loaders/DRACOLoader.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import { MeshoptDecoder } from "three/examples/jsm/libs/meshopt_decoder.module.js";

const grey = (): MeshStandardMaterial => new MeshStandardMaterial({ color: "#c8b8a4", roughness: 0.8 });

async function off(url: string): Promise<string> {
  const [, counts, ...lines] = (await (await fetch(url)).text()).split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
  const [vertices, faces] = counts.trim().split(/\s+/).map(Number);
  const part = (from: number, to: number): string[][] => lines.slice(from, to).map((line) => line.trim().split(/\s+/));
  return [
    ...part(0, vertices).map((row) => `v ${row.slice(0, 3).join(" ")}`),
    ...part(vertices, vertices + faces).map(
      ([n, ...row]) =>
        `f ${row
          .slice(0, Number(n))
          .map((v) => Number(v) + 1)
          .join(" ")}`,
    ),
  ].join("\n");
}

export async function loadRaw(url: string): Promise<Object3D> {
  const kind = /\.(\w+)$/.exec(url)?.[1].toLowerCase();
  if (kind === "glb" || kind === "gltf" || kind === "vrm") {
    const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
    loader.setDRACOLoader(new DRACOLoader().setDecoderPath("/node_modules/three/examples/jsm/libs/draco/gltf/"));
    return (await loader.loadAsync(url)).scene;
  }
  if (kind === "fbx") return new FBXLoader().loadAsync(url);
  if (kind === "obj" || kind === "off") {
    const object = kind === "obj" ? await new OBJLoader().loadAsync(url) : new OBJLoader().parse(await off(url));
    object.traverse((node) => {
      if (node instanceof Mesh) node.material = grey();
    });
    return object;
  }
  const geometry = await (kind === "ply" ? new PLYLoader() : new STLLoader()).loadAsync(url);
  if (!geometry.attributes.normal) geometry.computeVertexNormals();
  return new Group().add(new Mesh(geometry, grey()));
}
