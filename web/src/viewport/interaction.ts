// What pointer and keys do to the marks: hover, press, drag, pick, nudge.

import { Vector3 } from "three";
import type { Emitter } from "../util/emitter";
import type { Annotations } from "./annotations";
import type { Point } from "./arc";
import type { CameraRig } from "./camera-rig";
import type { PointHand } from "./point-hand";
import type { PointHit, PlacedMark } from "./point-overlay";
import { Pointer } from "./pointer";
import type { StageEvents } from "../stage/port";

/** A press this soon after the hand came near is meant for the dot, even where it has danced on by some pixels. */
const CHASE_MS = 600;

export class Interaction {
  private readonly pointer: Pointer;
  private readonly abort = new AbortController();
  private pressed: PointHit | null = null;
  private near = false;
  private nearSince = 0;
  private readonly place = new Vector3();

  /** `refresh`: the marks changed. */
  constructor(
    private readonly element: HTMLElement,
    private readonly rig: CameraRig,
    private readonly hand: PointHand,
    private readonly marks: Annotations,
    private readonly events: Emitter<StageEvents>,
    private readonly refresh: () => void,
    /** The model has just moved by itself. */
    private readonly moving: () => boolean,
  ) {
    this.pointer = this.listenToPointer();
    this.listenToMarks();
  }

  dispose(): void {
    this.abort.abort();
    this.pointer.dispose();
  }

  private listenToPointer(): Pointer {
    return new Pointer(this.element, {
      press: (at, touch) => this.press(at, touch),
      dragStart: () => this.startDrag(),
      drag: (dx, dy, shift) => {
        this.hand.drag(dx, dy, shift);
        this.refresh();
      },
      dragEnd: (cancelled) => this.endDrag(cancelled),
      click: (at, touch) => this.click(at, touch),
      hover: (at) => this.hover(at),
      setPanning: (on) => this.rig.setPanning(on),
      setCamera: (enabled) => {
        this.rig.controls.enabled = enabled;
        if (enabled) this.element.style.cursor = "";
      },
    });
  }

  private press(at: Point, touch: boolean): boolean {
    const { marks } = this;
    const chasing = !this.near || performance.now() - this.nearSince < CHASE_MS;
    this.pressed = marks.pointAt(at, touch) ?? (chasing && this.moving() ? marks.pointChased(at) : null);
    if (!marks.live) marks.pointer = null; // until it is up again
    marks.overlay.setHover(null);
    const mark = this.pressed && marks.overlay.find(this.pressed.id, this.pressed.on);
    if (mark) marks.overlay.press(mark);
    const drags = mark !== null && canDrag(mark);
    this.element.style.cursor = drags ? "grabbing" : "";
    this.setNear(drags);
    this.refresh();
    return drags;
  }

  private startDrag(): void {
    const mark = this.pressed && this.marks.overlay.find(this.pressed.id, "model");
    if (!mark) return;
    this.hand.grab(mark.id, this.marks.pointPosition(mark.point, this.place));
    this.marks.overlay.setHeld(mark.id);
  }

  private endDrag(cancelled: boolean): void {
    this.hand.letGo(cancelled);
    this.marks.overlay.setHeld(null);
    this.marks.note = "";
    this.refresh();
  }

  private click(at: Point, touch: boolean): void {
    const hit = this.marks.pointAt(at, touch);
    if (hit) return this.events.emit("point-pick", hit);
    if (this.marks.mode === "points") {
      const joint = this.marks.jointAt(at, touch);
      if (joint >= 0) return this.events.emit("joint-pick", { joint });
      const vertex = this.marks.vertexAt(at);
      if (vertex >= 0) return this.events.emit("surface-pick", { vertex });
    }
    this.events.emit("empty-pick", {});
  }

  /** A dot that dances is hard to catch: say so when a hand comes near. */
  private setNear(near: boolean): void {
    if (near === this.near) return;
    this.near = near;
    this.nearSince = performance.now();
    this.events.emit("point-reach", { near });
  }

  private hover(at: Point | null): void {
    const { marks } = this;
    this.setNear(at !== null && marks.pointChased(at) !== null);
    marks.pointer = at;
    const hit = at && marks.pointAt(at, false);
    const changed = marks.overlay.setHover(hit);
    const mark = hit && marks.overlay.find(hit.id, hit.on);
    this.element.style.cursor = !hit ? "" : mark && canDrag(mark) ? "grab" : "pointer";
    if (changed || marks.live || marks.mode === "points") this.refresh();
  }

  private listenToMarks(): void {
    const { signal } = this.abort;
    const { overlay } = this.marks;
    const owner = (event: Event): PlacedMark | null => overlay.owner(event.target);
    overlay.element.addEventListener(
      "keydown",
      (event) => {
        const mark = owner(event);
        if (!mark || !canDrag(mark)) return;
        if (!this.hand.keyDown(event, mark.id, this.marks.pointPosition(mark.point, this.place))) return;
        event.preventDefault();
        event.stopPropagation();
        overlay.setHeld(this.hand.holding ? mark.id : null);
        this.refresh();
      },
      { signal },
    );
    const ended = (): void => {
      if (!this.hand.holding) overlay.setHeld(null);
      this.refresh();
    };
    overlay.element.addEventListener("keyup", (event) => this.hand.keyUp(event.key, ended), { signal });
    overlay.element.addEventListener(
      "focusout",
      () => {
        this.hand.endKeys();
        ended();
      },
      { signal },
    );
    overlay.element.addEventListener("focusin", () => this.refresh(), { signal });
    // Enter, Space and assistive technology; a pointer's click comes through the pointer.
    overlay.element.addEventListener(
      "click",
      (event) => {
        const mark = owner(event);
        if (mark && event.detail === 0) this.events.emit("point-pick", { id: mark.id, on: mark.on });
      },
      { signal },
    );
  }
}

/** A dot of the model that is a point already. */
function canDrag({ on, point }: PlacedMark): boolean {
  return on === "model" && !point.suggested;
}
