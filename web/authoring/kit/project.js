// A character's project from two tables: which points follow which joints, and what it does when the human does what.
import { placeJoints } from "./skeleton.js";
import { rotY, rotate } from "./rotation.js";
import { distance, sub } from "./vec3.js";

const EXAMPLE_FPS = 30;

const round = (v, digits) => v.map((x) => +x.toFixed(digits) + 0);
const flipped = ([x, y, z]) => [-x, y, z];
const swapSides = (id) => id.replace(/left|right/, (s) => (s === "left" ? "right" : "left"));

/** Joints in metres with the root at the origin and the part of the root's turn about the vertical taken out. */
function bodyLocal(pose) {
  const { world, turn } = placeJoints(pose);
  const m = turn.Hips;
  // Twist of the unit quaternion (w, x, y, z) about y: atan2(y, w), doubled.
  const yaw = (2 * Math.atan2((m[2] - m[6]) / 4, (1 + m[0] + m[4] + m[8]) / 4) * 180) / Math.PI;
  const back = rotY(-yaw);
  return Object.fromEntries(
    Object.entries(world).map(([name, p]) => [
      name,
      round(
        rotate(back, sub(p, world.Hips)).map((x) => x / 100),
        4,
      ),
    ]),
  );
}

/** A row with `pair` stands for its left one, as written, and the right one; the others of such a table lie in the middle. */
const expand = ({ pair, id, name, joint, near, ...rest }) =>
  pair
    ? [
        ["right", flipped(near)],
        ["left", near],
      ].map(([side, at]) => ({
        ...rest,
        id: `${side}-${id}`,
        name: `${side[0].toUpperCase()}${side.slice(1)} ${name.toLowerCase()}`,
        near: at,
        joint: joint && side[0].toUpperCase() + side.slice(1) + joint,
        mirror: swapSides(`${side}-${id}`),
      }))
    : [{ id, name, joint, near, ...rest }];

/**
 * points: rows { id, name, joint, near, radius, pair? }: the vertex nearest to `near` (metres of the character, its left at +x, front at +z)
 * follows the joint; a pair's joint is named without its side.
 * poses: rows { id, motion, seconds, moves, mirror? }: moves of points from rest; a move under a pair's own id is its left one's, and mirrored
 * for the right one. mirror: { id, seconds } adds the other side's pose.
 * motions: { name: { file, fps, poses } }, poses one for each frame. opens: the name of the one that the project opens
 * with, which lies in motionsFolder, seen from the project.
 */
export function makeProject({ name, file, vertices, points: rows, poses, settings, motions, opens, motionsFolder }) {
  const nearest = (p) => vertices.reduce((best, v) => (distance(v, p) < distance(best, p) ? v : best));
  const symmetric = rows.some((row) => row.pair);
  const points = rows
    .flatMap(expand)
    .map(({ id, name: label, joint, near, radius, mirror = symmetric ? id : undefined }) => ({
      id,
      name: label,
      position: round(nearest(near), 4),
      joint,
      radius,
      ...(mirror && { mirror }),
    }));
  const pairs = new Set(rows.filter((row) => row.pair).map((row) => row.id));
  const bothSides = (moves) =>
    Object.fromEntries(
      Object.entries(moves).flatMap(([id, move]) =>
        pairs.has(id)
          ? [
              [`left-${id}`, move],
              [`right-${id}`, flipped(move)],
            ]
          : [[id, move]],
      ),
    );
  const mirrored = (moves) => Object.fromEntries(Object.entries(moves).map(([id, move]) => [swapSides(id), flipped(move)]));
  const example = ({ id, motion, seconds }, moves) => {
    const { file: source, fps, poses: frames } = motions[motion];
    const frame = Math.round(seconds * EXAMPLE_FPS);
    return {
      id,
      source: { motion: source, frame },
      joints: bodyLocal(frames[frame * (fps / EXAMPLE_FPS)]),
      points: Object.fromEntries(
        points.map((p) => [
          p.id,
          round(
            p.position.map((x, k) => x + (moves[p.id]?.[k] ?? 0)),
            4,
          ),
        ]),
      ),
    };
  };
  const examples = poses.flatMap((pose) => {
    const moves = bothSides(pose.moves);
    return [example(pose, moves), ...(pose.mirror ? [example({ ...pose, ...pose.mirror }, mirrored(moves))] : [])];
  });
  return {
    version: 1,
    name,
    mesh: { file, facing: "+z", up: "+y" },
    motion: { files: [motionsFolder + motions[opens].file] },
    points,
    examples,
    settings,
  };
}
