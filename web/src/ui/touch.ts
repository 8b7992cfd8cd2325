// Fingers on the stage: two that tap undo, three redo. One that rests on a dot shows its settings, and while a dot is held a
// second one that taps mirrors it.

import type { Session } from "../app/session";

const TAP_MS = 300;
const REST_MS = 500;
const STILL_PIXELS = 12;

interface Finger {
  x: number;
  y: number;
  since: number;
  /** The dot of the model that it came down on. */
  dot: string | null;
  still: boolean;
}

export function listenToFingers(stage: HTMLElement, { actions, dragging, selection }: Session): void {
  const down = new Map<number, Finger>();
  let gesture: Finger[] = [];

  const ended = (at: number): void => {
    const [first] = gesture;
    const count = gesture.length;
    const took = at - (first?.since ?? 0);
    const still = gesture.every((finger) => finger.still);
    gesture = [];
    if (!first || !still) return;
    const tap = [null, null, actions.undo, actions.redo][count];
    if (took < TAP_MS && tap?.enabled()) tap.run();
    const { dot } = first;
    if (count > 1 || took < REST_MS || dot === null) return;
    setTimeout(() => {
      selection.select(dot); // after the click has had its turn
      selection.setPanel("points");
    });
  };

  stage.addEventListener("pointerdown", (event) => {
    if (event.pointerType !== "touch") return;
    const dot = event.composedPath().find((node): node is HTMLElement => node instanceof HTMLElement && node.matches(".point.model"));
    const finger = { x: event.clientX, y: event.clientY, since: event.timeStamp, dot: dot?.dataset["point"] ?? null, still: true };
    down.set(event.pointerId, finger);
    gesture.push(finger);
  });
  addEventListener("pointermove", (event) => {
    const finger = down.get(event.pointerId);
    if (finger && Math.hypot(event.clientX - finger.x, event.clientY - finger.y) > STILL_PIXELS) finger.still = false;
  });
  const up = (event: PointerEvent): void => {
    const finger = down.get(event.pointerId);
    if (!finger) return;
    down.delete(event.pointerId);
    if (event.type === "pointercancel") finger.still = false;
    const tapped = finger.still && event.timeStamp - finger.since < TAP_MS;
    if (down.size > 0 && tapped && dragging.active) dragging.mirror();
    if (down.size === 0) ended(event.timeStamp);
  };
  addEventListener("pointerup", up, { capture: true });
  addEventListener("pointercancel", up, { capture: true });
}
