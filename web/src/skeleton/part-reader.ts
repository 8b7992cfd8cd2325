// The part of the body that a name means among the other names of its skeleton. The twin of
// include/rigless/motion/detail/part_reader.h.

import type { BodyPart, Side } from "./body-parts";
import type { NameParts } from "./name-parts";
import type { NameSense } from "./name-senses";

export class PartReader {
  /** Joints are the ends of their bones: Acclaim's bones, and no end sites. */
  readonly boneEnds: boolean;
  private readonly known: ReadonlySet<string>;

  constructor(private readonly names: readonly NameParts[]) {
    this.known = new Set(names.map(({ side, sense }) => `${side} ${sense}`));
    this.boneEnds = this.hasBoneEnds();
  }

  private hasBoneEnds(): boolean {
    const grown = (sense: NameSense): boolean => this.names.some((name) => name.grown && name.sense === sense);
    return !this.names.some(({ end }) => end) && grown("femur") && grown("tibia");
  }

  private has(side: Side, ...senses: NameSense[]): boolean {
    return senses.some((sense) => this.known.has(`${side} ${sense}`));
  }

  private hasAnywhere(sense: NameSense): boolean {
    return this.has(null, sense) || this.has("left", sense) || this.has("right", sense);
  }

  part(joint: number): BodyPart | null {
    const name = this.names[joint];
    const meant = this.boneEnds ? this.partAtBoneEnd(name) : this.partByContext(joint);
    if (!name.end) return meant;
    return meant === "toe" || meant === "foot" ? "tip" : "end";
  }

  private partAtBoneEnd(name: NameParts): BodyPart | null {
    switch (name.sense) {
      case "hip_joint":
        return "upper_leg";
      case "femur":
        return "lower_leg";
      case "tibia":
        return "foot";
      case "foot":
        return "toe";
      case "toe":
        return "tip";
      case "collar":
        return "upper_arm";
      case "humerus":
        return "lower_arm";
      case "radius":
        return "hand";
      default:
        return this.partBySense(name);
    }
  }

  /** Words that mean one thing here and another there. */
  private partByContext(joint: number): BodyPart | null {
    const name = this.names[joint];
    const { side } = name;
    const thigh = this.has(side, "upper_leg", "femur");
    const upperLeg = thigh || (side !== null && this.has(side, "hip"));
    const lowerLeg = this.has(side, "lower_leg", "tibia");
    const upperArm = this.has(side, "upper_arm", "humerus");
    const lowerArm = this.has(side, "lower_arm", "radius");
    switch (name.sense) {
      case "hip":
        if (side === null) return "hips";
        return thigh ? null : "upper_leg";
      case "hip_joint":
        return upperLeg ? null : "upper_leg";
      case "leg": // one word in Japanese for leg and foot
        if (upperLeg && lowerLeg && !this.has(side, "foot", "ankle")) return "foot";
        return upperLeg || (!lowerLeg && !this.isFirstOfItsWords(joint)) ? "lower_leg" : "upper_leg";
      case "arm":
        if (upperArm) return lowerArm ? "upper_arm" : "lower_arm";
        return !lowerArm && !this.isFirstOfItsWords(joint) ? "lower_arm" : "upper_arm";
      case "shoulder":
        return upperArm || this.has(side, "arm") ? "shoulder" : "upper_arm";
      case "foot":
        return this.has(side, "ankle") && !this.has(side, "toe") ? "toe" : "foot";
      default:
        return this.partBySense(name);
    }
  }

  private partBySense({ sense, side }: NameParts): BodyPart | null {
    switch (sense) {
      case "hips":
      case "hip":
        return "hips";
      case "root":
        return this.hasAnywhere("hips") || this.has(null, "hip") ? null : "hips";
      case "spine":
        return "spine";
      case "upper_back":
        return this.hasAnywhere("chest") ? "spine" : "chest";
      case "chest":
        return "chest";
      case "neck":
        return "neck";
      case "head":
        return "head";
      case "nose":
        return this.hasAnywhere("head") ? null : "head";
      case "collar":
        return "shoulder";
      case "shoulder":
      case "upper_arm":
      case "arm":
      case "humerus":
        return "upper_arm";
      case "lower_arm":
      case "radius":
        return "lower_arm";
      case "hand":
        return "hand";
      case "finger":
        return "finger";
      case "upper_leg":
      case "femur":
        return "upper_leg";
      case "lower_leg":
      case "leg":
      case "tibia":
        return "lower_leg";
      case "ankle":
      case "foot":
        return "foot";
      case "toe":
        return "toe";
      case "big_toe":
        return this.has(side, "toe") ? null : "toe";
      default:
        return null;
    }
  }

  private isFirstOfItsWords(joint: number): boolean {
    const { side, sense } = this.names[joint];
    return !this.names.slice(0, joint).some((name) => name.side === side && name.sense === sense && !name.end);
  }
}
