// A model that brings clips dances them as they were made: its points hang on its own joints, and poses show where these take them.
// Pure.

import * as commands from "../document/commands";
import { fromStage, pointToStage, type StageTransform } from "../document/stage-transform";
import type { Command } from "../document/store";
import type { Point, ProjectDocument, Vec3 } from "../document/types";
import { FPS, type Motion } from "../engine/types";
import { sayPose } from "../sync/pairing";
import { stageFor } from "../sync/placement";
import type { NamedJoint } from "../sync/named-body";
import { pointVertices } from "../sync/point-controls";
import { STAGE_HEIGHT } from "../util/constants";
import type { OwnMoves } from "./clips/own-moves";
import { jointsOf } from "./gltf/joints";
import { movedBy } from "./gltf/moved-by";
import { worldMatrices } from "./gltf/world";
import type { Model } from "./model";
import type { FoundMotion } from "./read-motion-files";

/** Poses that one clip is shown in at most. */
const MOST_POSES = 12;
/** Of the model's height: a pose that is as near to one that is shown tells nothing. */
const NEAR = 0.002;

/**
 * Pairs each point with the joint of the model's own that moves it, and shows where the clip takes them. The document has the
 * model's points and the motion; `more`: further places, those of which become points that hang on joints of their own. Null: the
 * clip does not move this model.
 */
export function ownDance(
  model: Model,
  { mesh, points }: ProjectDocument,
  more: readonly Point[],
  motion: Motion,
  { moves, input }: FoundMotion,
): Command | null {
  if (!moves) return null;
  const own = jointsOf(model.document, model);
  const movers = movedBy(model.document, model, own);
  const has = new Set(motion.joints.map(({ name }) => name));
  const index = new Map(moves.names.flatMap((name, j) => (has.has(name) ? [[name, j] as const] : [])).reverse());
  // Joints that no clip moves go with what they hang on; those that hang above the hips, as feet that hands lead do, with what is there.
  const jointOf = (mover: number): number => {
    for (let k: number | null = mover; k !== null && k >= 0; k = own.joints[k].parent) {
      const j = index.get(own.joints[k].name);
      if (j !== undefined) return j;
    }
    const moved = own.joints.filter(({ name }) => index.has(name));
    if (mover < 0 || moved.length === 0) return -1;
    const away = (joint: NamedJoint): number => Math.hypot(...minus(joint.position, own.joints[mover].position));
    return index.get(moved.reduce((a, b) => (away(b) < away(a) ? b : a)).name) ?? -1;
  };
  const known = motion.joints.map(({ name }) => index.get(name) ?? -1);
  const moverOf = (vertex: number): number => jointOf(movers[vertex]);
  const used = new Set(pointVertices(model, points).map(moverOf));
  const further = more.filter((_, n) => {
    const joint = moverOf(pointVertices(model, [...points, ...more])[points.length + n]);
    return joint >= 0 && !used.has(joint) && used.add(joint);
  });
  const held = [...points, ...further];
  const vertices = pointVertices(model, held);
  const joints = vertices.map(moverOf);
  if (known[0] < 0 || joints.every((j) => j < 0)) return null;

  const stage = stageFor(model, mesh);
  const places = placesOf(model, stage, motion, moves, known, vertices, joints);
  const paired = held.map((point, c): Point => ({ ...point, joint: moves.names[joints[c]] ?? point.joint }));
  const size = 3 * motion.joints.length;
  const shown = farthest(places, NEAR * STAGE_HEIGHT).map((frame) => {
    const pose = motion.local.subarray(frame * size, (frame + 1) * size);
    const at = fromStage(stage, places[frame]);
    return {
      frame,
      pose,
      points: Object.fromEntries(held.map(({ id }, c): [string, Vec3] => [id, [at[3 * c], at[3 * c + 1], at[3 * c + 2]]])),
    };
  });
  return (before) => {
    const after = commands.addPoints(further)(before);
    const pointOf = new Map(paired.map((point) => [point.id, point]));
    const settings = { ...after.settings, smoothness: 0 }; // what it was made as is not too lively
    const document = { ...after, settings, points: after.points.map((point) => pointOf.get(point.id) ?? point) };
    return shown.reduce((next, { frame, pose, points: at }): ProjectDocument => {
      const { joints: said, roles } = sayPose(next, motion, pose);
      const source = { motion: input.name, frame };
      return commands.addExample({ id: commands.freeId(next.examples, "e"), source, joints: said, points: at }, roles)(next);
    }, document);
  };
}

/** By frame: C x 3, body-local on the stage, where the joints take the vertices. `known`: of the motion's joints those of `moves`. */
function placesOf(
  model: Model,
  stage: StageTransform,
  motion: Motion,
  { fps, names, rest, frames }: OwnMoves,
  known: readonly number[],
  vertices: readonly number[],
  joints: readonly number[],
): Float32Array[] {
  const turn = { ...stage, offset: [0, 0, 0] as const };
  const { nodes = [] } = model.document.json;
  const world = worldMatrices(model.document);
  const placeIn = (name: string): Vec3 => {
    const at = world[nodes.findIndex((node) => node.name === name)] ?? [];
    return [12, 13, 14].map((k) => (at[k] ?? 0) - model.origin[k - 12]) as unknown as Vec3;
  };
  const hips = known[0];
  // The reader of a model may have brought its file's units to metres.
  const [inModel, inFile] = joints.reduce(
    ([a, b], j) => {
      if (j < 0) return [a, b];
      const way = minus(placeIn(names[j]), placeIn(names[hips]));
      return [a + Math.hypot(...way), b + Math.hypot(...minus(at(rest, 7 * j), at(rest, 7 * hips)))];
    },
    [0, 0],
  );
  const scale = inModel > 0 && inFile > 0 ? inModel / inFile : 1;
  const held = joints.map((joint, c) => {
    const j = joint < 0 ? hips : joint;
    const v = 3 * vertices[c];
    return { j, offset: turned(inverse(rest, 7 * j + 3), minus(at(model.positions, v), placeIn(names[j]))) };
  });
  const origin = pointToStage(stage, placeIn(names[hips]));
  const count = frames.length / rest.length;
  const rowOf = (f: number): number => rest.length * Math.min(Math.round((f * fps) / FPS), count - 1);
  const seen = (f: number, j: number, offset: Vec3 = [0, 0, 0]): Vec3 => {
    const [x, y, z] = minus(at(frames, rowOf(f) + 7 * j), at(frames, rowOf(f) + 7 * hips));
    return pointToStage(turn, [scale * x + offset[0], scale * y + offset[1], scale * z + offset[2]]);
  };
  // By how much the motion was turned about the vertical, as far as that shows.
  let [sine, cosine, all] = [0, 0, 0];
  for (let f = 0; f < motion.frames; f++) {
    const [hipX, , hipZ] = at(motion.positions, 3 * f * known.length);
    known.forEach((j, k) => {
      if (j < 0) return;
      const [dx, dy, dz] = seen(f, j);
      const [x, , z] = minus(at(motion.positions, 3 * (f * known.length + k)), [hipX, 0, hipZ]);
      sine += x * dz - z * dx;
      cosine += x * dx + z * dz;
      all += Math.hypot(x, z) * Math.hypot(dx, dy, dz);
    });
  }
  const turnedBy = Math.hypot(sine, cosine) > 1e-4 * all ? Math.atan2(sine, cosine) : 0;
  return Array.from({ length: motion.frames }, (_, f) => {
    const [s, c] = [Math.sin(turnedBy - motion.yaw[f]), Math.cos(turnedBy - motion.yaw[f])];
    const out = new Float32Array(3 * held.length);
    held.forEach(({ j, offset }, n) => {
      const from = rowOf(f) + 7 * j + 3;
      const [x, y, z] = seen(f, j, turned([...frames.subarray(from, from + 4)], offset));
      out.set([c * x + s * z + origin[0], y + origin[1], c * z - s * x + origin[2]], 3 * n);
    });
    return out;
  });
}

const at = (places: Float32Array, i: number): Vec3 => [places[i], places[i + 1], places[i + 2]];
const minus = (a: Readonly<Vec3>, b: Readonly<Vec3>): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const inverse = (turns: Float32Array, i: number): number[] => [-turns[i], -turns[i + 1], -turns[i + 2], turns[i + 3]];

/** By a unit quaternion. */
function turned([x, y, z, w]: readonly number[], [a, b, c]: Vec3): Vec3 {
  const [p, q, r] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * p + y * r - z * q, b + w * q + z * p - x * r, c + w * r + x * q - y * p];
}

/** Frames that are as far as can be from each other, until all others are near. */
function farthest(places: readonly Float32Array[], near: number): number[] {
  const away = new Float64Array(places.length).fill(Infinity);
  const chosen: number[] = [];
  for (let next = 0; chosen.length < MOST_POSES && away[next] > near; ) {
    chosen.push(next);
    places.forEach((place, f) => {
      const rms = Math.sqrt(place.reduce((sum, x, k) => sum + (x - places[chosen[chosen.length - 1]][k]) ** 2, 0) / (place.length / 3));
      away[f] = Math.min(away[f], rms);
    });
    next = away.indexOf(Math.max(...away));
  }
  return chosen.sort((a, b) => a - b);
}
