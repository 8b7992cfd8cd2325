// Everything drawn over the picture: places dots, pair lines and tags by the camera, and finds what the pointer is at.

import { Vector3 } from "three";
import type { Point } from "./arc";
import type { CameraRig, Projected } from "./camera-rig";
import type { PointHand } from "./point-hand";
import { pointColour, type PointHit, type PlacedMark, PointOverlay } from "./point-overlay";
import type { Figures } from "./figures";
import { type PairLine, PairLines } from "./pair-lines";
import type { Scenery } from "./scenery";
import type { PointMark, StageLook } from "../stage/port";

const POINT_REACH = { mouse: 14, touch: 24, chasing: 40 };
const JOINT_REACH = { mouse: 22, touch: 32 };
/** Milliseconds between two looks at which dots the mesh hides. */
const OCCLUSION_PAUSE = 120;

export class Annotations {
  readonly overlay = new PointOverlay();
  readonly lines = new PairLines();
  mode: StageLook["mode"] = "pose";
  /** The dot that the live pair line starts from. */
  live: string | null = null;
  /** Where the pointer rests, if it is over the stage and up. */
  pointer: Point | null = null;
  /** Second line of the held dot's tag. */
  note = "";
  /** Something moved since it was last asked which dots are hidden. */
  occlusionStale = true;
  private points: readonly PointMark[] = [];
  private size = { width: 1, height: 1 };
  private occlusionTime = 0;
  private occlusionTimer = 0;
  private readonly world = new Vector3();
  private readonly direction = new Vector3();
  private readonly spot: Projected = { x: 0, y: 0, depth: 0 };

  /** `again`: asks for another update() soon. */
  constructor(
    private readonly scenery: Scenery,
    private readonly rig: CameraRig,
    private readonly figures: Figures,
    private readonly hand: PointHand,
    private readonly again: () => void,
  ) {}

  setPoints(points: readonly PointMark[], selected: string | null): void {
    this.points = points;
    this.overlay.setPoints(points, selected, (joint) => this.figures.jointLabel(joint));
    this.occlusionStale = true;
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
  }

  update(now: number): void {
    const { overlay, pointer } = this;
    for (const mark of overlay.marks) this.rig.project(this.markPosition(mark, this.world), mark.at);
    this.lookForHidden(now);
    if (pointer) overlay.setHover(this.pointAt(pointer, false)); // points move under it
    overlay.place();
    this.lines.setLines(this.pairLines());
    this.updateTag();
  }

  pointAt(at: Point, touch: boolean): PointHit | null {
    return this.overlay.nearest(at.x, at.y, touch ? POINT_REACH.touch : POINT_REACH.mouse);
  }

  /** The dot of the model that a hand at this place is after; a dot that dances is met with less care. */
  pointChased(at: Point): PointHit | null {
    const hit = this.mode === "pose" ? this.overlay.nearest(at.x, at.y, POINT_REACH.chasing) : null;
    return hit?.on === "model" ? hit : null;
  }

  jointAt(at: Point, touch: boolean): number {
    let best = -1;
    let least = touch ? JOINT_REACH.touch : JOINT_REACH.mouse;
    for (const joint of this.figures.mannequin?.plan.joints ?? []) {
      const { x, y, depth } = this.rig.project(this.figures.joint(joint, this.world), this.spot);
      const away = Math.hypot(x - at.x, y - at.y);
      if (depth > 0 && away < least) {
        best = joint;
        least = away;
      }
    }
    return best;
  }

  vertexAt(at: Point): number {
    const { camera } = this.rig;
    this.world.set((2 * at.x) / this.size.width - 1, 1 - (2 * at.y) / this.size.height, 0.5).unproject(camera);
    const direction = this.direction.subVectors(this.world, camera.position).normalize();
    return this.figures.picker?.vertexAt(this.world.copy(camera.position).sub(this.scenery.model.offset), direction) ?? -1;
  }

  /** Model world: on the surface, or where the hand asks it to be. */
  pointPosition(point: PointMark, out: Vector3): Vector3 {
    return point.id === this.hand.id ? out.copy(this.hand.target) : this.figures.vertex(point.vertex, out);
  }

  dispose(): void {
    clearTimeout(this.occlusionTimer);
  }

  /** Scene. */
  private markPosition(mark: PlacedMark, out: Vector3): Vector3 {
    if (mark.on === "human") return this.figures.joint(mark.point.joint, out);
    return this.pointPosition(mark.point, out).add(this.scenery.model.offset);
  }

  /** Rays cost a refit of the tree, so while things move they are cast a few times a second. */
  private lookForHidden(now: number): void {
    const { picker } = this.figures;
    if (!this.occlusionStale || !picker) return;
    if (now - this.occlusionTime < OCCLUSION_PAUSE) {
      this.occlusionTimer ||= window.setTimeout(() => {
        this.occlusionTimer = 0;
        this.again();
      }, OCCLUSION_PAUSE);
      return;
    }
    this.occlusionTime = now;
    this.occlusionStale = false;
    const eye = this.rig.camera.position.clone().sub(this.scenery.model.offset);
    for (const mark of this.overlay.marks) {
      if (mark.on === "human") continue;
      const distance = this.direction.subVectors(this.pointPosition(mark.point, this.world), eye).length();
      mark.behind = mark.id !== this.hand.id && picker.hides(eye, this.direction.divideScalar(distance), distance);
    }
  }

  private pairLines(): PairLine[] {
    const hovered = this.overlay.hoveredPair();
    const lines: PairLine[] = [];
    for (const point of this.points) {
      if (this.mode !== "points" && point.id !== hovered) continue;
      const from = this.overlay.find(point.id, "human");
      const to = this.overlay.find(point.id, "model");
      if (!from || !to || from.button.hidden || to.button.hidden) continue;
      lines.push({ from: from.at, to: to.at, colour: pointColour(point.number), kind: "pair" });
    }
    const live = this.liveLine();
    return live ? [...lines, live] : lines;
  }

  private liveLine(): PairLine | null {
    const { live, pointer } = this;
    if (!live || !pointer) return null;
    const mark = this.overlay.find(live, "model");
    return mark && { from: mark.at, to: pointer, colour: pointColour(mark.point.number), kind: "live" };
  }

  private updateTag(): void {
    const { overlay, lines, pointer } = this;
    const mark = overlay.named();
    if (this.hand.holding && mark) {
      const start = this.rig.project(this.holdStart(mark.point, this.world).add(this.scenery.model.offset), this.spot);
      lines.setLead(start, mark.at);
      lines.setProbe(start);
      overlay.showTag(this.holdWords(mark.point), mark.at, 26);
      return;
    }
    lines.setLead(null, null);
    const candidate = pointer && this.mode === "points" && !overlay.isHovering() ? this.candidate(pointer) : null;
    lines.setProbe(candidate?.at ?? null);
    if (candidate?.words) overlay.showTag(candidate.words, candidate.at, 14);
    else overlay.showTag(mark?.point.name ?? null, mark?.at ?? null, mark?.on === "human" ? 18 : 24);
  }

  /** Model world: where the lead starts, on the ghost if one shows, else where the hand took the dot. */
  private holdStart(point: PointMark, out: Vector3): Vector3 {
    return this.figures.ghostVertex(point.vertex, out) ?? out.copy(this.hand.origin);
  }

  /** "Top: 27 cm up, 31 cm right", as the camera sees it. */
  private holdWords(point: PointMark): string {
    const move = this.direction.subVectors(this.hand.target, this.holdStart(point, this.world));
    const matrix = this.rig.camera.matrixWorld;
    const part = (value: number, plus: string, minus: string): string | null => {
      const cm = Math.round(100 * Math.abs(value));
      return cm > 0 ? `${cm} cm ${value > 0 ? plus : minus}` : null;
    };
    const right = move.dot(this.world.setFromMatrixColumn(matrix, 0));
    const out = move.dot(this.world.setFromMatrixColumn(matrix, 2).setY(0).normalize());
    const words = [part(move.y, "up", "down"), part(right, "right", "left"), part(out, "out", "in")].filter(Boolean).slice(0, 2);
    return [words.length ? `${point.name}: ${words.join(", ")}` : point.name, this.note].filter(Boolean).join("\n");
  }

  /** What a click would pick while points are made: a joint, else a vertex. */
  private candidate(at: Point): { at: Projected; words: string | null } | null {
    const joint = this.jointAt(at, false);
    if (joint >= 0) {
      const spot = this.rig.project(this.figures.joint(joint, this.world), { ...this.spot });
      return { at: spot, words: this.figures.jointLabel(joint) };
    }
    const vertex = this.vertexAt(at);
    if (vertex < 0) return null;
    this.figures.vertex(vertex, this.world).add(this.scenery.model.offset);
    return { at: this.rig.project(this.world, { ...this.spot }), words: null };
  }
}
