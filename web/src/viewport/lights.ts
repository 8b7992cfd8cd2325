// Sun, sky, fill and rim, fixed to the world; the figures stay around the origin, so the shadow's box is fitted once per framing.

import { DirectionalLight, Group, HemisphereLight, Vector3 } from "three";
import type { Quality } from "./quality";

export class Lights {
  readonly group = new Group();
  private readonly sky = new HemisphereLight();
  private readonly key = new DirectionalLight("#fff1de");
  private readonly fill = new DirectionalLight("#bcd9ff");
  private readonly rim = new DirectionalLight("#eaf6ff");

  constructor() {
    this.key.position.set(-2.6, 4.6, 1.9).multiplyScalar(2);
    this.fill.position.set(4, 1.5, 2);
    this.rim.position.set(2, 3, -4);
    const { shadow } = this.key;
    shadow.bias = -0.0004;
    shadow.normalBias = 0.02;
    this.group.add(this.sky, this.key, this.fill, this.rim);
  }

  setDark(dark: boolean): void {
    this.sky.groundColor.set(dark ? "#8b9199" : "#cdbfb2");
    this.sky.intensity = dark ? 1 : 1.15;
    this.key.intensity = dark ? 2.1 : 2.3;
    this.fill.intensity = dark ? 0.4 : 0.35;
    this.rim.intensity = dark ? 1.2 : 0.8;
  }

  setShadow({ shadowMap, blurSamples }: Quality): void {
    const { shadow } = this.key;
    this.key.castShadow = shadowMap > 0;
    shadow.mapSize.set(shadowMap, shadowMap);
    shadow.radius = (9 * shadowMap) / 1024;
    shadow.blurSamples = blurSamples;
    shadow.dispose(); // the next frame makes maps of the new size
    shadow.map = shadow.mapPass = null;
  }

  /** Fits the shadow to a box around the origin that stands on the ground. */
  fitShadow(width: number, height: number, depth: number): void {
    const { camera } = this.key.shadow;
    this.key.updateMatrixWorld();
    camera.position.copy(this.key.position);
    camera.up.set(0, 1, 0);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = new Vector3(-Infinity, -Infinity, -Infinity);
    for (let corner = 0; corner < 8; corner++) {
      const point = new Vector3(
        (corner & 1 ? 0.5 : -0.5) * width,
        corner & 2 ? height : -0.2,
        (corner & 4 ? 0.5 : -0.5) * depth,
      ).applyMatrix4(camera.matrixWorldInverse);
      low.min(point);
      high.max(point);
    }
    camera.left = low.x;
    camera.right = high.x;
    camera.bottom = low.y;
    camera.top = high.y;
    camera.near = -high.z - 0.5;
    camera.far = -low.z + 0.5;
    camera.updateProjectionMatrix();
  }

  dispose(): void {
    this.key.dispose();
  }
}
