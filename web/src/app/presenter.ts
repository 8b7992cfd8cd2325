import type { Insets, PointMark, Shape, StagePort, StageView } from "../stage/port";
import { describeJoints } from "../skeleton/pair-joints";
import { pointJoints } from "../sync/pairing";
import { pointPartners, pointVertices } from "../sync/point-controls";
import { restMaps } from "../util/solid-cells";
import type { SolverModel } from "../sync/placement";
import type { Context } from "./context";
import type { Coverage } from "./coverage";
import type { Drag, Dragging } from "./dragging";
import { drawnModel } from "./drawn-model";
import type { Guesses } from "./guesses";
import type { MotionEditing } from "./motion-editing";
import type { Pairing } from "./pairing";
import type { Sources } from "./sources";

/** Whose state is shown on the stage. */
export interface Shown {
  readonly sources: Sources;
  readonly dragging: Dragging;
  readonly guesses: Guesses;
  readonly pairing: Pairing;
  readonly coverage: Coverage;
  readonly editing: MotionEditing | null;
}

/** Puts what is now on the stage: the model, the human, the dots and the frame. Nobody else tells the stage anything. */
export class Presenter {
  stage: StagePort | null = null;
  /** The hand's shape stays at this frame until the new dance has one of its own. */
  private frozen: number | null = null;
  /** What shows while there is no dance. */
  private rest: Shape | null = null;
  private drag: Drag | null = null;
  private dragShape: Shape | null = null;

  constructor(
    private readonly context: Context,
    private readonly shown: Shown,
  ) {
    const { signals, workspace, player } = context;
    signals.on("document", () => this.points());
    signals.on("selection", () => this.points());
    signals.on("suggestions", () => this.points());
    signals.on("panel", () => {
      this.look();
      this.points();
    });
    signals.on("layout", () => this.look());
    signals.on("pairing", () => this.look());
    signals.on("coverage", () => this.look());
    signals.on("intro", () => this.pulse());
    signals.on("frame", () => this.frame());
    signals.on("drag", () => this.hand());
    signals.on("freeze", ({ frame }) => {
      this.frozen = frame;
    });
    player.on("again", () => this.stage?.beginAgain());
    workspace.on("mesh", () => this.model());
    workspace.on("motion", () => this.human());
    workspace.on("performance", () => this.frame());
    workspace.on("frame", (frame) => {
      if (frame === player.frame) this.frame();
    });
  }

  /** A stage to show everything on, from now on. */
  attach(stage: StagePort): void {
    this.stage = stage;
    this.look();
    this.everything();
    this.pulse();
    this.context.signals.tell("stage");
  }

  get hasStage(): boolean {
    return this.stage !== null;
  }

  everything(): void {
    this.model();
    this.human();
  }

  /** Where cards float over the stage. */
  setInsets(insets: Insets): void {
    this.stage?.setInsets(insets);
  }

  /** Moves the camera to where it sees all. */
  fit(view?: StageView): void {
    this.stage?.fit(view);
  }

  /** A small picture of a shape; "" without a stage. */
  thumbnail(shape: Shape, size: number): string {
    return this.stage?.thumbnail(shape, size) ?? "";
  }

  close(): void {
    this.stage?.dispose();
    this.stage = null;
  }

  private model(): void {
    const { stage } = this;
    const { model, document, workspace } = this.context;
    const source = model && this.shown.sources.of(model);
    if (!stage || !source) return;
    const solid = workspace.model === model ? (workspace.report?.solid ?? null) : null;
    const drawn = drawnModel(source.model, document.mesh, solid);
    const seen = stage.setModel(drawn);
    const rest = solid ? restMaps(solid) : drawn.rest;
    this.rest = rest;
    void seen.then(() => {
      if (this.rest === rest) this.context.signals.emit("staged", rest);
    });
    this.points();
    this.frame();
  }

  private human(): void {
    const { motion } = this.context;
    if (!motion) return;
    this.stage?.setHuman({ joints: describeJoints(motion.joints), parents: Int32Array.from(motion.joints, (joint) => joint.parent) });
    this.points();
    this.frame();
  }

  private points(): void {
    const { model, motion, document, selection, workspace } = this.context;
    if (!this.stage || !model || workspace.model !== model) return; // the engine is not there yet; model() comes back
    const vertices = pointVertices(model, document.points);
    const pairs = motion && pointJoints(document, motion);
    const partners = pointPartners(document.points);
    const twin = partners?.[document.points.findIndex(({ id }) => id === selection.point)] ?? -1;
    const marks = document.points.map(
      ({ id, name }, k): PointMark => ({
        id,
        number: k + 1,
        name,
        vertex: vertices[k],
        joint: pairs?.[k] ?? -1,
        twin: k === twin && id !== selection.point,
      }),
    );
    this.stage.setPoints([...marks, ...this.suggestions(model)], selection.point);
  }

  /** Where the model may be held as well. */
  private suggestions(model: SolverModel): PointMark[] {
    if (this.context.selection.panel !== "points") return [];
    const { guesses } = this.shown;
    const { suggested } = guesses;
    const vertices = pointVertices(model, suggested);
    return suggested.map(
      (point, k): PointMark => ({
        id: guesses.markOf(point),
        number: 1,
        name: point.name,
        vertex: vertices[k],
        joint: -1,
        suggested: true,
      }),
    );
  }

  private look(): void {
    const { panel, layout, turning } = this.context.selection;
    const { pairing, coverage, editing } = this.shown;
    this.stage?.setLook({
      mode: panel === "points" || editing?.waiting ? "points" : "pose",
      layout,
      turning,
      livePair: pairing.waiting,
      asking: coverage.asking !== null,
    });
  }

  private pulse(): void {
    const { selection, document } = this.context;
    this.stage?.setLook({ pulse: selection.intro ? (document.points[0]?.id ?? null) : null });
  }

  /** What the hand holds, over a ghost of what it took. */
  private hand(): void {
    const drag = this.shown.dragging.active;
    if (drag !== this.drag) {
      this.drag = drag;
      this.dragShape = null;
      this.stage?.setLook({ ghost: drag?.before ?? null, note: "" });
    }
    if (!drag?.shape || drag.shape === this.dragShape) return;
    this.dragShape = drag.shape;
    this.stage?.setShape(drag.shape);
    if (drag.volume !== null) this.stage?.setLook({ note: `Volume ${Math.round(100 * drag.volume)} %` });
  }

  private frame(): void {
    const { stage } = this;
    const { player, workspace, motion } = this.context;
    if (!stage) return;
    const at = player.frame;
    if (motion) stage.setHumanPose(this.humanPose(at));
    if (this.shown.dragging.active) return;
    if (this.frozen !== null && this.frozen === at && !workspace.cache.isFresh(at)) return;
    this.frozen = null;
    const frame = workspace.cache.at(at) ?? workspace.cache.nearest(at);
    if (frame) stage.setShape(frame.shape);
    else if (this.rest) stage.setShape(this.rest);
  }

  /** J x 3 world; on the spot if the model is. */
  humanPose(frame: number): Float32Array {
    const { motion, document } = this.context;
    if (!motion) return new Float32Array(0);
    const size = 3 * motion.joints.length;
    const pose = motion.positions.subarray(frame * size, (frame + 1) * size);
    if (!document.settings.inPlace) return pose;
    const [x, , z] = pose;
    return pose.map((value, k) => (k % 3 === 0 ? value - x : k % 3 === 2 ? value - z : value));
  }
}
