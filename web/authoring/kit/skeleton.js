// The human: 22 joints with ordinary names, 1.7 m tall in a T-pose, centimetres, Y up, facing +Z, its left at +X.
import { add, clamp, cross, dot, length, normalize, scale, sub } from "./vec3.js";
import { frameDown, fromColumns, identity, multiply, rotX, rotY, rotZ, rotate, toZxy, transpose } from "./rotation.js";

const side = (name, s) => [
  [`${name}Shoulder`, "Spine2", [3 * s, 11, 0]],
  [`${name}Arm`, `${name}Shoulder`, [14 * s, 0, -1]],
  [`${name}ForeArm`, `${name}Arm`, [27 * s, 0, 0]],
  [`${name}Hand`, `${name}ForeArm`, [25 * s, 0, 0], [16 * s, 0, 0]],
];
const leg = (name, s) => [
  [`${name}UpLeg`, "Hips", [9 * s, -4, 0]],
  [`${name}Leg`, `${name}UpLeg`, [0, -41, 0]],
  [`${name}Foot`, `${name}Leg`, [0, -40, 0]],
  [`${name}Toe`, `${name}Foot`, [0, -6, 13], [0, -1, 7]],
];

/** Name, parent, offset, offset of the end site. */
export const JOINTS = [
  ["Hips", null, [0, 0, 0]],
  ["Spine", "Hips", [0, 9, -0.5]],
  ["Spine1", "Spine", [0, 13, 0]],
  ["Spine2", "Spine1", [0, 13, 0]],
  ["Neck", "Spine2", [0, 16, -1]],
  ["Head", "Neck", [0, 9, 1.5], [0, 17, 1.5]],
  ...side("Left", 1),
  ...side("Right", -1),
  ...leg("Left", 1),
  ...leg("Right", -1),
].map(([name, parent, offset, end]) => ({ name, parent, offset, end }));

export const HIP_HEIGHT = 93;
const THIGH = 41;
const SHIN = 40;
export const ANKLE_TO_BALL = [0, -6, 13];
/** The end site's height below the ball: what lies on the floor. */
export const BALL_HEIGHT = 2;
export const ANKLE_HEIGHT = BALL_HEIGHT + 6;
const BALL_TO_HEEL = [0, -BALL_HEIGHT, -18];

// Shares of the body's mass at the middle of the segment from a joint to its child (after Winter 2009, table 4.1).
const SEGMENTS = [
  ["Hips", "Spine1", 0.142 + 0.139],
  ["Spine1", "Neck", 0.216],
  ["Neck", "Head", 0.02],
  ["Head", "Head_end", 0.061],
  ...["Left", "Right"].flatMap((s) => [
    [`${s}Arm`, `${s}ForeArm`, 0.028],
    [`${s}ForeArm`, `${s}Hand`, 0.016],
    [`${s}Hand`, `${s}Hand_end`, 0.006],
    [`${s}UpLeg`, `${s}Leg`, 0.1],
    [`${s}Leg`, `${s}Foot`, 0.0465],
    [`${s}Foot`, `${s}Toe`, 0.0145],
  ]),
];

/** A pose is { root, local }: the hips' place and a rotation for each joint's name; joints left out do not turn. */
export function placeJoints(pose) {
  const world = {};
  const turn = {};
  for (const { name, parent, offset, end } of JOINTS) {
    const local = pose.local[name] ?? identity;
    world[name] = parent ? add(world[parent], rotate(turn[parent], offset)) : pose.root;
    turn[name] = parent ? multiply(turn[parent], local) : local;
    if (end) world[`${name}_end`] = add(world[name], rotate(turn[name], end));
  }
  return { world, turn };
}

export function centreOfMass(world) {
  let sum = [0, 0, 0];
  let mass = 0;
  for (const [a, b, m] of SEGMENTS) {
    sum = add(sum, scale(add(world[a], world[b]), m / 2));
    mass += m;
  }
  return scale(sum, 1 / mass);
}

/**
 * One leg by two-bone inverse kinematics. foot: { ball: place of the ball, yaw, pitch (heel up > 0), toe (extra bend), knee (its yaw from the hips, else the foot's), splay (of
 * the knee outwards, degrees) }. Writes the leg's rotations into `local`; gives how far the leg is stretched, 1 is straight.
 */
export function solveLeg(local, name, root, hips, foot) {
  const sign = name === "Left" ? 1 : -1;
  const footTurn = multiply(rotY(foot.yaw), rotX(foot.pitch));
  const ankle = sub(foot.ball, rotate(footTurn, ANKLE_TO_BALL));
  const hip = add(root, rotate(hips, [9 * sign, -4, 0]));
  const to = sub(ankle, hip);
  const far = Math.min(length(to), (THIGH + SHIN) * 0.9995);
  const cosHip = clamp((THIGH ** 2 + far ** 2 - SHIN ** 2) / (2 * THIGH * far), -1, 1);
  const axis = normalize(to);
  const forward = rotate(multiply(hips, rotY((foot.knee ?? foot.yaw) * 0.6 + sign * foot.splay)), [0, 0, 1]);
  const ahead = normalize(sub(forward, scale(axis, dot(forward, axis))));
  const knee = add(hip, add(scale(axis, THIGH * cosHip), scale(ahead, THIGH * Math.sqrt(1 - cosHip ** 2))));
  const end = add(hip, scale(axis, far));
  const thighTurn = frameDown(sub(knee, hip), ahead);
  const x = rotate(thighTurn, [1, 0, 0]); // the knee's axis, which both bones share
  const up = normalize(sub(knee, end));
  const shinTurn = fromColumns(x, up, cross(x, up));
  local[`${name}UpLeg`] = multiply(transpose(hips), thighTurn);
  local[`${name}Leg`] = multiply(transpose(thighTurn), shinTurn);
  local[`${name}Foot`] = multiply(transpose(shinTurn), footTurn);
  local[`${name}Toe`] = rotX(foot.toe);
  return length(to) / (THIGH + SHIN);
}

/**
 * One arm by angles: raise forwards, then swing that out sideways, turn about its own length, bend of the elbow and of the wrist. All zero: it
 * hangs down. From the T-pose, hence the last factor.
 */
export function setArm(local, name, { forward, out, turn, elbow, wrist, shrug }) {
  const s = name === "Left" ? 1 : -1;
  local[`${name}Shoulder`] = rotZ(s * shrug);
  local[`${name}Arm`] = multiply(rotZ(s * out), rotX(-forward), rotY(s * turn), rotZ(-s * 90));
  local[`${name}ForeArm`] = rotY(-s * elbow);
  local[`${name}Hand`] = rotZ(s * wrist);
}

/** Bends forward, sideways (towards the left) and turns, over the three joints of the spine. */
export function setSpine(local, { pitch, roll, yaw }) {
  for (const name of ["Spine", "Spine1", "Spine2"]) local[name] = multiply(rotY(yaw / 3), rotX(pitch / 3), rotZ(-roll / 3));
}

/** Turns neck and head so that the head looks where it is told, whatever the body does. */
export function setHead(local, turn, { pitch, roll, yaw }) {
  const wanted = multiply(rotY(yaw), rotX(pitch), rotZ(-roll));
  const rest = multiply(transpose(turn.Spine2), wanted);
  const [z, x, y] = toZxy(rest);
  local.Neck = multiply(rotZ(z * 0.45), rotX(x * 0.45), rotY(y * 0.45));
  local.Head = multiply(transpose(local.Neck), rest);
}

export const heelOf = (foot) => add(foot.ball, rotate(multiply(rotY(foot.yaw), rotX(foot.pitch)), BALL_TO_HEEL));
/** The ball's place of a foot that stands on its heel. */
export const ballFromHeel = (heel, yaw, pitch) => sub(heel, rotate(multiply(rotY(yaw), rotX(pitch)), BALL_TO_HEEL));

/** Text of a BVH file. poses: one per frame. */
export function writeBvh(poses, fps) {
  const lines = ["HIERARCHY"];
  const number = (x) => (Math.abs(x) < 5e-5 ? 0 : x).toFixed(4).replace(/\.?0+$/, "");
  const offset = (v) => `OFFSET ${v.map(number).join(" ")}`;
  const order = [];
  const put = (joint, depth) => {
    const tab = "  ".repeat(depth);
    order.push(joint.name);
    lines.push(`${tab}${joint.parent ? "JOINT" : "ROOT"} ${joint.name}`, `${tab}{`, `${tab}  ${offset(joint.offset)}`);
    lines.push(`${tab}  CHANNELS ${joint.parent ? "3" : "6 Xposition Yposition Zposition"} Zrotation Xrotation Yrotation`);
    for (const child of JOINTS.filter((j) => j.parent === joint.name)) put(child, depth + 1);
    if (joint.end) lines.push(`${tab}  End Site`, `${tab}  {`, `${tab}    ${offset(joint.end)}`, `${tab}  }`);
    lines.push(`${tab}}`);
  };
  put(JOINTS[0], 0);
  lines.push("MOTION", `Frames: ${poses.length}`, `Frame Time: ${(1 / fps).toFixed(10)}`);
  const previous = {};
  for (const pose of poses) {
    const short = (x, digits) => String(+x.toFixed(digits) + 0); // 0.005 degrees move a hand by less than 0.1 mm
    const values = pose.root.map((x) => short(x, 2));
    for (const name of order) {
      previous[name] = toZxy(pose.local[name] ?? identity, previous[name]);
      values.push(...previous[name].map((x) => short(x, 2)));
    }
    lines.push(values.join(" "));
  }
  return lines.join("\n") + "\n";
}
