import { EngineError } from "../engine/types";
import type { ShapedFrame } from "../engine/types";
import type { Shape } from "../stage/port";
import { mapsToWorld, toLocal, toWorld } from "../sync/placement";
import type { Root } from "../sync/placement";
import { pointPartners, restControls } from "../sync/point-controls";
import type { Context } from "./context";

export interface Drag {
  readonly id: string;
  readonly index: number;
  readonly frame: number;
  /** Where the model stands while it is held. */
  readonly root: Root;
  /** World: the shape that the hand took. */
  readonly before: Shape;
  /** World: what the hand made of it, once there is something. */
  shape: Shape | null;
  /** C x 3 body-local: as the dance has them, and as the hand asks. */
  readonly base: Float32Array;
  targets: Float32Array;
  /** World: where the dance has the point, and where the hand asks for it. */
  readonly from: readonly [number, number, number];
  to: readonly [number, number, number];
  readonly wasPlaying: boolean;
  /** The partner on the other side does the same. */
  mirrored: boolean;
  /** Volume over rest volume, once known. */
  volume: number | null;
}

/** What a drag leaves behind where it ends. */
export type Dropped = Pick<Drag, "id" | "frame" | "targets" | "wasPlaying">;

const KEYS_REST_MS = 700;
/** A hand that has rested so long sees what the dance would show for the same targets... */
const SETTLE_MS = 120;
/** ...to which the shape goes in steps of a picture each. */
const EASE_STEPS = 8;
const EASE_STEP_MS = 16;

/** The hand on a dot: from the grab to the drop, or back. */
export class Dragging {
  active: Drag | null = null;
  private first = true;
  private asking = false;
  private again = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private settling: ReturnType<typeof setTimeout> | undefined;

  /** `take`: what becomes of what was dropped. */
  constructor(
    private readonly context: Context,
    private readonly take: (dropped: Dropped) => void,
  ) {
    context.signals.on("travel", () => this.cancel());
  }

  grab(id: string): void {
    const { document, performance, player, workspace, selection, signals } = this.context;
    if (this.active) this.cancel();
    const index = document.points.findIndex((point) => point.id === id);
    const { frame } = player;
    const shown = workspace.cache.at(frame);
    const base = this.context.controlsAt(frame);
    if (!performance || !shown || !base || index < 0) return;
    const wasPlaying = player.playing;
    const { root } = shown;
    const from = position({ index, root }, base);
    player.pause();
    workspace.hold();
    this.active = {
      id,
      index,
      frame,
      root,
      before: shown.shape,
      shape: null,
      base,
      targets: base.slice(),
      from,
      to: from,
      wasPlaying,
      mirrored: false,
      volume: null,
    };
    this.first = true;
    selection.endIntro();
    selection.select(id);
    signals.tell("drag");
  }

  /** The hand asks for a world position. */
  move(position: readonly [number, number, number]): void {
    const { active } = this;
    if (!active) return;
    active.to = position;
    active.targets = active.base.slice();
    active.targets.set(toLocal(position, active.root), 3 * active.index);
    if (active.mirrored) this.moveTwin(active);
    this.ask();
    this.context.signals.tell("drag");
  }

  /** While a dot is held: its partner on the other side does the same, or does not. */
  mirror(): void {
    const { active } = this;
    if (!active) return;
    active.mirrored = !active.mirrored;
    this.move(active.to);
  }

  /** The partner goes from its rest as the held point does, the other way sideways. */
  private moveTwin({ index, targets }: Drag): void {
    const { model, document } = this.context;
    const twin = pointPartners(document.points)?.[index] ?? -1;
    if (!model || twin < 0) return;
    const rest = restControls(model, document);
    const at = 3 * index;
    const to = 3 * twin;
    const [x, y, z] = [0, 1, 2].map((k) => targets[at + k] - rest[at + k]);
    targets.set(twin === index ? [rest[at]] : [rest[to] - x, rest[to + 1] + y, rest[to + 2] + z], to);
  }

  /** Arrow keys on a point of the list: 1 cm, with Shift 2 mm. Answers whether the key was one. */
  nudge(id: string, key: string, fine: boolean): boolean {
    const by = fine ? 0.002 : 0.01;
    const ways: Readonly<Record<string, readonly [number, number, number]>> = {
      ArrowLeft: [-by, 0, 0],
      ArrowRight: [by, 0, 0],
      ArrowUp: [0, by, 0],
      ArrowDown: [0, -by, 0],
    };
    const way = ways[key];
    if (!way) return false;
    this.moveBy(id, way);
    return true;
  }

  /** Takes a point by the keyboard and moves it by stage metres; it drops by itself when the keys rest. */
  private moveBy(id: string, delta: readonly [number, number, number]): void {
    if (this.active?.id !== id) this.grab(id);
    const { active } = this;
    if (!active) return;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.drop(), KEYS_REST_MS);
    const [x, y, z] = active.to;
    this.move([x + delta[0], y + delta[1], z + delta[2]]);
  }

  drop(): void {
    const { active } = this;
    if (!active) return;
    const { from, to } = active;
    if (Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]) <= 1e-4) {
      this.cancel();
      return;
    }
    this.end();
    this.take(active);
    this.context.workspace.release();
  }

  cancel(): void {
    const { active } = this;
    if (!active) return;
    const { workspace, player, signals } = this.context;
    this.end();
    workspace.release();
    signals.tell("frame");
    if (active.wasPlaying) player.play();
  }

  private end(): void {
    clearTimeout(this.rest);
    clearTimeout(this.settling);
    this.active = null;
    this.context.signals.tell("drag");
  }

  /** One question at a time; the newest targets win. */
  private ask(): void {
    const { active } = this;
    if (!active) return;
    if (this.asking) {
      this.again = true;
      return;
    }
    this.asking = true;
    clearTimeout(this.settling);
    const restart = this.first;
    this.first = false;
    const { targets } = active;
    const { workspace } = this.context;
    workspace
      .drag(targets, restart, workspace.turnsAt(active.frame))
      .then(
        (frame) => {
          this.show(active, frame);
          if (!restart) this.settling = setTimeout(() => void this.settle(active, targets), SETTLE_MS);
        },
        (error: unknown) => {
          if (error instanceof EngineError && error.code === "superseded") return;
          if (this.active === active) this.cancel();
          if (error instanceof EngineError && error.code === "engine_lost") void workspace.sync();
        },
      )
      .finally(() => {
        this.asking = false;
        if (this.again && this.active) {
          this.again = false;
          this.ask();
        }
      });
  }

  private show(drag: Drag, frame: ShapedFrame): void {
    if (this.active !== drag) return;
    drag.volume = frame.volumeRatio;
    drag.shape = this.place(drag, frame);
    this.context.meter.add(frame.milliseconds);
    this.context.signals.tell("drag");
  }

  private place(drag: Drag, frame: ShapedFrame): Shape {
    const place = this.context.workspace.report?.solid ? mapsToWorld : toWorld;
    return place(frame.shape, drag.root);
  }

  /** A drag goes on from the drag before; the dance makes each frame from rest. Under a hand that rests the one becomes the other. */
  private async settle(drag: Drag, targets: Float32Array): Promise<void> {
    const here = (): boolean => this.active === drag && drag.targets === targets && !this.asking;
    if (!here()) return;
    try {
      const { workspace } = this.context;
      const frame = await workspace.drag(targets, true, workspace.turnsAt(drag.frame));
      const from = drag.shape;
      if (!from || !here()) return;
      drag.volume = frame.volumeRatio;
      this.ease(drag, from, this.place(drag, frame), 1, here);
    } catch (error) {
      if (!(error instanceof EngineError)) throw error; // the next move asks again
    }
  }

  private ease(drag: Drag, from: Shape, to: Shape, step: number, here: () => boolean): void {
    if (!here()) return;
    const t = step / EASE_STEPS;
    drag.shape = step === EASE_STEPS ? to : from.map((value, i) => value + t * (to[i] - value));
    this.context.signals.tell("drag");
    if (step < EASE_STEPS) this.settling = setTimeout(() => this.ease(drag, from, to, step + 1, here), EASE_STEP_MS);
  }
}

/** Where a track has the held point, in the world. */
function position({ index, root }: Pick<Drag, "index" | "root">, track: Float32Array): [number, number, number] {
  const [x, y, z] = toWorld(track.subarray(3 * index, 3 * index + 3), root);
  return [x, y, z];
}
