import { EngineError } from "../engine/types";
import type { Frame } from "../engine/types";
import { pointPartners, restControls } from "../sync/prepare";
import { toLocal, toWorld } from "../sync/placement";
import type { Root } from "../sync/placement";
import type { Session } from "./session";

export interface Drag {
  id: string;
  index: number;
  frame: number;
  /** Where the model stands while it is held. */
  root: Root;
  /** C x 3 body-local: as the dance has them, and as the hand asks. */
  base: Float32Array;
  targets: Float32Array;
  wasPlaying: boolean;
  /** The partner on the other side does the same. */
  mirrored: boolean;
  /** Volume over rest volume, once known. */
  volume: number | null;
}

const KEYS_REST_MS = 700;

/** The hand on a dot: from the grab to a pose, or back. */
export class Dragging {
  active: Drag | null = null;
  private first = true;
  private asking = false;
  private again = false;
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly session: Session) {}

  grab(id: string): void {
    const { session } = this;
    if (this.active) this.cancel();
    const { performance } = session;
    const index = session.document.points.findIndex((point) => point.id === id);
    const frame = session.player.frame;
    const shown = session.workspace.cache.at(frame);
    if (!performance || !shown || index < 0) return;
    const controls = session.document.points.length;
    const base = performance.controls.slice(frame * controls * 3, (frame + 1) * controls * 3);
    const wasPlaying = session.player.playing;
    session.player.pause();
    session.workspace.hold();
    this.active = { id, index, frame, root: shown.root, base, targets: base.slice(), wasPlaying, mirrored: false, volume: null };
    this.first = true;
    session.viewport?.setGhost(shown.positions);
    session.endIntro();
    session.select(id);
    session.emit("drag", undefined);
  }

  /** The hand asks for a world position. */
  move(position: readonly [number, number, number]): void {
    const { active } = this;
    if (!active) return;
    active.targets = active.base.slice();
    active.targets.set(toLocal(position, active.root), 3 * active.index);
    if (active.mirrored) this.moveTwin(active);
    this.ask();
    this.session.emit("drag", undefined);
  }

  /** While a dot is held: its partner on the other side does the same, or does not. */
  mirror(): void {
    const { active } = this;
    if (!active) return;
    active.mirrored = !active.mirrored;
    this.move(toWorld(active.targets.subarray(3 * active.index, 3 * active.index + 3), active.root) as unknown as [number, number, number]);
  }

  /** The partner goes from its rest as the held point does, the other way sideways. */
  private moveTwin({ index, targets }: Drag): void {
    const { model, document } = this.session;
    const twin = pointPartners(document.points)?.[index] ?? -1;
    if (!model || twin < 0) return;
    const rest = restControls(model, document);
    const at = 3 * index;
    const to = 3 * twin;
    const [x, y, z] = [0, 1, 2].map((k) => targets[at + k] - rest[at + k]);
    targets.set(twin === index ? [rest[at]] : [rest[to] - x, rest[to + 1] + y, rest[to + 2] + z], to);
  }

  /** Arrow keys on a point of the list: 1 cm, with Shift 2 mm. */
  key(id: string, event: KeyboardEvent): void {
    const by = event.shiftKey ? 0.002 : 0.01;
    const ways: Readonly<Record<string, readonly [number, number, number]>> = {
      ArrowLeft: [-by, 0, 0],
      ArrowRight: [by, 0, 0],
      ArrowUp: [0, by, 0],
      ArrowDown: [0, -by, 0],
    };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    this.nudge(id, way);
  }

  /** Takes a point by the keyboard and moves it by stage metres; it drops by itself when the keys rest. */
  private nudge(id: string, delta: readonly [number, number, number]): void {
    if (this.active?.id !== id) this.grab(id);
    const { active } = this;
    if (!active) return;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.drop(), KEYS_REST_MS);
    const world = toWorld(active.targets.subarray(3 * active.index, 3 * active.index + 3), active.root);
    this.move([world[0] + delta[0], world[1] + delta[1], world[2] + delta[2]]);
  }

  /** How far the held point went, stage metres in the world's axes. */
  delta(): [number, number, number] {
    const { active } = this;
    if (!active) return [0, 0, 0];
    const at = 3 * active.index;
    const [a, b] = [active.base, active.targets].map((track) => toWorld(track.subarray(at, at + 3), active.root));
    return [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  }

  drop(): void {
    const { active, session } = this;
    if (!active) return;
    const moved = Math.hypot(...this.delta()) > 1e-4;
    if (!moved) {
      this.cancel();
      return;
    }
    this.end();
    if (session.pins.armed) session.pins.keep(active);
    else session.poses.keep(active);
    session.workspace.release();
  }

  cancel(): void {
    const { active, session } = this;
    if (!active) return;
    this.end();
    session.workspace.release();
    session.showFrame();
    if (active.wasPlaying) session.player.play();
  }

  private end(): void {
    clearTimeout(this.rest);
    this.active = null;
    this.session.viewport?.setGhost(null);
    this.session.viewport?.setNote("");
    this.session.emit("drag", undefined);
  }

  /** One question at a time; the newest targets win. */
  private ask(): void {
    const { active, session } = this;
    if (!active) return;
    if (this.asking) {
      this.again = true;
      return;
    }
    this.asking = true;
    const restart = this.first;
    this.first = false;
    session.workspace
      .drag(active.targets, restart)
      .then(
        (frame) => this.show(active, frame),
        (error: unknown) => {
          if (error instanceof EngineError && error.code === "superseded") return;
          if (this.active === active) this.cancel();
          if (error instanceof EngineError && error.code === "engine_lost") void session.workspace.sync();
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

  private show(drag: Drag, frame: Frame): void {
    if (this.active !== drag) return;
    drag.volume = frame.volumeRatio;
    if (frame.volumeRatio !== null) this.session.viewport?.setNote(`Volume ${Math.round(100 * frame.volumeRatio)} %`);
    this.session.meter.add(frame.milliseconds);
    this.session.viewport?.setVertices(toWorld(frame.positions, drag.root));
    this.session.emit("drag", undefined);
  }
}
