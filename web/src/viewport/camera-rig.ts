// The camera: orbit, pan and zoom by camera-controls, framed into the free part of the stage. The stage travels under it
// (see viewport.ts), so the camera itself never leaves the origin.

import CameraControls from "camera-controls";
import { Box3, Matrix4, PerspectiveCamera, Quaternion, Raycaster, Sphere, Spherical, Vector2, Vector3, Vector4 } from "three";
import type { StageView } from "../stage/port";
import { AZIMUTH, FIELD_OF_VIEW, frame, pixelsPerMetre, TARGET_HEIGHT, TURNING, turned, VIEWS, type Content, type View } from "./framing";

CameraControls.install({ THREE: { Box3, Matrix4, Quaternion, Raycaster, Sphere, Spherical, Vector2, Vector3, Vector4 } });

/** A hand that let go may take again: the picture stays so long. */
const HOLD_MS = 1000;

/** A point on the stage in CSS pixels, and its distance along the view. */
export interface Projected {
  x: number;
  y: number;
  depth: number;
}

export class CameraRig {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 80);
  readonly controls: CameraControls;
  /** Metres that the framing asks for; with a camera in the hand, when the hand last moved it. */
  private distance = 0;
  /** The hand's distance beside it. */
  zoom = 1;
  private view: View = { width: 1, height: 1, insets: { left: 0, top: 0, right: 0, bottom: 0 } };
  private content: Content = { width: 2.7, height: 1.75, depth: 1 };
  private readonly shift = new Vector2();
  private readonly shiftGoal = new Vector2();
  /** It goes around by itself. */
  turning = false;
  /** The user moved the camera: from now on we only step back with figures that come apart. */
  private byHand = false;
  /** There is something in the picture. */
  private shown = false;
  /** It was seen: from now on the camera moves smoothly. */
  private placed = false;
  /** A hand holds something in the picture, or has just let go. */
  private held = false;
  private release: ReturnType<typeof setTimeout> | undefined;
  private readonly scratch = new Vector3();
  private readonly spherical = new Spherical();

  constructor(
    element: HTMLElement,
    private readonly still: boolean,
    private readonly onInput: () => void,
  ) {
    const controls = new CameraControls(this.camera, element);
    const { ACTION } = CameraControls;
    controls.mouseButtons = { left: ACTION.ROTATE, middle: ACTION.TRUCK, right: ACTION.TRUCK, wheel: ACTION.DOLLY };
    controls.touches = { one: ACTION.TOUCH_ROTATE, two: ACTION.TOUCH_DOLLY_TRUCK, three: ACTION.TOUCH_TRUCK };
    controls.minDistance = 1.2;
    controls.maxDistance = 24;
    controls.maxPolarAngle = Math.PI / 2 - 0.01;
    controls.smoothTime = still ? 0 : 0.16;
    controls.draggingSmoothTime = still ? 0 : 0.05;
    controls.restThreshold = 0.002;
    controls.addEventListener("control", () => {
      this.byHand = true;
      this.distance = frame(this.view, this.seen()).distance;
      this.zoom = controls.getSpherical(this.spherical).radius / this.distance;
      onInput();
    });
    controls.addEventListener("transitionstart", onInput);
    this.controls = controls;
  }

  setView(view: View): void {
    this.view = view;
    this.reframe();
  }

  /** What must stay in the picture. Between two calls of fit() the camera only ever steps back. */
  setContent(content: Content): void {
    this.content = content;
    this.shown = true;
    this.reframe();
  }

  /** All is seen, from the front as at first, or from elsewhere. */
  fit(view: StageView = "front"): void {
    const [around, up] = VIEWS[view];
    this.held = false;
    this.byHand = around !== 0;
    this.distance = 0;
    this.zoom = 1;
    const smooth = this.placed && !this.still;
    void this.controls.setTarget(0, TARGET_HEIGHT, 0, smooth);
    void this.controls.rotateTo(AZIMUTH + around, Math.PI / 2 - up, smooth);
    this.reframe();
  }

  /** Nothing moves under a hand: what the framing asks for meanwhile comes a second after it let go. */
  hold(on: boolean): void {
    clearTimeout(this.release);
    if (on) {
      this.held = true;
      this.controls.stop();
      this.shiftGoal.copy(this.shift);
    } else {
      this.release = setTimeout(() => {
        this.held = false;
        this.reframe();
        this.onInput();
      }, HOLD_MS);
    }
  }

  setPanning(on: boolean): void {
    const { ACTION } = CameraControls;
    this.controls.mouseButtons.left = on ? ACTION.TRUCK : ACTION.ROTATE;
  }

  /** Moves on by some seconds; true while it has not come to rest. */
  update(seconds: number): boolean {
    const around = this.turning && this.placed && !this.held;
    if (around) {
      this.byHand = true;
      void this.controls.rotate(TURNING * seconds, 0, false);
    }
    const moving = this.controls.update(seconds) || around;
    this.placed ||= this.shown;
    const rest = this.shift.distanceToSquared(this.shiftGoal) < 0.04;
    if (this.still || rest) this.shift.copy(this.shiftGoal);
    else this.shift.lerp(this.shiftGoal, 1 - Math.exp(-seconds / 0.09));
    const { width, height } = this.view;
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, -this.shift.x, -this.shift.y, width, height);
    this.camera.updateMatrixWorld();
    return moving || !rest;
  }

  project(point: Vector3, out: Projected): Projected {
    const p = this.scratch.copy(point).applyMatrix4(this.camera.matrixWorldInverse);
    out.depth = -p.z;
    p.applyMatrix4(this.camera.projectionMatrix);
    out.x = (0.5 + 0.5 * p.x) * this.view.width;
    out.y = (0.5 - 0.5 * p.y) * this.view.height;
    return out;
  }

  /** Adds a move in pixels to a point: across the view, or into the picture (up is away). */
  moveInView(point: Vector3, dx: number, dy: number, inOut: boolean): void {
    const depth = -this.scratch.copy(point).applyMatrix4(this.camera.matrixWorldInverse).z;
    const metres = 1 / pixelsPerMetre(this.view.height, Math.max(depth, 0.1));
    this.moveMetres(point, dx * metres, -dy * metres, inOut);
  }

  moveMetres(point: Vector3, right: number, up: number, inOut: boolean): void {
    const axis = (column: number): Vector3 => this.scratch.setFromMatrixColumn(this.camera.matrixWorld, column);
    point.addScaledVector(axis(0), right);
    point.addScaledVector(axis(inOut ? 2 : 1), inOut ? -up : up);
  }

  dispose(): void {
    clearTimeout(this.release);
    this.controls.dispose();
  }

  /** The content from where the hand turned the camera to. */
  private seen(): Content {
    return turned(this.content, this.controls.getSpherical(this.spherical).theta - AZIMUTH);
  }

  private reframe(): void {
    if (this.view.width < 2 || this.view.height < 2 || this.held) return;
    const { byHand, controls } = this;
    const framing = frame(this.view, byHand ? this.seen() : this.content);
    this.shiftGoal.set(framing.shiftX, framing.shiftY);
    if (!this.placed) this.shift.copy(this.shiftGoal);
    const grown = framing.distance > this.distance * 1.01;
    const resized = framing.distance < this.distance * 0.8; // a bigger window, not a step aside
    if (grown || (resized && !byHand)) {
      this.distance = framing.distance;
      void controls.dollyTo(this.zoom * framing.distance, this.placed && !this.still);
    }
  }
}
