// The hand that holds a dot, by pointer or by arrow keys: where it asks the dot to be, and what it reports.

import { Vector3 } from "three";
import type { CameraRig } from "./camera-rig";
import type { Emitter } from "../util/emitter";
import type { StageEvents } from "../stage/port";

const KEYS_REST_MS = 700;
const STEP = 0.01;
const FINE_STEP = 0.002;
const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class PointHand {
  /** The dot in the hand, or one just let go whose surface has not arrived yet: it stays where the hand left it. */
  id: string | null = null;
  holding = false;
  /** Model world metres. */
  readonly origin = new Vector3();
  readonly target = new Vector3();
  private byKeys = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private readonly scene = new Vector3();

  /** `offset`: from the model's world to the drawn scene. */
  constructor(
    private readonly events: Emitter<StageEvents>,
    private readonly rig: CameraRig,
    private readonly offset: Vector3,
  ) {}

  grab(id: string, at: Vector3): void {
    if (this.holding) this.letGo(false);
    this.id = id;
    this.holding = true;
    this.byKeys = false;
    this.origin.copy(at);
    this.target.copy(at);
    this.rig.hold(true);
    this.events.emit("point-grab", { id });
  }

  drag(dx: number, dy: number, inOut: boolean): void {
    this.scene.addVectors(this.target, this.offset);
    this.rig.moveInView(this.scene, dx, dy, inOut);
    this.ask();
  }

  letGo(cancelled: boolean): void {
    if (!this.holding || this.id === null) return;
    const id = this.id;
    this.holding = false;
    clearTimeout(this.rest);
    this.rig.hold(false);
    if (cancelled) this.id = null;
    this.events.emit(cancelled ? "point-cancel" : "point-drop", { id });
  }

  /** A new surface is drawn: a dot that was let go rides on it again. */
  settle(): void {
    if (!this.holding) this.id = null;
  }

  /** Arrow keys on a focused dot; `at` is its place. True if the key was ours. */
  keyDown(event: KeyboardEvent, id: string, at: Vector3): boolean {
    if (event.key === "Escape" && this.holding && this.byKeys) {
      this.letGo(true);
      return true;
    }
    const arrow = ARROWS[event.key];
    if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return false;
    if (!this.holding) {
      this.grab(id, at);
      this.byKeys = true;
    }
    clearTimeout(this.rest);
    const step = event.shiftKey ? FINE_STEP : STEP;
    this.scene.addVectors(this.target, this.offset);
    this.rig.moveMetres(this.scene, arrow[0] * step, arrow[1] * step, false);
    this.ask();
    return true;
  }

  /** A burst of arrow keys is one drag: it ends when they rest. */
  keyUp(key: string, ended: () => void): void {
    if (!(key in ARROWS) || !this.byKeys || !this.holding) return;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.endKeys();
      ended();
    }, KEYS_REST_MS);
  }

  endKeys(): void {
    if (this.byKeys) this.letGo(false);
  }

  private ask(): void {
    this.target.subVectors(this.scene, this.offset);
    if (this.id !== null) this.events.emit("point-move", { id: this.id, position: this.target.toArray() });
  }
}
