// The floor: a blueprint grid that fades into the stage, and the plane that catches the sun's shadow.

import { Color, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial, Vector2 } from "three";
import type { Theme } from "./theme";

const SIZE = 30;
const SHADOW_SIZE = 12;

export class Ground {
  readonly group = new Group();
  private readonly plane = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
  private readonly shadow = new ShadowMaterial({ depthWrite: false, toneMapped: false });
  private readonly grid = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    uniforms: {
      minor: { value: new Color() },
      major: { value: new Color() },
      travel: { value: new Vector2() },
      fade: { value: new Vector2() },
      pixelRatio: { value: 1 },
    },
    vertexShader: `
      varying vec2 place;
      varying float depth;
      void main() {
        vec4 view = modelViewMatrix * vec4(position, 1.0);
        place = (modelMatrix * vec4(position, 1.0)).xz;
        depth = -view.z;
        gl_Position = projectionMatrix * view;
      }`,
    // Lines one CSS pixel wide at every distance, let go where they would be closer than three pixels.
    fragmentShader: `
      uniform vec3 minor, major;
      uniform vec2 travel, fade;
      uniform float pixelRatio;
      varying vec2 place;
      varying float depth;
      float lines(float gap, vec2 width) {
        vec2 off = abs(fract((place + travel) / gap + 0.5) - 0.5) * gap;
        vec2 ink = (1.0 - smoothstep(0.15, 0.9, off / width)) * (1.0 - smoothstep(0.12, 0.33, width / gap));
        return max(ink.x, ink.y);
      }
      void main() {
        vec2 width = fwidth(place) * pixelRatio;
        if (depth > fade.y) discard;
        float one = lines(1.0, width);
        float ink = max(one, lines(0.5, width)) * (1.0 - smoothstep(fade.x, fade.y, depth));
        gl_FragColor = vec4(mix(minor, major, one), ink);
        #include <colorspace_fragment>
      }`,
  });

  private readonly floor = new Mesh(this.plane, this.shadow);

  constructor() {
    const { floor } = this;
    const grid = new Mesh(this.plane, this.grid);
    grid.scale.setScalar(SIZE);
    floor.scale.setScalar(SHADOW_SIZE);
    grid.renderOrder = -10;
    floor.renderOrder = -9;
    floor.receiveShadow = true;
    this.group.add(grid, floor);
  }

  setTheme(theme: Theme): void {
    this.grid.uniforms["minor"]!.value.copy(theme.grid);
    this.grid.uniforms["major"]!.value.copy(theme.gridMajor);
    this.shadow.color.set(theme.dark ? "#000000" : "#143244");
    this.shadow.opacity = theme.dark ? 0.36 : 0.16;
  }

  setShadow(on: boolean): void {
    this.floor.visible = on;
  }

  /** How far the stage has travelled under the camera, and how far away the camera is. */
  update(x: number, z: number, distance: number, pixelRatio: number): void {
    this.grid.uniforms["travel"]!.value.set(x % 1, z % 1);
    this.grid.uniforms["fade"]!.value.set(distance + 0.3, distance + 3.8);
    this.grid.uniforms["pixelRatio"]!.value = pixelRatio;
  }

  dispose(): void {
    this.plane.dispose();
    this.grid.dispose();
    this.shadow.dispose();
  }
}
