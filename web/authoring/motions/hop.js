// A happy hop on the spot: to its left, to its right, then a big one with both arms up. Four seconds, loops.
// The centre of mass is authored and the hips follow from it, so that flights are true parabolas.
import { easeKeys, follow, loopSpline, quintic } from "../kit/curves.js";
import { multiply, rotX, rotY, rotZ } from "../kit/rotation.js";
import {
  ANKLE_TO_BALL, BALL_HEIGHT, centreOfMass, HIP_HEIGHT, placeJoints, setArm, setHead, setSpine, solveLeg,
} from "../kit/skeleton.js";
import { add, clamp, sub } from "../kit/vec3.js";

export const FPS = 60;
const PERIOD = 3.9;
const G = 981; // cm / s^2

// Each hop: take-off and landing, heights of the centre of mass there over standing, how high the feet come, where they land.
const HOPS = [
  { start: 0.62, end: 1.08, rise: 7.5, fall: 3, feet: 33, x: 13, z: 3 },
  { start: 1.55, end: 2.01, rise: 7.5, fall: 3, feet: 33, x: -13, z: 3 },
  { start: 2.5, end: 3.02, rise: 8, fall: 3, feet: 42, x: 0, z: 0 },
];
// Between them: the lowest points, and the rest at the end.
const LOWS = [
  { t: 0.36, y: -21, push: 900 },
  { t: 1.31, y: -20, push: 1500 },
  { t: 2.25, y: -22, push: 1400 },
  { t: 3.24, y: -23, push: 900 },
];
const OVER_FEET = 4.5; // cm that the centre of mass stands before the ankles

const launch = (hop) => {
  const duration = hop.end - hop.start;
  const up = (hop.fall - hop.rise) / duration + (G * duration) / 2;
  return { duration, up, down: up - G * duration };
};

/** Height of the centre of mass over standing. */
function heightCurve() {
  const pieces = [];
  const join = (t0, a, t1, b) => pieces.push({ t0, t1, at: quintic(t0, a, t1, b) });
  const rest = [PERIOD, [0, 0, 0]];
  HOPS.forEach((hop, i) => {
    const { up } = launch(hop);
    const before = i ? HOPS[i - 1] : null;
    const low = LOWS[i];
    const from = before ? [before.end, [before.fall, launch(before).down, -G]] : [0, [0, 0, 0]];
    join(from[0], from[1], low.t, [low.y, 0, low.push]);
    join(low.t, [low.y, 0, low.push], hop.start, [hop.rise, up, -G]);
    pieces.push({ t0: hop.start, t1: hop.end, at: (t) => hop.rise + up * (t - hop.start) - (G * (t - hop.start) ** 2) / 2 });
  });
  const last = HOPS.at(-1);
  join(last.end, [last.fall, launch(last).down, -G], LOWS[3].t, [LOWS[3].y, 0, LOWS[3].push]);
  join(LOWS[3].t, [LOWS[3].y, 0, LOWS[3].push], 3.6, [1.5, 0, -60]);
  join(3.6, [1.5, 0, -60], ...rest);
  return (t) => pieces.find((p) => t >= p.t0 - 1e-9 && t <= p.t1 + 1e-9).at(t);
}

/** x or z of the centre of mass: straight in flight, and a bounce against the landing side in between. */
function driftCurve(axis, offset) {
  const feet = [0, ...HOPS.map((hop) => hop[axis])];
  const pieces = [];
  HOPS.forEach((hop, i) => {
    const { duration } = launch(hop);
    const from = feet[i] + (feet[i + 1] - feet[i]) * 0.24;
    const to = feet[i + 1] - (feet[i + 1] - feet[i]) * 0.2;
    pieces.push({ t0: hop.start, t1: hop.end, p0: from, p1: to, v: (to - from) / duration });
  });
  return (t) => {
    const flight = pieces.find((p) => t >= p.t0 && t <= p.t1);
    if (flight) return offset + flight.p0 + flight.v * (t - flight.t0);
    const before = pieces.filter((p) => p.t1 < t).at(-1);
    const after = pieces.find((p) => p.t0 > t);
    if (before && after) return offset + quintic(before.t1, [before.p1, before.v, 0], after.t0, [after.p0, after.v, 0])(t);
    if (after) return offset + quintic(0, [0, 0, 0], after.t0, [after.p0, after.v, 0])(t);
    return offset + quintic(before.t1, [before.p1, before.v, 0], 3.75, [0, 0, 0])(Math.min(t, 3.75));
  };
}

const smooth = (s) => s * s * s * (10 + s * (6 * s - 15));

/** Place of one foot's ball, and where it is in its hop. */
function footPath(name, t) {
  const sign = name === "Left" ? 1 : -1;
  const places = [{ x: 0, z: 0 }, ...HOPS];
  let ball = [0, 0, 0];
  HOPS.forEach((hop, i) => {
    const s = clamp((t - hop.start) / (hop.end - hop.start), 0, 1);
    const [a, b] = [places[i], places[i + 1]];
    if (i === 0 || t >= hop.start) ball = [a.x + (b.x - a.x) * smooth(s), hop.feet * (4 * s * (1 - s)) ** 1.4, a.z + (b.z - a.z) * smooth(s)];
  });
  return add(ball, [sign * 11, BALL_HEIGHT, ANKLE_TO_BALL[2]]);
}

// Keys of everything else. Left and right swap between the first hop and the second.
const spline = (keys) => loopSpline(PERIOD, keys);
const pitchKeys = HOPS.flatMap((hop, i) => [
  [hop.start - 0.19, 0],
  [hop.start + 0.025, 66],
  [(hop.start + hop.end) / 2 + 0.02, i === 2 ? 50 : 42],
  [hop.end, 30],
  [hop.end + 0.085, 0],
]);
const footPitch = easeKeys(PERIOD, pitchKeys);
const toeFlat = easeKeys(PERIOD, HOPS.flatMap((h) => [[h.start - 0.02, 1], [h.start + 0.1, 0.25], [h.end - 0.08, 0.25], [h.end, 1]]));

const body = {
  pitch: spline([[0, 2], [0.34, 27], [0.62, 3], [0.82, -3], [1.08, 9], [1.3, 25], [1.55, 3], [1.75, -3], [2.01, 9], [2.24, 28], [2.5, 1], [2.72, -7], [3.02, 10], [3.22, 29], [3.52, 1], [3.7, 2]]),
  curl: spline([[0, 2], [0.33, 26], [0.6, -2], [0.84, -7], [1.1, 8], [1.3, 22], [1.53, -2], [1.78, -7], [2.03, 8], [2.24, 26], [2.48, -6], [2.75, -13], [3.04, 10], [3.24, 27], [3.5, -1], [3.7, 2]]),
  roll: spline([[0, 0], [0.36, -5], [0.66, 6], [0.86, 9], [1.12, 4], [1.31, 8], [1.58, -6], [1.8, -9], [2.05, -4], [2.25, -7], [2.52, 1], [2.76, 2], [3.05, 0], [3.3, 0], [3.6, 0]]),
  yaw: spline([[0, 0], [0.36, -8], [0.85, 15], [1.3, 10], [1.8, -15], [2.25, -8], [2.75, 0], [3.25, 0], [3.6, 0]]),
  nod: spline([[0, 0], [0.3, 16], [0.6, -8], [0.86, -10], [1.1, 4], [1.32, 14], [1.55, -8], [1.8, -10], [2.05, 4], [2.27, 16], [2.5, -10], [2.76, -16], [3.05, 6], [3.28, 18], [3.55, -3], [3.75, 0]]),
  splay: spline([[0, 6], [0.36, 16], [0.62, 6], [0.85, 14], [1.08, 8], [1.3, 18], [1.55, 6], [1.78, 14], [2.01, 8], [2.25, 18], [2.5, 5], [2.76, 12], [3.02, 8], [3.24, 20], [3.6, 6]]),
};

/** The arm on the side that the first hop goes to; the other one is the same, one hop later. */
const leading = {
  forward: [[0, 6], [0.32, -48], [0.52, 10], [0.68, 62], [0.86, 36], [1.08, 24], [1.28, -22], [1.48, 4], [1.64, 40], [1.8, 34], [2.01, 12], [2.22, -46], [2.42, 20], [2.58, 58], [2.78, 18], [3.02, 12], [3.24, -16], [3.48, -6], [3.7, 8]],
  out: [[0, 14], [0.32, 20], [0.52, 30], [0.68, 96], [0.86, 138], [1.06, 104], [1.28, 34], [1.48, 28], [1.64, 44], [1.82, 58], [2.01, 46], [2.22, 24], [2.42, 40], [2.58, 108], [2.76, 150], [3.0, 118], [3.24, 38], [3.48, 18], [3.7, 15]],
  elbow: [[0, 22], [0.32, 30], [0.52, 52], [0.7, 48], [0.88, 22], [1.1, 32], [1.3, 52], [1.5, 64], [1.66, 62], [1.84, 50], [2.05, 50], [2.24, 34], [2.42, 58], [2.6, 46], [2.78, 14], [3.04, 30], [3.27, 58], [3.5, 30], [3.7, 20]],
};
const trailing = {
  forward: [[0, 6], [0.32, -48], [0.52, 4], [0.68, 40], [0.86, 34], [1.08, 12], [1.28, -26], [1.48, 10], [1.62, 62], [1.8, 36], [2.01, 24], [2.22, -46], [2.42, 20], [2.58, 58], [2.78, 18], [3.02, 12], [3.24, -16], [3.48, -6], [3.7, 8]],
  out: [[0, 14], [0.32, 20], [0.52, 26], [0.68, 42], [0.86, 58], [1.06, 46], [1.28, 28], [1.46, 34], [1.62, 98], [1.8, 138], [2.01, 104], [2.22, 26], [2.42, 40], [2.58, 108], [2.76, 150], [3.0, 118], [3.24, 38], [3.48, 18], [3.7, 15]],
  elbow: [[0, 22], [0.32, 30], [0.52, 60], [0.7, 62], [0.88, 50], [1.1, 50], [1.3, 48], [1.48, 58], [1.64, 46], [1.82, 22], [2.05, 34], [2.24, 34], [2.42, 58], [2.6, 46], [2.78, 14], [3.04, 30], [3.27, 58], [3.5, 30], [3.7, 20]],
};

const sample = (curve) => Array.from({ length: Math.round(PERIOD * FPS) }, (_, i) => curve(i / FPS));
/** What hangs on the body comes late and swings past. */
function lateArm(keys) {
  const [forward, out, elbow] = [keys.forward, keys.out, keys.elbow].map((k) => sample(spline(k)));
  const late = follow(out, FPS, 2.6, 0.45);
  return {
    forward: follow(forward, FPS, 9, 0.9),
    out: follow(out, FPS, 9, 0.9),
    elbow: follow(elbow, FPS, 5, 0.6).map((x) => Math.max(4, x)),
    wrist: out.map((x, i) => clamp((late[i] - x) * 0.5, -38, 38)),
  };
}
const arms = { Left: lateArm(leading), Right: lateArm(trailing) };
const nod = follow(sample(body.nod), FPS, 3.2, 0.5);
const headRoll = follow(sample(body.roll), FPS, 2.4, 0.45);

/** Everything but the hips' place. */
function pose(t, frame, root) {
  const hips = multiply(rotY(body.yaw(t)), rotX(body.pitch(t)), rotZ(-body.roll(t)));
  const local = { Hips: hips };
  setSpine(local, { pitch: body.curl(t), roll: body.roll(t) * 0.9, yaw: body.yaw(t) * 0.6 });
  let stretch = 0;
  for (const name of ["Left", "Right"]) {
    const a = arms[name];
    const raised = a.out[frame];
    setArm(local, name, {
      forward: a.forward[frame], out: raised, turn: -0.35 * clamp(raised - 60, 0, 90), elbow: a.elbow[frame], wrist: a.wrist[frame], shrug: clamp((raised - 40) * 0.16, 0, 18),
    });
    const sign = name === "Left" ? 1 : -1;
    const pitch = footPitch(t);
    const foot = { ball: footPath(name, t), yaw: sign * 9, pitch, toe: -pitch * toeFlat(t), splay: body.splay(t) };
    stretch = Math.max(stretch, solveLeg(local, name, root, hips, foot));
  }
  const { turn } = placeJoints({ root, local });
  setHead(local, turn, { pitch: nod[frame], roll: headRoll[frame] * 0.5, yaw: body.yaw(t) * 0.7 });
  return { root, local, stretch };
}

/** Moves the hips until the centre of mass is where it shall be. */
function balance(t, frame, wanted) {
  let root = [wanted[0], wanted[1] - 4, wanted[2]];
  let made;
  for (let k = 0; k < 12; k++) {
    made = pose(t, frame, root);
    root = add(root, sub(wanted, centreOfMass(placeJoints(made).world)));
  }
  return made;
}

export function makeHop() {
  const standing = centreOfMass(placeJoints(pose(0, 0, [0, HIP_HEIGHT - 2.5, 0])).world)[1];
  const [height, x, z] = [heightCurve(), driftCurve("x", 0), driftCurve("z", OVER_FEET)];
  const frames = Math.round(PERIOD * FPS);
  return Array.from({ length: frames }, (_, i) => {
    const t = i / FPS;
    return balance(t, i, [x(t), standing + height(t), z(t)]);
  });
}
