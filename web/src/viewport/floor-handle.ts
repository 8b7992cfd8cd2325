// A handle on the floor that pointer and keys move over it.

import { Vector3 } from "three";
import type { CameraRig } from "./camera-rig";

/** Keys within such a time are one step. */
const BURST_MS = 800;
/** Metres that a key moves by. */
const STEP = 0.1;
const KEYS: Readonly<Record<string, readonly [x: number, z: number]>> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

export class FloorHandle {
  /** A hand has it. */
  held = false;
  private readonly button = document.createElement("button");
  private readonly abort = new AbortController();
  /** Where on the floor the hand took it. */
  private readonly from = new Vector3();
  /** By how much a burst of keys has moved it. */
  private keyed: [number, number] | null = null;
  private resting: ReturnType<typeof setTimeout> | undefined;

  /** `move`: by so many metres since it was taken. It lies over the canvas. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly rig: CameraRig,
    private readonly move: (by: { x: number; z: number; held: boolean }) => void,
  ) {
    const { button } = this;
    button.className = "floor-handle";
    button.hidden = true;
    // A constructed sheet belongs to all of the stage: what one button needs is said on itself.
    Object.assign(button.style, {
      position: "absolute",
      left: "0",
      top: "0",
      width: "44px",
      height: "44px",
      margin: "-22px",
      padding: "0",
      border: "0",
      borderRadius: "50%",
      background: "none",
      cursor: "move",
      touchAction: "none",
      zIndex: "1",
    });
    const { signal } = this.abort;
    button.addEventListener("pointerdown", (event) => this.take(event), { signal });
    button.addEventListener("pointermove", (event) => this.drag(event), { signal });
    for (const name of ["pointerup", "pointercancel"] as const) button.addEventListener(name, (event) => this.drop(event), { signal });
    button.addEventListener("keydown", (event) => this.key(event), { signal });
    button.addEventListener("blur", () => this.endKeys(), { signal });
    canvas.after(button);
  }

  get named(): boolean {
    return !this.button.hidden;
  }

  name(words: string | null): void {
    this.button.hidden = words === null;
    if (words === null) return;
    this.button.ariaLabel = words;
    this.button.title = words;
  }

  /** Over a point of the scene. */
  put(point: Vector3): void {
    const { x, y } = this.rig.project(point, { x: 0, y: 0, depth: 0 });
    this.button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  dispose(): void {
    this.abort.abort();
    this.button.remove();
  }

  private take(event: PointerEvent): void {
    event.stopPropagation();
    if (event.button !== 0 || !this.floor(event, this.from)) return;
    this.button.setPointerCapture(event.pointerId);
    this.rig.hold(true);
    this.held = true;
  }

  private drag(event: PointerEvent): void {
    event.stopPropagation();
    if (this.held) this.tell(event, true);
  }

  private drop(event: PointerEvent): void {
    event.stopPropagation();
    if (!this.held) return;
    this.held = false;
    this.rig.hold(false);
    this.tell(event, false);
  }

  private tell(event: PointerEvent, held: boolean): void {
    const to = this.floor(event, new Vector3());
    if (to) this.move({ x: to.x - this.from.x, z: to.z - this.from.z, held });
    else if (!held) this.move({ x: 0, z: 0, held });
  }

  private key(event: KeyboardEvent): void {
    const by = KEYS[event.key];
    if (!by || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const [x, z] = this.keyed ?? [0, 0];
    this.keyed = [x + by[0], z + by[1]];
    this.move({ x: this.keyed[0], z: this.keyed[1], held: true });
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.endKeys(), BURST_MS);
  }

  private endKeys(): void {
    clearTimeout(this.resting);
    if (!this.keyed) return;
    const [x, z] = this.keyed;
    this.keyed = null;
    this.move({ x, z, held: false });
  }

  /** Where the floor is under the pointer; null above the horizon. */
  private floor({ clientX, clientY }: PointerEvent, out: Vector3): Vector3 | null {
    const { camera } = this.rig;
    const box = this.canvas.getBoundingClientRect();
    out.set((2 * (clientX - box.left)) / box.width - 1, 1 - (2 * (clientY - box.top)) / box.height, 0.5).unproject(camera);
    const way = out.sub(camera.position);
    if (way.y > -0.01 * way.length()) return null;
    return out.multiplyScalar(-camera.position.y / way.y).add(camera.position);
  }
}
