import { saidOf } from "../document/clips";
import { newDocument } from "../document/commands";
import type { ProjectDocument } from "../document/types";
import type { Motion, Performance } from "../engine/types";
import type { SolverModel } from "../sync/placement";
import { meshInput } from "../sync/translate";
import { Workspace } from "../sync/workspace";
import { carryVertices } from "../util/solid-cells";
import { History } from "./history";
import { Meter } from "./meter";
import { Notices } from "./notices";
import { Player } from "./player";
import type { Ports } from "./ports";
import { Selection } from "./selection";
import { Signals } from "./signals";

const EMPTY = newDocument("Untitled", { file: "", facing: "+z", up: "+y" }, { files: [] });

/** What the parts of the app share: the document and its engine, the playhead, the selection, what is said and what has changed. */
export class Context {
  readonly signals = new Signals();
  readonly notices = new Notices();
  readonly history = new History(EMPTY, this.notices, this.signals);
  readonly selection = new Selection(this.signals);
  readonly meter = new Meter(() => this.signals.tell("meter"));
  readonly player: Player;
  readonly workspace: Workspace;
  solving = false;

  constructor({ clock, createEngine }: Pick<Ports, "clock" | "createEngine">) {
    const { signals, selection, meter } = this;
    this.player = new Player(clock);
    this.workspace = new Workspace(() => this.document, createEngine);
    signals.on("document", () => {
      selection.follow(this.document);
      const { speed = 1, loop = false } = saidOf(this.document);
      Object.assign(this.player, { pace: speed, closed: loop });
      void this.workspace.sync();
    });
    this.notices.on("change", () => signals.tell("notices"));
    this.player.on("frame", () => signals.tell("frame"));
    this.player.on("state", () => signals.tell("play"));
    const solved = (): void => signals.tell("solve");
    this.workspace.on("mesh", solved);
    this.workspace.on("motion", solved);
    this.workspace.on("performance", (performance) => {
      if (performance) meter.add(performance.milliseconds);
      solved();
    });
    this.workspace.on("busy", (busy) => {
      this.solving = busy;
      solved();
    });
  }

  get document(): ProjectDocument {
    return this.history.document;
  }
  get motion(): Motion | null {
    return this.workspace.motion;
  }
  get model(): SolverModel | undefined {
    return this.workspace.library.model(this.document.mesh.file);
  }
  get motionName(): string {
    return this.document.motion.files.at(-1) ?? "";
  }

  /** The dance, unless points came or went since it was solved. */
  get performance(): Performance | null {
    const { performance } = this.workspace;
    return performance && performance.controls.length === 3 * performance.frames * this.document.points.length ? performance : null;
  }

  /** V x 3 world: where the dance has the model's vertices at a frame; a copy. */
  verticesAt(frame: number): Float32Array | null {
    const { workspace, model, document } = this;
    const shape = workspace.cache.at(frame)?.shape;
    const solid = workspace.report?.solid;
    if (!shape || !model) return null;
    if (!solid) return shape.slice();
    const rest = meshInput(model, document.mesh).positions;
    const out = new Float32Array(rest.length);
    carryVertices(solid, rest, shape, Uint32Array.from(solid.elementOf.keys()), out);
    return out;
  }

  /** C x 3 body-local: where the dance has the points at a frame; a copy. */
  controlsAt(frame: number): Float32Array | null {
    const size = 3 * this.document.points.length;
    return this.performance?.controls.slice(frame * size, (frame + 1) * size) ?? null;
  }
}
