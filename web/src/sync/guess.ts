// From what a bare model says of itself to a project that dances at once. Pure.

import { addPoints, newDocument } from "../document/commands";
import { STAGE_HEIGHT } from "../util/constants";
import type { MeshRef, Point, ProjectDocument } from "../document/types";
import type { BodyPart, BodyPoint, Joint, ShapeAnalysis } from "../engine/types";
import { rolesToRecord } from "./pairing";
import { stageFor } from "./placement";
import type { SolverModel } from "./placement";

export interface Guess {
  mesh: Pick<MeshRef, "facing" | "up">;
  /** Enough to dance. */
  points: Point[];
  /** Further places where the model may well be held. */
  more: Point[];
  /** Roles of the points' joints that their names do not tell. */
  roles: NonNullable<ProjectDocument["joints"]>;
}

const ROLES: readonly BodyPoint["role"][] = ["head", "hand", "elbow", "foreleg", "foot", "knee", "chest", "hips", "tail", "tip"];

/** The part of the human that moves a point. Others follow the whole pose. */
const PART: Partial<Record<BodyPoint["role"], BodyPart>> = {
  head: "head",
  hand: "hand",
  elbow: "lower_arm",
  foot: "foot",
  foreleg: "hand",
  knee: "lower_leg",
  chest: "chest",
  hips: "hips",
};

/** These hold the trunk. */
const TRUNK: ReadonlySet<BodyPoint["role"]> = new Set(["hips", "chest"]);

/** Points on the model with the joints of a motion that they follow. */
export function guessPoints(model: SolverModel, { up, facing, points }: ShapeAnalysis, joints: readonly Joint[]): Guess {
  const mesh = { facing, up };
  const { scale } = stageFor(model, { file: "", ...mesh });
  const names = uniqueNames(points);
  const ids = names.map((name) => name.toLowerCase().replaceAll(" ", "-"));
  const told = joints.some(({ part }) => part === "head" || part === "hand" || part === "foot"); // hips alone are no pairing
  const all = points.map((point, n): Point => {
    const [x, y, z] = model.positions.subarray(3 * point.vertex, 3 * point.vertex + 3);
    return {
      id: ids[n],
      name: names[n],
      position: [x, y, z],
      joint: (told && jointOf(point, joints)?.name) || null,
      radius: Math.round((1000 * point.radius * scale) / STAGE_HEIGHT) / 1000,
      ...(TRUNK.has(point.role) ? { slab: true } : {}),
      ...(point.partner >= 0 ? { mirror: ids[point.partner] } : {}),
    };
  });
  const order = points.map((_, n) => n).sort((a, b) => rank(points[a]) - rank(points[b]));
  return {
    mesh,
    points: order.filter((n) => points[n].wanted).map((n) => all[n]),
    more: order.filter((n) => !points[n].wanted).map((n) => all[n]),
    roles: rolesToRecord(all, joints),
  };
}

/** A project of a model and a motion alone; `file` and `motion` as a document names them. */
export function guessProject(
  name: string,
  file: string,
  motion: readonly string[],
  model: SolverModel,
  said: ShapeAnalysis,
  joints: readonly Joint[],
): ProjectDocument {
  const { mesh, points, roles } = guessPoints(model, said, joints);
  return addPoints(points, roles)(newDocument(name, { file, ...mesh, solve: "solid" }, { files: motion }));
}

/** From head to foot, left before right. */
const rank = ({ role, side }: BodyPoint): number => 2 * ROLES.indexOf(role) + (side === "right" ? 1 : 0);

/** A foreleg is a hand on the ground; where there is no hand it goes with the foot across. */
function jointOf({ role, side }: BodyPoint, joints: readonly Joint[]): Joint | undefined {
  const find = (part: BodyPart | undefined, on: BodyPoint["side"]) => joints.find((joint) => joint.part === part && joint.side === on);
  const part = PART[role];
  const across = side === "left" ? "right" : "left";
  return part && (find(part, side) ?? (role === "foreleg" ? find("foot", across) : undefined));
}

/** "Left hand", "Tip", "Tip 2" */
function uniqueNames(points: readonly BodyPoint[]): string[] {
  const taken = new Set<string>();
  return points.map(({ role, side }) => {
    const words = side === null ? role : `${side} ${role}`;
    const name = words.charAt(0).toUpperCase() + words.slice(1);
    let unique = name;
    for (let n = 2; taken.has(unique); n++) unique = `${name} ${n}`;
    taken.add(unique);
    return unique;
  });
}
