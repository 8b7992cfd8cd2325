import { clipOf, pinFault, removePin, setPin } from "../document/clips";
import { freeId } from "../document/commands";
import type { Pin } from "../document/types";
import { pointsOfControls } from "../sync/point-controls";
import type { Context } from "./context";
import type { Dragging, Dropped } from "./dragging";

export type { Pin } from "../document/types";

const TITLE = "A pin is not kept.";

/** Pins: a point held at a place in one frame, or still for a moment. Unlike poses they teach nothing about other frames. */
export class Pins {
  /** The next drag makes a pin and no pose. */
  armed = false;
  /** The pin that is spoken of. */
  chosen: string | null = null;

  constructor(
    private readonly context: Context,
    private readonly dragging: Dragging,
  ) {
    context.workspace.on("performance", () => void this.check());
  }

  get here(): readonly Pin[] {
    return clipOf(this.context.document).pins ?? [];
  }

  get chosenPin(): Pin | null {
    return this.here.find(({ id }) => id === this.chosen) ?? null;
  }

  arm(on: boolean): void {
    this.armed = on;
    this.context.signals.tell("pins");
  }

  choose(id: string | null): void {
    const { player, selection, signals } = this.context;
    this.chosen = id;
    const pin = this.chosenPin;
    if (pin) {
      player.pause();
      player.seek(pin.frame);
      selection.select(pin.point);
    }
    signals.tell("pins");
  }

  /** Pins what the hand holds; else the selected point where it is; else the next drag will. */
  add(): void {
    const { selection, performance, player } = this.context;
    if (this.dragging.active) {
      this.armed = true;
      this.dragging.drop();
    } else if (selection.point && performance && !player.playing) this.addSelected(selection.point);
    else this.arm(!this.armed);
  }

  /** Pins the point that the hand dropped where it let it go. */
  take({ id, frame, targets, wasPlaying }: Dropped): void {
    this.armed = false;
    this.context.signals.emit("freeze", { frame, playOn: wasPlaying });
    this.make(id, frame, targets);
  }

  canBe(pin: Pin, kind: Pin["kind"]): boolean {
    return pinFault(this.as(pin, kind)) === null;
  }

  setKind(pin: Pin, kind: Pin["kind"]): void {
    if (this.canBe(pin, kind)) this.context.history.apply(setPin(this.as(pin, kind)));
  }

  /** The same pin, with something else said. */
  change(pin: Pin): void {
    this.context.history.apply(setPin(pin));
  }

  remove(id: string): void {
    const { history, notices } = this.context;
    const pin = this.here.find((other) => other.id === id);
    if (!pin) return;
    history.apply(removePin(id));
    this.choose(null);
    notices.say({
      title: `The pin at frame ${pin.frame} is gone.`,
      text: "The dance goes on without it.",
      icon: "points",
      actions: [history.undoAction()],
    });
  }

  /** Says which pin the new dance cannot keep, by how much, and what stands against it; or takes that back. */
  private async check(): Promise<void> {
    const { performance, document, notices } = this.context;
    if (this.here.length === 0) return notices.dismissTitle(TITLE);
    const { missedPins } = await import("../sync/missed-pins");
    if (performance !== this.context.performance) return;
    const missed = performance && missedPins(document, performance);
    if (!missed) return; // of an older document; the next dance is on its way
    const [worst] = missed;
    if (!worst) {
      notices.dismissTitle(TITLE);
      return;
    }
    const { pin, words } = worst;
    notices.say({
      title: TITLE,
      text: words,
      icon: "points",
      actions: [
        { label: "Show it", run: () => this.choose(pin.id) },
        { label: "Delete it", run: () => this.remove(pin.id) },
      ],
    });
  }

  private as(pin: Pin, kind: Pin["kind"]): Pin {
    const { points } = this.context.document;
    if (kind === "moves") return { velocity: [0, 0, 0], ...pin, kind };
    if (kind !== "level" || pin.other) return { ...pin, kind };
    const partner = points.find(({ id }) => id === pin.point)?.mirror;
    const others = points.filter(({ id }) => id !== pin.point);
    const other = (others.find(({ id }) => id === partner) ?? others[0])?.id;
    return other ? { ...pin, kind, other } : { ...pin, kind };
  }

  private addSelected(point: string): void {
    const { frame } = this.context.player;
    const controls = this.context.controlsAt(frame);
    if (controls) this.make(point, frame, controls);
  }

  private make(point: string, frame: number, controls: Float32Array): void {
    const { model, document, history, signals } = this.context;
    if (!model) return;
    const position = pointsOfControls(model, document, controls)[point];
    if (!position) return;
    const id = freeId(this.here, "n");
    history.apply(setPin({ id, point, frame, kind: "place", position }));
    this.chosen = id;
    signals.tell("pins");
  }
}
