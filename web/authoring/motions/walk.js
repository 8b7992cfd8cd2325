// A walk with weight: six steps along +Z at 1.2 m/s. The pose loops; the place travels on.
import { easeKeys, follow, loopSpline, quintic } from "../kit/curves.js";
import { multiply, rotX, rotY, rotZ, rotate } from "../kit/rotation.js";
import {
  ANKLE_TO_BALL, BALL_HEIGHT, ballFromHeel, heelOf, placeJoints, setArm, setHead, setSpine, solveLeg,
} from "../kit/skeleton.js";
import { add, clamp, sub } from "../kit/vec3.js";

export const FPS = 60;
const CYCLE = 1.1; // seconds for two steps
const STRIDE = 126; // cm per cycle
const CYCLES = 3;
const LIFT_OFF = 0.62; // share of the cycle that a foot stands
const WIDTH = 7.5; // cm from the middle to each foot

// Everything of one side is a function of its phase: 0 is its heel strike, the other side is half a cycle on.
const phased = (keys) => loopSpline(1, keys);
const footPitch = easeKeys(1, [[0, -17], [0.1, 0], [0.37, 0], [0.65, 56], [0.67, 56], [0.93, -17]]);
const toeBend = easeKeys(1, [[0, 0], [0.1, 1], [0.33, 1], [0.62, 1], [0.8, 0.2], [0.95, 0]]);

/** The foot on the ground: rolls over the heel, lies flat, rolls over the ball. `z` of the flat ball is 0. */
function standingBall(phase) {
  const pitch = footPitch(phase);
  const flat = [0, BALL_HEIGHT, 0];
  if (pitch >= 0) return flat;
  return ballFromHeel(heelOf({ ball: flat, yaw: 0, pitch: 0 }), 0, pitch);
}
const ankleAt = (ball, pitch) => sub(ball, rotate(rotX(pitch), ANKLE_TO_BALL));

/** From lift-off to the next strike the ankle follows one polynomial per axis that leaves and arrives with the foot's own speed. */
function makeSwing() {
  const h = 1e-3;
  const ankle = (phase) => ankleAt(standingBall(phase), footPitch(phase));
  const state = (phase, k, shift) => {
    const [a, b, c] = [-h, 0, h].map((d) => ankle(phase + d)[k] + shift);
    return [b, (c - a) / (2 * h), (a - 2 * b + c) / (h * h)];
  };
  // Half a metre per second is left when the heel strikes; coming to rest in the air, the leg would have to reach too far.
  const arrive = (k) => (k === 2 ? [state(1 + h, k, STRIDE)[0], 62, -900] : state(1 + h, k, 0));
  const curve = (k) => quintic(LIFT_OFF, state(LIFT_OFF - h, k, 0), 1, arrive(k));
  const [up, along] = [curve(1), curve(2)];
  const clearance = easeKeys(1, [[LIFT_OFF, 0], [0.76, 1], [1, 0]]);
  return (phase) => [0, up(phase) + 4 * clearance(phase), along(phase)];
}
const swing = makeSwing();

function footAt(sign, t) {
  const total = t / CYCLE + (sign > 0 ? 0 : 0.5) + 4;
  const phase = total % 1;
  const pitch = footPitch(phase);
  const start = (Math.floor(total) - 4 - (sign > 0 ? 0 : 0.5)) * STRIDE;
  const ball = phase <= LIFT_OFF ? standingBall(phase) : add(swing(phase), rotate(rotX(pitch), ANKLE_TO_BALL));
  const inward = phase > LIFT_OFF ? -1.5 * Math.sin((Math.PI * (phase - LIFT_OFF)) / (1 - LIFT_OFF)) ** 2 : 0;
  return { ball: add(ball, [sign * (WIDTH + inward), 0, start]), pitch, toe: pitch > 0 ? -pitch * toeBend(phase) : 0, yaw: sign * 5, splay: 3, phase };
}

// The trunk, in phases of the left heel. Lowest just after each strike, highest over the standing leg.
const bob = phased([[0.0, -1.7], [0.1, -3.0], [0.33, 2.6], [0.5, -1.7], [0.6, -3.0], [0.83, 2.6]]);
const sway = phased([[0.05, 0.6], [0.3, 3.0], [0.55, -0.6], [0.8, -3.0]]);
const surge = phased([[0.0, 0.8], [0.2, -0.4], [0.35, -0.8], [0.5, 0.8], [0.7, -0.4], [0.85, -0.8]]);
const list = phased([[0.0, 0], [0.16, 4.2], [0.4, 1], [0.5, 0], [0.66, -4.2], [0.9, -1]]); // the free side drops
const turn = phased([[0, -7], [0.25, 0], [0.5, 7], [0.75, 0]]); // the side of the leading foot comes forward
const lean = phased([[0.05, 5], [0.3, 2], [0.55, 5], [0.8, 2]]);
const MEAN_HIPS = 87.4;
const HIPS_BEHIND = 47; // cm behind the ball of the flat foot at its strike

const armSwing = phased([[0.0, -25], [0.25, -3], [0.5, 27], [0.75, 4]]); // opposite to the leg of its side
const elbowBend = phased([[0.0, 14], [0.25, 20], [0.52, 40], [0.78, 26]]);

const frames = Math.round(CYCLE * FPS);
const sample = (curve) => Array.from({ length: frames }, (_, i) => curve(i / frames));
const late = {
  arm: follow(sample(armSwing), FPS, 2.2, 0.8),
  elbow: follow(sample(elbowBend), FPS, 2.2, 0.6),
  wrist: follow(sample(armSwing), FPS, 1.9, 0.5),
  nod: follow(sample((p) => 3 + bob(p) * 0.8), FPS, 3, 0.5),
};

function pose(frame) {
  const t = frame / FPS;
  const phase = (t / CYCLE) % 1;
  const hips = multiply(rotY(turn(phase)), rotX(lean(phase)), rotZ(list(phase)));
  const root = [sway(phase), MEAN_HIPS + bob(phase), (t / CYCLE) * STRIDE - HIPS_BEHIND + surge(phase)];
  const local = { Hips: hips };
  setSpine(local, { pitch: 1 + 0.4 * lean(phase), roll: list(phase) * 1.35, yaw: -turn(phase) * 1.9 });
  let stretch = 0;
  for (const [name, sign] of [["Left", 1], ["Right", -1]]) {
    stretch = Math.max(stretch, solveLeg(local, name, root, hips, footAt(sign, t)));
    const i = (frame + (sign > 0 ? 0 : frames / 2)) % frames;
    setArm(local, name, { forward: late.arm[i], out: 9 + 2 * Math.abs(late.arm[i]) / 25, turn: -12, elbow: late.elbow[i], wrist: clamp((armSwing(i / frames) - late.wrist[i]) * 0.4, -12, 12), shrug: 0 });
  }
  setHead(local, placeJoints({ root, local }).turn, { pitch: late.nod[frame % frames], roll: -list(phase) * 0.15, yaw: turn(phase) * 0.1 });
  return { root, local, stretch };
}

export const makeWalk = () => Array.from({ length: frames * CYCLES }, (_, i) => pose(i));
/** How far the loop travels. */
export const TRAVELS = [0, 0, STRIDE * CYCLES];
