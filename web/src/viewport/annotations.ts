// Everything drawn over the picture: places dots, pair lines and tags by the camera, and finds what the pointer is at.

import { Vector3 } from "three";
import type { Point } from "./arc";
import type { CameraRig, Projected } from "./camera-rig";
import type { DotHand } from "./dot-hand";
import { dotColour, type DotHit, type DotMark, DotOverlay } from "./dot-overlay";
import type { Figures } from "./figures";
import { type PairLine, PairLines } from "./pair-lines";
import type { Stage } from "./stage";
import type { Dot, ViewMode } from "./types";

const DOT_REACH = { mouse: 14, touch: 24, chasing: 40 };
const JOINT_REACH = { mouse: 22, touch: 32 };
/** Milliseconds between two looks at which dots the mesh hides. */
const OCCLUSION_PAUSE = 120;

export class Annotations {
  readonly overlay = new DotOverlay();
  readonly lines = new PairLines();
  mode: ViewMode = "pose";
  live: { id: string } | { joint: number } | null = null;
  /** Where the pointer rests, if it is over the stage and up. */
  pointer: Point | null = null;
  /** Second line of the held dot's tag. */
  note = "";
  /** Something moved since it was last asked which dots are hidden. */
  occlusionStale = true;
  private dots: readonly Dot[] = [];
  private size = { width: 1, height: 1 };
  private occlusionTime = 0;
  private occlusionTimer = 0;
  private readonly world = new Vector3();
  private readonly direction = new Vector3();
  private readonly spot: Projected = { x: 0, y: 0, depth: 0 };

  /** `again`: asks for another update() soon. */
  constructor(
    private readonly stage: Stage,
    private readonly rig: CameraRig,
    private readonly figures: Figures,
    private readonly hand: DotHand,
    private readonly again: () => void,
  ) {}

  setDots(dots: readonly Dot[], selected: string | null): void {
    this.dots = dots;
    this.overlay.setDots(dots, selected, (joint) => this.figures.jointLabel(joint));
    this.occlusionStale = true;
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
  }

  update(now: number): void {
    const { overlay, pointer } = this;
    for (const mark of overlay.marks) this.rig.project(this.markPosition(mark, this.world), mark.at);
    this.lookForHidden(now);
    if (pointer) overlay.setHover(this.dotAt(pointer, false)); // dots move under it
    overlay.place();
    this.lines.setLines(this.pairLines());
    this.updateTag();
  }

  dotAt(at: Point, touch: boolean): DotHit | null {
    return this.overlay.nearest(at.x, at.y, touch ? DOT_REACH.touch : DOT_REACH.mouse);
  }

  /** The dot of the model that a hand at this place is after; a dot that dances is met with less care. */
  dotChased(at: Point): DotHit | null {
    const hit = this.mode === "pose" ? this.overlay.nearest(at.x, at.y, DOT_REACH.chasing) : null;
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
    return this.figures.picker?.vertexAt(this.world.copy(camera.position).sub(this.stage.model.offset), direction) ?? -1;
  }

  /** Model world: on the surface, or where the hand asks it to be. */
  dotPosition(dot: Dot, out: Vector3): Vector3 {
    return dot.id === this.hand.id ? out.copy(this.hand.target) : this.figures.vertex(dot.vertex, out);
  }

  dispose(): void {
    clearTimeout(this.occlusionTimer);
  }

  /** Scene. */
  private markPosition(mark: DotMark, out: Vector3): Vector3 {
    if (mark.on === "human") return this.figures.joint(mark.dot.joint, out);
    return this.dotPosition(mark.dot, out).add(this.stage.model.offset);
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
    const eye = this.rig.camera.position.clone().sub(this.stage.model.offset);
    for (const mark of this.overlay.marks) {
      if (mark.on === "human") continue;
      const distance = this.direction.subVectors(this.dotPosition(mark.dot, this.world), eye).length();
      mark.behind = mark.id !== this.hand.id && picker.hides(eye, this.direction.divideScalar(distance), distance);
    }
  }

  private pairLines(): PairLine[] {
    const hovered = this.overlay.hoveredPair();
    const lines: PairLine[] = [];
    for (const dot of this.dots) {
      if (this.mode !== "points" && dot.id !== hovered) continue;
      const from = this.overlay.find(dot.id, "human");
      const to = this.overlay.find(dot.id, "model");
      if (!from || !to || from.button.hidden || to.button.hidden) continue;
      lines.push({ from: from.at, to: to.at, colour: dotColour(dot.number), kind: dot.guess ? "guess" : "pair" });
    }
    const live = this.liveLine();
    return live ? [...lines, live] : lines;
  }

  private liveLine(): PairLine | null {
    const { live, pointer } = this;
    if (!live || !pointer) return null;
    if ("joint" in live) {
      const from = this.rig.project(this.figures.joint(live.joint, this.world), { ...this.spot });
      return { from, to: pointer, colour: "var(--pencil, #166e94)", kind: "live" };
    }
    const mark = this.overlay.find(live.id, "model");
    return mark && { from: mark.at, to: pointer, colour: dotColour(mark.dot.number), kind: "live" };
  }

  private updateTag(): void {
    const { overlay, lines, pointer } = this;
    const mark = overlay.named();
    if (this.hand.holding && mark) {
      const start = this.rig.project(this.holdStart(mark.dot, this.world).add(this.stage.model.offset), this.spot);
      lines.setLead(start, mark.at);
      lines.setProbe(start);
      overlay.showTag(this.holdWords(mark.dot), mark.at, 26);
      return;
    }
    lines.setLead(null, null);
    const candidate = pointer && this.mode === "points" && !overlay.isHovering() ? this.candidate(pointer) : null;
    lines.setProbe(candidate?.at ?? null);
    if (candidate?.words) overlay.showTag(candidate.words, candidate.at, 14);
    else overlay.showTag(mark?.dot.name ?? null, mark?.at ?? null, mark?.on === "human" ? 18 : 24);
  }

  /** Model world: where the lead starts, on the ghost if one shows, else where the hand took the dot. */
  private holdStart(dot: Dot, out: Vector3): Vector3 {
    const { ghost } = this.figures;
    return ghost ? out.fromArray(ghost, 3 * dot.vertex) : out.copy(this.hand.origin);
  }

  /** "Top: 27 cm up, 31 cm right", as the camera sees it. */
  private holdWords(dot: Dot): string {
    const move = this.direction.subVectors(this.hand.target, this.holdStart(dot, this.world));
    const matrix = this.rig.camera.matrixWorld;
    const part = (value: number, plus: string, minus: string): string | null => {
      const cm = Math.round(100 * Math.abs(value));
      return cm > 0 ? `${cm} cm ${value > 0 ? plus : minus}` : null;
    };
    const right = move.dot(this.world.setFromMatrixColumn(matrix, 0));
    const out = move.dot(this.world.setFromMatrixColumn(matrix, 2).setY(0).normalize());
    const words = [part(move.y, "up", "down"), part(right, "right", "left"), part(out, "out", "in")].filter(Boolean).slice(0, 2);
    return [words.length ? `${dot.name}: ${words.join(", ")}` : dot.name, this.note].filter(Boolean).join("\n");
  }

  /** What a click would pick while points are made: a joint, else a vertex. */
  private candidate(at: Point): { at: Projected; words: string | null } | null {
    const joint = this.jointAt(at, false);
    if (joint >= 0) {
      const place = this.rig.project(this.figures.joint(joint, this.world), { ...this.spot });
      return { at: place, words: this.figures.jointLabel(joint) };
    }
    const vertex = this.vertexAt(at);
    if (vertex < 0) return null;
    this.figures.vertex(vertex, this.world).add(this.stage.model.offset);
    return { at: this.rig.project(this.world, { ...this.spot }), words: null };
  }
}
