// Bodies that hostile models are made of: bones of a person, a horse and a bird, as fields for one closed surface or as shells.
import { polygonise } from "../kit/polygonise.js";
import { ellipsoid, limb, sphere, union } from "../kit/sdf.js";
import { add, scale } from "../kit/vec3.js";

const mirror = ([x, y, z]) => [-x, y, z];

/** Degrees below the level that the arms point: T pose 0, A pose 45, hanging 80. */
export const POSES = { t: 0, a: 45, hanging: 80 };

/**
 * Places of a person 1.7 m tall, facing +z, its left at +x. gap: between the legs, metres; out: how far the shoulders lie out;
 * stride: how far the left foot and the right hand are forward, and the others back.
 * Gives { joints, bones }: bones are { name, a, b, ra, rb } with radii.
 */
export function person(pose = "a", { gap = 0.06, out = 0.2, stride = 0 } = {}) {
  const angle = (POSES[pose] * Math.PI) / 180;
  const arm = [Math.cos(angle), -Math.sin(angle), 0];
  const leg = gap / 2 + 0.075;
  const left = {
    shoulder: [out, 1.37, 0],
    elbow: add([out, 1.37, -0.01], scale(arm, 0.28)),
    wrist: add([out, 1.37, 0], scale(arm, 0.53)),
    hand: add([out, 1.37, 0.01], scale(arm, 0.66)),
    hip: [leg, 0.92, 0],
    knee: [leg, 0.5, 0.01],
    ankle: [leg, 0.09, -0.02],
    toe: [leg, 0.045, 0.13],
  };
  const joints = { hips: [0, 0.96, 0], chest: [0, 1.26, 0], neck: [0, 1.42, 0], head: [0, 1.58, 0.01] };
  for (const [name, place] of Object.entries(left)) Object.assign(joints, { [`left-${name}`]: place, [`right-${name}`]: mirror(place) });
  for (const [name, share] of [
    ["elbow", -0.5],
    ["wrist", -0.9],
    ["hand", -1],
    ["knee", 0.5],
    ["ankle", 1],
    ["toe", 1],
  ]) {
    joints[`left-${name}`] = add(joints[`left-${name}`], [0, 0, share * stride]);
    joints[`right-${name}`] = add(joints[`right-${name}`], [0, 0, -share * stride]);
  }
  const side = (s) =>
    [
      ["upper-arm", "shoulder", "elbow", 0.055, 0.045],
      ["forearm", "elbow", "wrist", 0.045, 0.035],
      ["hand", "wrist", "hand", 0.04, 0.035],
      ["thigh", "hip", "knee", 0.074, 0.055],
      ["shin", "knee", "ankle", 0.055, 0.04],
      ["foot", "ankle", "toe", 0.048, 0.04],
    ].map(([name, a, b, ra, rb]) => ({ name: `${s}-${name}`, a: joints[`${s}-${a}`], b: joints[`${s}-${b}`], ra, rb }));
  const bones = [
    { name: "belly", a: joints.hips, b: [0, 1.1, 0], ra: 0.125, rb: 0.115 },
    { name: "chest", a: [0, 1.12, 0], b: [0, 1.3, 0], ra: 0.12, rb: 0.125 },
    { name: "neck", a: [0, 1.36, 0], b: joints.neck, ra: 0.055, rb: 0.05 },
    ...side("left"),
    ...side("right"),
  ];
  return { joints, bones };
}

/** Where each limb ends: what should be found. */
export function personLimbs({ joints }) {
  return {
    head: [0, 1.7, 0.01],
    "left-hand": joints["left-hand"],
    "right-hand": joints["right-hand"],
    "left-foot": joints["left-toe"],
    "right-foot": joints["right-toe"],
  };
}

const boneField = ({ a, b, ra, rb }) =>
  limb(
    [
      [...a, ra],
      [...b, rb],
    ],
    2,
  );

/** One closed surface of about (1.4 / step)^2 vertices. */
export function personSurface(body, { step = 0.026, fillet = 0.03 } = {}) {
  const { joints, bones } = body;
  const field = union(
    fillet,
    ...bones.map(boneField),
    limb(
      [
        [...joints["left-shoulder"], 0.06],
        [...joints["right-shoulder"], 0.06],
      ],
      2,
    ),
    limb(
      [
        [...joints["left-hip"], 0.074],
        [...joints["right-hip"], 0.074],
      ],
      2,
    ),
    ellipsoid(joints.head, [0.085, 0.12, 0.1]),
    sphere([0, 1.56, 0.11], 0.02),
  );
  return surfaceOf(field, step);
}

export function surfaceOf(field, step) {
  const grow = 2 * step;
  return polygonise(field, [field.low.map((x) => x - grow), field.high.map((x) => x + grow)], step);
}

/** A horse 1.5 m tall with four legs, facing +z; near: how far apart its front hooves are; stride: how far each is forward or back. */
export function horse({ near = 0.22, stride = 0 } = {}) {
  const legs = [
    ["left-forefoot", near / 2, 0.42, stride],
    ["right-forefoot", -near / 2, 0.42, -stride],
    ["left-hindfoot", 0.12, -0.45, -0.6 * stride],
    ["right-hindfoot", -0.12, -0.45, 0.8 * stride],
  ].map(([name, x, z, step]) => ({ name, a: [x, 0.78, z], b: [x, 0.06, z + step], ra: 0.085, rb: 0.042 }));
  const bones = [
    { name: "barrel", a: [0, 0.86, 0.36], b: [0, 0.88, -0.38], ra: 0.2, rb: 0.21 },
    { name: "neck", a: [0, 0.98, 0.45], b: [0, 1.33, 0.66], ra: 0.13, rb: 0.085 },
    { name: "muzzle", a: [0, 1.38, 0.68], b: [0, 1.22, 0.96], ra: 0.09, rb: 0.055 },
    ...legs,
  ];
  const limbs = Object.fromEntries(legs.map(({ name, b }) => [name, [b[0], 0.03, b[2]]]));
  return { bones, limbs: { head: [0, 1.22, 1], ...limbs } };
}

export const tail = { name: "tail", a: [0, 0.98, -0.58], b: [0, 0.62, -0.95], ra: 0.045, rb: 0.03 };
export const ears = [1, -1].map((s) => ({
  name: s > 0 ? "left-ear" : "right-ear",
  a: [0.05 * s, 1.44, 0.64],
  b: [0.09 * s, 1.6, 0.6],
  ra: 0.03,
  rb: 0.014,
}));

export const fieldOf = (bones, fillet = 0.03) => union(fillet, ...bones.map(boneField));
