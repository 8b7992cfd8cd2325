import { clipOf, removePin, setPin } from "../document/clips";
import { freeId } from "../document/commands";
import type { Pin } from "../document/types";
import { pinsWithin, pointsOfControls } from "../sync/prepare";
import type { Drag } from "./dragging";
import type { Session } from "./session";

/** Less is not worth a word: metres on the stage. */
const MISSED = 0.005;
const TITLE = "A pin is not kept.";

/** Pins: a point held at a place in one frame, or still for a moment. Unlike poses they teach nothing about other frames. */
export class Pins {
  /** The next drag makes a pin and no pose. */
  armed = false;
  /** The pin that is spoken of. */
  chosen: string | null = null;

  constructor(private readonly session: Session) {}

  get here(): readonly Pin[] {
    return clipOf(this.session.document).pins ?? [];
  }

  get chosenPin(): Pin | null {
    return this.here.find(({ id }) => id === this.chosen) ?? null;
  }

  arm(on: boolean): void {
    this.armed = on;
    this.session.emit("pins", undefined);
  }

  choose(id: string | null): void {
    this.chosen = id;
    const pin = this.chosenPin;
    if (pin) {
      this.session.player.pause();
      this.session.player.seek(pin.frame);
      this.session.select(pin.point);
    }
    this.session.emit("pins", undefined);
  }

  /** Pins what the hand holds; else the selected point where it is; else the next drag will. */
  key(): void {
    const { session } = this;
    if (session.drag) {
      this.armed = true;
      session.dragging.drop();
    } else if (session.selected && session.performance && !session.player.playing) this.holdSelected();
    else this.arm(!this.armed);
  }

  /** Pins the held point where the hand let it go. */
  keep({ id, frame, targets, wasPlaying }: Pick<Drag, "id" | "frame" | "targets" | "wasPlaying">): void {
    this.armed = false;
    this.session.holdShape(frame, wasPlaying);
    this.place(id, frame, targets);
  }

  setKind(pin: Pin, kind: Pin["kind"]): void {
    if (kind === "still" && pin.frame === 0) return;
    this.session.apply(setPin({ ...pin, kind }));
  }

  remove(id: string): void {
    const { session } = this;
    const pin = this.here.find((other) => other.id === id);
    if (!pin) return;
    session.apply(removePin(id));
    this.choose(null);
    session.notices.say({
      title: `The pin at frame ${pin.frame} is gone.`,
      text: "The dance goes on without it.",
      icon: "points",
      actions: [session.undoAction()],
    });
  }

  /** Says which pin the new dance cannot keep, by how much, and what stands against it; or takes that back. */
  check(): void {
    const { session } = this;
    const { performance, motion } = session;
    if (!performance || !motion) return;
    const pins = pinsWithin(clipOf(session.document), motion.frames);
    const { worst, against } = performance.missed;
    if (worst.length !== pins.length) return; // of an older document; the next dance is on its way
    const at = worst.reduce((most, miss, n) => (miss > (worst[most] ?? 0) ? n : most), 0);
    const pin = pins[at];
    if (!pin || (worst[at] ?? 0) < MISSED) {
      session.notices.dismissTitle(TITLE);
      return;
    }
    const other = pins[against[at] ?? -1];
    const miss = Math.max(1, Math.round(100 * (worst[at] ?? 0)));
    session.notices.say({
      title: TITLE,
      text: `${this.words(pin)} is missed by ${miss} cm. ${other ? `${this.words(other)} stands against it; they met half way.` : "The ground stands against it: the point stands or would sink there."}`,
      icon: "points",
      actions: [
        { label: "Show it", run: () => this.choose(pin.id) },
        { label: "Delete it", run: () => this.remove(pin.id) },
      ],
    });
  }

  /** "The pin of Left arm at frame 40" */
  words({ point, frame }: Pin): string {
    return `The pin of ${this.session.document.points.find(({ id }) => id === point)?.name ?? "a point"} at frame ${frame}`;
  }

  private holdSelected(): void {
    const { session } = this;
    const { performance, selected, document } = session;
    if (!performance || !selected) return;
    const { frame } = session.player;
    const size = 3 * document.points.length;
    this.place(selected, frame, performance.controls.slice(frame * size, (frame + 1) * size));
  }

  private place(point: string, frame: number, targets: Float32Array): void {
    const { session } = this;
    const { model, document } = session;
    if (!model) return;
    const position = pointsOfControls(model, document, targets)[point];
    if (!position) return;
    const id = freeId(this.here, "n");
    session.apply(setPin({ id, point, frame, kind: "place", position }));
    this.chosen = id;
    session.emit("pins", undefined);
  }
}
