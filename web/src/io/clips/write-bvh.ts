// A sampled clip as BVH text, which is what the engine reads. Joints keep their names; at rest they have no turn.

import { Euler, type Quaternion, type Vector3 } from "three";

import type { Joint } from "./joints-of-tree";
import type { Pose, Sampled } from "./sample-clip";

/** Of a joint's place against its parent, by the size of the body: less is rounding. */
const STRETCH = 1e-4;

/** `metres`: what a unit of the samples is long. */
export function writeBvh(joints: readonly Joint[], names: readonly string[], rest: Pose, sampled: Sampled, metres: number): string {
  const frames = sampled.positions.map((positions, f) => localFrame(joints, rest, [[...positions], [...sampled.turns[f]]]));
  const offsets = localFrame(joints, rest, rest).offsets.map((offset) => offset.multiplyScalar(metres));
  for (const { offsets: moved } of frames) for (const offset of moved) offset.multiplyScalar(metres);
  const size = Math.max(...rest[0].map((place) => metres * place.distanceTo(rest[0][0])));
  const moves = joints.map(
    ({ parent }, j) => parent < 0 || frames.some(({ offsets: moved }) => moved[j].distanceTo(offsets[j]) > STRETCH * size),
  );
  const lines = ["HIERARCHY"];
  const children = joints.map((_, j) => joints.flatMap(({ parent }, child) => (parent === j ? [child] : [])));
  const order: number[] = [];
  const visit = (j: number, depth: number): void => {
    const tab = "\t".repeat(depth);
    order.push(j);
    lines.push(`${tab}${depth === 0 ? "ROOT" : "JOINT"} ${clean(names[j]) || `joint${j}`}`, `${tab}{`);
    lines.push(`${tab}\tOFFSET ${places(offsets[j])}`);
    lines.push(`${tab}\tCHANNELS ${moves[j] ? "6 Xposition Yposition Zposition " : "3 "}Zrotation Xrotation Yrotation`);
    for (const child of children[j]) visit(child, depth + 1);
    lines.push(`${tab}}`);
  };
  visit(0, 0);
  lines.push("MOTION", `Frames: ${frames.length}`, `Frame Time: ${(1 / sampled.fps).toFixed(10)}`);
  for (const { offsets: moved, turns } of frames) {
    lines.push(order.map((j) => `${moves[j] ? `${places(moved[j])} ` : ""}${angles(turns[j])}`).join(" "));
  }
  return `${lines.join("\n")}\n`;
}

/** Of each joint seen from its parent, where both are turned as they are against their rest. */
function localFrame(joints: readonly Joint[], [, restTurns]: Pose, [positions, turns]: Pose): { offsets: Vector3[]; turns: Quaternion[] } {
  const turned = turns.map((turn, j) => turn.clone().multiply(restTurns[j].clone().invert()));
  const back = turned.map((turn) => turn.clone().invert());
  return {
    offsets: joints.map(({ parent }, j) =>
      parent < 0 ? positions[j].clone() : positions[j].clone().sub(positions[parent]).applyQuaternion(back[parent]),
    ),
    turns: joints.map(({ parent }, j) => (parent < 0 ? turned[j] : back[parent].clone().multiply(turned[j]))),
  };
}

/** On one line, without braces, which mean something there. */
const clean = (name: string): string => name.replace(/[{}\s]+/g, " ").trim();

const number = (x: number, digits: number): string => String(Number(x.toFixed(digits)) + 0);
const places = ({ x, y, z }: Vector3): string => [x, y, z].map((v) => number(v, 6)).join(" ");

const euler = new Euler();
function angles(turn: Quaternion): string {
  euler.setFromQuaternion(turn, "ZXY");
  return [euler.z, euler.x, euler.y].map((angle) => number((angle * 180) / Math.PI, 3)).join(" ");
}
