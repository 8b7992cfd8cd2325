// What the joints that a file brings say of its body: how it stands, and where its head, hands and feet are. Pure.

import type { AxisName, Landmark } from "../engine/types";
import type { Side } from "../skeleton/body-parts";
import { type LimbName, readLimbNames, standsOut } from "../skeleton/limb-names";
import type { FileAxes } from "../util/constants";

type Place = readonly [number, number, number];

/** A joint of a file's skeleton, where the model stands in it. */
export interface NamedJoint {
  readonly name: string;
  /** Index; null for a root. */
  readonly parent: number | null;
  readonly position: Place;
}

export interface NamedBody {
  /** Null where the joints do not tell. */
  stands: { up: AxisName; facing: AxisName } | null;
  landmarks: Landmark[];
}

/** An arm, leg or wing from where it leaves the trunk. */
export interface NamedLimb {
  kind: LimbName["kind"];
  which: string;
  side: Exclude<Side, null>;
  base: Place;
  /** Whether more than a hand or a foot of it is named. */
  whole: boolean;
  /** Where its lower half begins; null where no joint does. */
  bend: Place | null;
  /** The last joint that its end is known to be near. */
  end: Place;
  /** The way on from there where the joints stop short of the end. */
  onwards: Place | null;
  toes: Place | null;
  /** All that hang on it. */
  joints: readonly number[];
}

interface Bounds {
  readonly min: readonly number[];
  readonly max: readonly number[];
}

const ENDS: ReadonlySet<LimbName["part"]> = new Set<LimbName["part"]>(["hand", "finger", "foot", "toe", "tip"]);
const ZERO: Place = [0, 0, 0];
const plus = (a: Place, b: Place, times = 1): Place => [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]];
const minus = (a: Place, b: Place): Place => plus(a, b, -1);
const dot = (a: Place, b: Place): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const far = (a: Place, b: Place): number => Math.hypot(...minus(a, b));
const mean = (places: readonly Place[]): Place => places.reduce((sum, place) => plus(sum, place, 1 / places.length), ZERO);
const AXES: readonly AxisName[] = ["+y", "+z", "-z", "-y", "+x", "-x"];

/** Null where no names say anything. `box`: of the model. */
export function readNamedBody(joints: readonly NamedJoint[], box: Bounds, axes: FileAxes): NamedBody | null {
  const body = new NamedBodyReader(joints, box);
  return body.limbs.length > 0 || body.heads.length > 0 ? body.read(axes) : null;
}

/** The arms, legs and wings of a body whose joints are named. */
export function readNamedLimbs(joints: readonly NamedJoint[], box: Bounds): readonly NamedLimb[] {
  return new NamedBodyReader(joints, box).limbs.filter(({ whole }) => whole);
}

class NamedBodyReader {
  readonly limbs: NamedLimb[] = [];
  readonly heads: number[];
  private readonly names: LimbName[];
  private readonly size: number;

  constructor(
    private readonly joints: readonly NamedJoint[],
    private readonly box: Bounds,
  ) {
    this.names = readLimbNames(joints.map(({ name }) => name));
    this.size = Math.max(...box.max.map((high, k) => high - box.min[k]));
    this.heads = joints.flatMap((_, j) => (this.isOfHead(j) ? [j] : []));
    const groups = new Map<string, number[]>();
    this.names.forEach(({ kind, side, which }, j) => {
      const { parent } = this.joints[j];
      const above = parent === null ? null : this.names[parent].side;
      // "PalmR.L": the ring finger's.
      if (side === null || (above !== null && above !== side) || (kind !== "arm" && kind !== "leg" && kind !== "wing")) return;
      const key = `${kind} ${side} ${which}`;
      groups.set(key, [...(groups.get(key) ?? []), j]);
    });
    for (const group of groups.values()) {
      const limb = this.limbOf(group);
      const { kind, part } = this.names[group[0]];
      if (kind === "arm" && group.every((j) => this.names[j].part === "finger")) continue; // of a foot that is called a hand
      if (kind === "arm" && part === "upper_arm" && limb.end === limb.base) continue; // a shoulder alone, as wings hang on
      this.limbs.push(limb);
    }
  }

  read(axes: FileAxes): NamedBody {
    const stands = this.stands(axes);
    const up = vectorOf(stands?.up ?? "+y");
    return { stands, landmarks: stands ? this.landmarks(up, stands) : [] };
  }

  private isOfHead(j: number): boolean {
    const { kind } = this.names[j];
    if (kind !== null && kind !== "head") return false;
    if (kind === "head") return true;
    for (let k: number | null = j; k !== null; k = this.joints[k].parent) {
      if (standsOut(this.joints[k].name)) return false;
      if (this.names[k].kind === "head") return true;
    }
    return false;
  }

  private at(j: number): Place {
    return this.joints[j].position;
  }

  /** How far from the trunk; feet may hang on nothing. */
  private rank(j: number): number {
    let depth = this.names[j].part === "foot" ? 1000 : 0;
    for (let k = this.joints[j].parent; k !== null; k = this.joints[k].parent) depth++;
    return depth;
  }

  /** From the joints of a limb; those that hang on them count, thumbs aside. */
  private limbOf(group: readonly number[]): NamedLimb {
    const { kind, side, which } = this.names[group[0]];
    const inGroup = new Set(group);
    const base =
      group.find((j) => this.names[j].part === (kind === "leg" ? "upper_leg" : "upper_arm")) ??
      group.reduce((a, b) => (this.rank(b) < this.rank(a) ? b : a));
    const hangs = (j: number): boolean => {
      if (this.names[j].kind !== null || /thumb/i.test(this.joints[j].name)) return false;
      for (let k: number | null = j; k !== null; k = this.joints[k].parent) if (inGroup.has(k)) return true;
      return false;
    };
    const all = this.joints.flatMap((_, j) => (inGroup.has(j) || hangs(j) ? [j] : []));
    const from = this.at(base);
    const own = new Set(group);
    this.joints.forEach(({ parent }, j) => void (parent !== null && own.has(parent) && own.add(j))); // parents come before
    const farthest = (some: readonly number[]): number => some.reduce((a, b) => (far(this.at(b), from) > far(this.at(a), from) ? b : a));
    const end = farthest(all);
    const { part } = this.names[end];
    const bend = group.find((j) => this.names[j].part === (kind === "leg" ? "lower_leg" : "lower_arm"));
    const before = all.filter((j) => j !== end && far(this.at(j), from) < far(this.at(end), from));
    const last = before.length > 0 ? farthest(before) : base;
    const short = kind !== "wing" && (part === "lower_leg" || part === "lower_arm" || part === "upper_leg" || part === "upper_arm");
    const ankles = all.filter((j) => this.names[j].part === "foot");
    const tips = all.filter((j) => this.names[j].part === "toe" || this.names[j].part === "tip");
    return {
      ...{ kind, which, side: side ?? "left" },
      base: from,
      whole: !ENDS.has(this.names[base].part),
      bend: bend === undefined ? null : this.at(bend),
      end: this.at(end),
      onwards: short ? minus(this.at(end), this.at(last)) : null,
      toes: ankles.length > 0 && tips.length > 0 ? minus(mean(tips.map((j) => this.at(j))), this.at(ankles[0])) : null,
      joints: [...own],
    };
  }

  /** Left from right limbs, up from legs and the head, front from both; toes that point backwards know better. */
  private stands(axes: FileAxes): NamedBody["stands"] {
    const left = this.limbs.reduce((sum, a) => {
      const b = a.side === "left" && this.limbs.find((other) => other.side === "right" && other.kind === a.kind && other.which === a.which);
      return b ? plus(sum, plus(minus(a.base, b.base), minus(a.end, b.end))) : sum;
    }, ZERO);
    const across = axisOf(left);
    if (across === null) return this.standsByLength(axes);
    const legs = this.limbs.filter(({ kind }) => kind === "leg");
    const hips = legs.length > 0 ? mean(legs.map(({ base }) => base)) : mean(this.joints.map(({ position }) => position));
    const head = this.heads.length > 0 ? mean(this.heads.map((j) => this.at(j))) : hips;
    const drop = legs.length > 0 ? minus(hips, mean(legs.map(({ end }) => end))) : ZERO;
    let [up, most] = ["+y" as AxisName, -Infinity];
    for (const axis of AXES) {
      if (axis.charAt(1) === across.charAt(1)) continue;
      const v = vectorOf(axis);
      const says = usual(axis, axes) + (1.5 * dot(drop, v) + (legs.length > 0 ? 1 : 0.3) * dot(minus(head, hips), v)) / this.size;
      if (says > most) [up, most] = [axis, says];
    }
    const u = vectorOf(up);
    const l = vectorOf(across);
    let front: Place = [l[1] * u[2] - l[2] * u[1], l[2] * u[0] - l[0] * u[2], l[0] * u[1] - l[1] * u[0]];
    const toes = legs.flatMap(({ toes: one }) => (one ? [one] : []));
    if (toes.length > 1 && toes.every((toe) => dot(toe, front) < -0.02 * this.size)) front = minus(ZERO, front);
    return { up, facing: axisOf(front) ?? "+z" };
  }

  /** One without sides looks from its tail to its head. */
  private standsByLength(axes: FileAxes): NamedBody["stands"] {
    const tails = this.names.flatMap(({ kind }, j) => (kind === "tail" ? [this.at(j)] : []));
    if (axes === "unknown" || axes === "z_up" || this.heads.length === 0 || tails.length === 0) return null;
    const [x, , z] = minus(mean(this.heads.map((j) => this.at(j))), mean(tails));
    const facing = axisOf([x, 0, z]);
    return facing && { up: "+y", facing };
  }

  private landmarks(up: Place, stands: { up: AxisName; facing: AxisName }): Landmark[] {
    const height = (place: Place): number => dot(place, up);
    const [low, high] = [this.box.min, this.box.max].map((corner) => dot([corner[0], corner[1], corner[2]], up)).sort((a, b) => a - b);
    const tall = high - low;
    const front = vectorOf(stands.facing);
    const left: Place = [up[1] * front[2] - up[2] * front[1], up[2] * front[0] - up[0] * front[2], up[0] * front[1] - up[1] * front[0]];
    const grounded = (place: Place): Place => plus(place, up, low - height(place));
    const ends = this.limbs.map((limb) => {
      if (!limb.onwards) return limb.end;
      const on = plus(limb.end, limb.onwards, limb.kind === "leg" ? 1 : 0.7);
      return limb.kind === "leg" && height(limb.end) - low < 0.45 * tall ? grounded(limb.end) : on;
    });
    const onGround = (n: number, least: number): boolean => height(ends[n]) - low < least * tall;
    const marks: Landmark[] = [];
    const mark = (role: Landmark["role"], position: Place, side: NamedLimb["side"] | null = null): void => {
      marks.push({ role, position: [...position], side: side === null ? 0 : side === "left" ? 1 : -1 });
    };
    const arms = this.limbs.some(({ kind, which }, n) => (kind === "arm" || which === "front") && !onGround(n, 0.06));
    const hindEnds = mean(this.limbs.flatMap(({ kind, which }, n) => (kind === "leg" && which !== "front" ? [ends[n]] : [])));
    const bases = (fore: boolean): Place[] =>
      this.limbs.flatMap(({ kind, which, base }) => (kind !== "wing" && (kind === "arm" || which === "front") === fore ? [base] : []));
    const [hips, shoulders] = [bases(false), bases(true)];
    const trunk = minus(mean(shoulders), mean(hips));
    const level = dot(trunk, front) > dot(trunk, up);
    this.limbs.forEach((limb, n) => {
      const side = this.sideOf(limb, left);
      const { kind, which } = limb;
      if (kind === "wing") {
        if (!arms && this.isFirstWing(limb)) mark("hand", ends[n], side);
        return;
      }
      const fore = kind === "arm" || which === "front";
      const stands = onGround(n, 0.15) && (kind !== "arm" || level);
      const before = dot(minus(ends[n], hindEnds), front) > 0.12 * tall;
      if (fore && !(stands && before)) mark("hand", ends[n], side);
      else mark("foot", onGround(n, 0.15) ? grounded(ends[n]) : ends[n], side);
    });
    if (hips.length === 2 && height(mean(hips)) - low > 0.15 * tall) {
      mark("hips", mean(hips));
      if (shoulders.length === 2) mark("chest", plus(mean(hips), trunk, 0.7));
    }
    for (const j of this.heads) mark("head", this.at(j));
    this.names.forEach(({ kind }, j) => {
      if (kind !== "helper" && !this.heads.includes(j)) mark(kind === "tail" ? "tail" : "tip", this.at(j));
    });
    return marks;
  }

  /** By where it is, since names may be seen from in front. */
  private sideOf({ side, kind, which }: NamedLimb, left: Place): NamedLimb["side"] {
    const of = (wanted: Side): Place[] =>
      this.limbs.flatMap((limb) => (limb.side === wanted && limb.kind === kind && limb.which === which ? [limb.base, limb.end] : []));
    const [own, other] = [of(side), of(side === "left" ? "right" : "left")];
    if (other.length === 0) return side;
    return dot(minus(mean(own), mean(other)), left) > 0 ? "left" : "right";
  }

  private isFirstWing({ side, which }: NamedLimb): boolean {
    const wings = this.limbs.filter((limb) => limb.kind === "wing" && limb.side === side);
    return (
      wings.length < 2 ||
      which === "front" ||
      (which !== "back" && !wings.some((wing) => wing.which === "front") && wings[0].which === which)
    );
  }
}

/** What speaks for an axis being up before the joints are heard. */
function usual(axis: AxisName, axes: FileAxes): number {
  if (axis === "+y") return axes === "y_up_by_rule" ? 0.5 : axes === "y_up" ? 0.35 : 0.2;
  return axis === "+z" ? (axes === "z_up" ? 0.35 : 0.1) : 0;
}

function vectorOf(axis: AxisName): Place {
  const sign = axis.startsWith("-") ? -1 : 1;
  return [axis.endsWith("x") ? sign : 0, axis.endsWith("y") ? sign : 0, axis.endsWith("z") ? sign : 0];
}

/** The axis that a direction runs along; null where it runs along none. */
function axisOf(v: Place): AxisName | null {
  const length = Math.hypot(...v);
  return AXES.find((axis) => dot(v, vectorOf(axis)) > 0.8 * length && length > 0) ?? null;
}
