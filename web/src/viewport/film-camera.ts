// Where the camera of a film stands: in the direction from which the person looks, as far off as the film's own frame asks for.

import { PerspectiveCamera, Spherical, Vector3 } from "three";
import type { CameraRig } from "./camera-rig";
import { AZIMUTH, type Content, ELEVATION, FIELD_OF_VIEW, frame, pixelsPerMetre, TARGET_HEIGHT, turned } from "./framing";

const NO_INSETS = { left: 0, top: 0, right: 0, bottom: 0 };
/** Of a camera that goes around, so many views decide how far off it stays. */
const VIEWS = 16;
/** Figures that do not fill the height stand so much under the middle of it, as a share. */
const LOWER = 0.04;

export class FilmCamera {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 80);
  private readonly view = new Spherical();
  private readonly target = new Vector3();

  constructor(rig: CameraRig) {
    rig.controls.getSpherical(this.view);
    rig.controls.getTarget(this.target);
    this.view.radius = rig.zoom;
  }

  /** Metres from the target. */
  get distance(): number {
    return this.camera.position.distanceTo(this.target);
  }

  /** Holds content, which may be seen from all sides, in a frame of so many pixels. */
  fit(content: Content, width: number, height: number, around: boolean): void {
    const { theta } = this.view;
    const views = Array.from({ length: around ? VIEWS : 1 }, (_, k) => theta - AZIMUTH + (2 * Math.PI * k) / VIEWS);
    const framings = views.map((angle) => frame({ width, height, insets: NO_INSETS }, turned(content, angle)));
    const { distance, shiftX, shiftY } = framings.reduce((a, b) => (b.distance > a.distance ? b : a));
    const middle = (content.height / 2 - TARGET_HEIGHT) * Math.cos(ELEVATION) * pixelsPerMetre(height, distance);
    this.view.radius *= distance;
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, -shiftX, -Math.min(shiftY, middle + LOWER * height), width, height);
  }

  /** Looks from so many radians further around. */
  turn(by: number): void {
    const { radius, phi, theta } = this.view;
    this.camera.position.setFromSphericalCoords(radius, phi, theta + by).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
  }
}
