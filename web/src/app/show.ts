import { toStage } from "../document/stage";
import type { Model } from "../io/model";
import { describeJoints } from "../skeleton/pair-joints";
import { pointJoints } from "../sync/pairing";
import { meshInput, pointPartners, pointVertices, stageFor } from "../sync/prepare";
import type { SolverModel } from "../sync/prepare";
import type { PointMark } from "../viewport/types";
import type { Session } from "./session";

/** Puts what is now on the stage: the model, the human, the dots and the frame. */
export class Show {
  private pinned: number | null = null;
  /** V x 3, stage: what shows while there is no dance. */
  private rest: Float32Array | null = null;

  constructor(private readonly session: Session) {}

  /** Keeps the hand's shape at this frame until the new dance has one of its own. */
  pin(frame: number): void {
    this.pinned = frame;
  }

  model(): void {
    const { session } = this;
    const { viewport } = session;
    const model = session.model as Model | undefined;
    if (!viewport || !model) return;
    const { mesh } = session.document;
    const { drawn } = model;
    viewport.setModel({
      positions: toStage(stageFor(model, mesh), drawn.positions),
      index: drawn.index,
      toVertex: drawn.toVertex,
      faces: model.faces,
      colors: drawn.colors,
      uvs: drawn.uvs,
      texture: session.sources.texture(model),
    });
    this.rest = meshInput(model, mesh).positions;
    session.thumbnails.reset(this.rest);
    this.points();
    this.frame();
  }

  human(): void {
    const { motion, viewport, player } = this.session;
    if (!motion) return;
    viewport?.setHuman({ joints: describeJoints(motion.joints), parents: Int32Array.from(motion.joints, (joint) => joint.parent) });
    player.setFrames(motion.frames);
    this.points();
    this.frame();
  }

  performance(): void {
    const { performance, player, motion } = this.session;
    player.setFrames(performance?.frames ?? motion?.frames ?? 0);
    this.frame();
  }

  everything(): void {
    this.model();
    this.human();
  }

  points(): void {
    const { session } = this;
    const { model, motion, document } = session;
    if (!model || session.workspace.model !== model) return; // the engine is not there yet; model() comes back
    const vertices = pointVertices(model, document.points);
    const pairs = motion && pointJoints(document, motion);
    const partners = pointPartners(document.points);
    const twin = partners?.[document.points.findIndex(({ id }) => id === session.selected)] ?? -1;
    const marks = document.points.map(
      ({ id, name }, k): PointMark => ({
        id,
        number: k + 1,
        name,
        vertex: vertices[k],
        joint: pairs?.[k] ?? -1,
        twin: k === twin && id !== session.selected,
      }),
    );
    session.viewport?.setPoints([...marks, ...this.offers(model)], session.selected);
  }

  /** Places where the model may be held as well. */
  private offers(model: SolverModel): PointMark[] {
    const { session } = this;
    if (session.panel !== "points") return [];
    const { places } = session.guesses;
    const vertices = pointVertices(model, places);
    return places.map(
      ({ id, name }, k): PointMark => ({ id: session.guesses.offerId(id), number: 1, name, vertex: vertices[k], joint: -1, offered: true }),
    );
  }

  frame(): void {
    const { session } = this;
    const { viewport, player, workspace, motion } = session;
    if (!viewport) return;
    const at = player.frame;
    if (motion) viewport.setHumanPose(this.humanPose(at));
    if (session.drag) return;
    if (this.pinned !== null && this.pinned === at && !workspace.cache.isFresh(at)) return;
    this.pinned = null;
    const frame = workspace.cache.at(at) ?? workspace.cache.nearest(at);
    if (frame) viewport.setVertices(frame.positions);
    else if (this.rest) viewport.setVertices(this.rest);
  }

  /** J x 3 world; on the spot if the model is. */
  private humanPose(frame: number): Float32Array {
    const { motion, document } = this.session;
    if (!motion) return new Float32Array(0);
    const size = 3 * motion.joints.length;
    const pose = motion.positions.subarray(frame * size, (frame + 1) * size);
    if (!document.settings.inPlace) return pose;
    const [x, , z] = pose;
    return pose.map((value, k) => (k % 3 === 0 ? value - x : k % 3 === 2 ? value - z : value));
  }
}
