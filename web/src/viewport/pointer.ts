// Gestures: what becomes a click, what a drag of a dot, and what is left to the camera.

import type { Point } from "./arc";

const CLICK_PIXELS = 5;

export interface PointerHandler {
  /** A press; true takes the pointer away from the camera for a drag. */
  press(at: Point, touch: boolean): boolean;
  /** The taken pointer left the click's circle. */
  dragStart(): void;
  drag(dx: number, dy: number, shift: boolean): void;
  dragEnd(cancelled: boolean): void;
  /** Up within 5 pixels. */
  click(at: Point, touch: boolean): void;
  hover(at: Point | null): void;
  /** Space is down: a drag pans. */
  setPanning(on: boolean): void;
  /** The camera listens, or not. */
  setCamera(enabled: boolean): void;
}

interface Press {
  pointer: number;
  start: Point;
  last: Point;
  taken: boolean;
  dragging: boolean;
  /** No click any more: it moved, or a second finger came. */
  spoilt: boolean;
}

export class Pointer {
  private current: Press | null = null;
  private space = false;
  private readonly abort = new AbortController();

  constructor(
    private readonly element: HTMLElement,
    private readonly handler: PointerHandler,
  ) {
    const { signal } = this.abort;
    const listen = <K extends keyof HTMLElementEventMap>(name: K, listener: (event: HTMLElementEventMap[K]) => void): void =>
      element.addEventListener(name, listener, { signal, capture: true });
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event));
    listen("pointercancel", (event) => this.lost(event));
    listen("lostpointercapture", (event) => this.lost(event));
    listen("pointerleave", (event) => {
      if (event.target === element) handler.hover(null);
    });
    listen("contextmenu", (event) => event.preventDefault());
    window.addEventListener("keydown", (event) => this.key(event), { signal, capture: true });
    window.addEventListener("keyup", (event) => this.key(event), { signal, capture: true });
    window.addEventListener("blur", () => this.setSpace(false), { signal });
  }

  dispose(): void {
    this.abort.abort();
  }

  private down(event: PointerEvent): void {
    if (this.current) {
      this.current.spoilt = true;
      return;
    }
    if (event.button !== 0 || this.space) return;
    const at = this.locate(event);
    const taken = this.handler.press(at, event.pointerType === "touch");
    this.current = { pointer: event.pointerId, start: at, last: at, taken, dragging: false, spoilt: false };
    if (!taken) return;
    this.handler.setCamera(false);
    this.element.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const at = this.locate(event);
    const press = this.current;
    if (!press) {
      if (event.pointerType !== "touch") this.handler.hover(at);
      return;
    }
    if (event.pointerId !== press.pointer) return;
    if (Math.hypot(at.x - press.start.x, at.y - press.start.y) > CLICK_PIXELS) press.spoilt = true;
    if (!press.taken) return;
    if (press.spoilt && !press.dragging) {
      press.dragging = true;
      this.handler.dragStart();
    }
    if (press.dragging) this.handler.drag(at.x - press.last.x, at.y - press.last.y, event.shiftKey);
    if (press.dragging) press.last = at; // until then the first pixels are kept, so that the dot stays under the hand
  }

  private up(event: PointerEvent): void {
    const press = this.current;
    if (!press || event.pointerId !== press.pointer) return;
    this.release();
    if (press.dragging) this.handler.dragEnd(false);
    else if (!press.spoilt) this.handler.click(this.locate(event), event.pointerType === "touch");
    this.handler.hover(event.pointerType === "touch" ? null : this.locate(event));
  }

  private lost(event: PointerEvent): void {
    const press = this.current;
    if (!press || event.pointerId !== press.pointer) return;
    this.release();
    if (press.dragging) this.handler.dragEnd(true);
  }

  private release(): void {
    const press = this.current;
    this.current = null;
    if (!press?.taken) return;
    if (this.element.hasPointerCapture(press.pointer)) this.element.releasePointerCapture(press.pointer);
    this.handler.setCamera(true);
  }

  private key(event: KeyboardEvent): void {
    if (event.key === "Escape" && event.type === "keydown" && this.current?.dragging) {
      event.stopPropagation();
      this.release();
      this.handler.dragEnd(true);
    }
    const keeps = "input, textarea, select, button, [contenteditable]"; // what Space means something else to
    const typing = event.composedPath().some((node) => node instanceof Element && node.matches(keeps));
    if (event.code === "Space" && (event.type === "keyup" || !typing)) this.setSpace(event.type === "keydown");
  }

  private setSpace(on: boolean): void {
    if (on === this.space) return;
    this.space = on;
    this.handler.setPanning(on);
  }

  private locate(event: MouseEvent): Point {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}
