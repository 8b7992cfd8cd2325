// A motion from a score: keys for the body, the arms and the head, steps for the feet, and the way of the centre of mass, which
// the hips follow, so that flights are true parabolas. Seconds, centimetres, degrees; everything repeats after one period.
import { easeKeys, follow, loopSpline, quintic } from "./curves.js";
import { multiply, rotate, rotX, rotY, rotZ } from "./rotation.js";
import { ANKLE_TO_BALL, BALL_HEIGHT, centreOfMass, HIP_HEIGHT, placeJoints, setArm, setHead, setSpine, solveLeg } from "./skeleton.js";
import { add, clamp, sub } from "./vec3.js";

export const FPS = 30;
const G = 981;
const SIDES = [
  ["Left", 1],
  ["Right", -1],
];
const OVER_FEET = 4.5; // that the centre of mass stands before the ankles
const STANCE = { x: 11, yaw: 9, splay: 7 };

/** The second half of a period is the mirror image of the first: keys of a middle track, and what changes sign. */
export const alternate = (half, keys, sign = -1) => [...keys, ...keys.map(([t, v]) => [t + half, sign * v])];
/** The same for the arms or feet: what one side does in the first half the other does in the second. */
export const swap = (half, a, b) => [...a, ...b.map(([t, ...rest]) => [t + half, ...rest])];

/** Height, or a way over the ground, with flights: [t, value] keys joined by quintics, free fall or constant speed in the air. */
function withFlights(period, keys, flights) {
  const nodes = [
    ...keys.map(([t, p]) => ({ t, p })),
    ...flights.flatMap((f) => [
      { t: f.start, p: f.p0, v: f.v0, a: f.a, flight: f },
      { t: f.end, p: f.p1, v: f.v1, a: f.a },
    ]),
  ].sort((a, b) => a.t - b.t);
  const n = nodes.length;
  const at = (i) => ({ ...nodes[((i % n) + n) % n], t: nodes[((i % n) + n) % n].t + Math.floor(i / n) * period });
  nodes.forEach((node, i) => {
    if (node.v !== undefined) return;
    const [a, c] = [at(i - 1), at(i + 1)];
    const turns = (node.p - a.p) * (c.p - node.p) <= 0;
    node.slope = turns ? 0 : (c.p - a.p) / (c.t - a.t);
  });
  const state = ({ p, v, slope, a = 0 }) => [p, v ?? slope, a];
  return (time) => {
    const t = nodes[0].t + ((((time - nodes[0].t) % period) + period) % period);
    let i = n - 1;
    while (i > 0 && nodes[i].t > t) i--;
    const from = nodes[i];
    if (from.flight) return from.p + from.v * (t - from.t) + (from.a * (t - from.t) ** 2) / 2;
    const to = at(i + 1);
    return quintic(from.t, state(from), to.t, state(to))(t);
  };
}

/** A flight of the centre of mass along one axis. */
const fall = ({ start, end, rise, fall: low }) => {
  const d = end - start;
  const v0 = (low - rise) / d + (G * d) / 2;
  return { start, end, p0: rise, p1: low, v0, v1: v0 - G * d, a: -G };
};
const glide =
  (axis) =>
  ({ start, end, [axis]: [p0, p1] = [0, 0] }) => ({
    start,
    end,
    p0,
    p1,
    v0: (p1 - p0) / (end - start),
    v1: (p1 - p0) / (end - start),
    a: 0,
  });

const smooth = (s) => s * s * s * (10 + s * (6 * s - 15));

/**
 * A foot from its steps [leave, land, place]: place { x, z, angle (of the whole stance about the origin), yaw, lift, heel (pitch as it
 * leaves), toes (as it lands), path: [[t, x, y, z]] (on its way) }; x outwards. Before the first step it stands where the last one ends.
 */
function makeFoot(sign, period, travel, { steps = [], heel = [[0, 0]], pivot = [[0, 0]], stand = {} }) {
  const placed = steps.map(([leave, land, place]) => ({
    leave,
    land,
    lift: 9,
    heel: 34,
    toes: 12,
    path: [],
    ...STANCE,
    z: 0,
    angle: 0,
    ...place,
  }));
  const still = { ...STANCE, z: 0, angle: 0, ...stand };
  const ballOf = ({ x, z, angle, shift }) => add(rotate(rotY(angle), [sign * x, BALL_HEIGHT, z + ANKLE_TO_BALL[2]]), [0, 0, shift]);
  const pitch = easeKeys(
    period,
    placed.length === 0
      ? [[0, 0]]
      : inOrder(
          period,
          placed.flatMap((s) => {
            const d = s.land - s.leave;
            return [
              [s.leave - Math.min(0.2, 0.5 * d), 0],
              [s.leave + 0.03, s.heel],
              [s.leave + 0.55 * d, 0.45 * s.heel],
              [s.land, s.toes],
              [s.land + 0.1, 0],
            ];
          }),
        ),
  );
  const bend = easeKeys(
    period,
    placed.length === 0
      ? [[0, 1]]
      : inOrder(
          period,
          placed.flatMap((s) => [
            [s.leave, 1],
            [s.leave + 0.4 * (s.land - s.leave), 0.25],
            [s.leave + 0.7 * (s.land - s.leave), 0.25],
            [s.land, 1],
          ]),
        ),
  );
  // A step may end in the next period, and stands until the one after it begins.
  const rounds = [-2, -1, 0].flatMap((k) =>
    placed.map((s) => ({ ...s, leave: s.leave + k * period, land: s.land + k * period, shift: k * travel })),
  );
  const [heelUp, turn] = [easeKeys(period, heel), loopSpline(period, pivot)];
  return (t, turned) => {
    const at = rounds.findLastIndex((s) => t >= s.leave);
    const now = rounds[at];
    const from = rounds[at - 1] ?? { ...still, shift: 0 };
    let [ball, yaw, air] = [ballOf(from), from.angle + sign * from.yaw, 0];
    if (now) {
      const s = clamp((t - now.leave) / (now.land - now.leave), 0, 1);
      const target = ballOf(now);
      const begin = ball;
      const turnBy = ((now.angle - from.angle + 540) % 360) - 180;
      yaw = from.angle + turnBy * smooth(s) + sign * (from.yaw + (now.yaw - from.yaw) * smooth(s));
      if (now.path.length > 0 && s < 1) {
        const keys = [
          [now.leave, ...begin],
          ...now.path.map(([time, x, y, z]) => [
            time + now.land - placed.find((p) => p.path === now.path).land,
            sign * x,
            BALL_HEIGHT + y,
            z + ANKLE_TO_BALL[2] + now.shift,
          ]),
          [now.land, ...target],
        ];
        ball = [1, 2, 3].map((k) => splineThrough(keys.map((key) => [key[0], key[k]]))(t));
      } else
        ball = add(
          begin,
          sub(target, begin).map((x) => x * smooth(s)),
        );
      air = now.path.length > 0 ? 0 : now.lift * (4 * s * (1 - s)) ** 1.3;
    }
    const p = pitch(t) + heelUp(t);
    return {
      ball: add(ball, [0, air, 0]),
      yaw: yaw + turn(t),
      pitch: p,
      toe: p > 0 ? -p * bend(t) : 0,
      splay: still.splay,
      knee: ((((yaw - turned) % 360) + 540) % 360) - 180,
    };
  };
}
const inOrder = (period, keys) => keys.map(([t, v]) => [((t % period) + period) % period, v]).sort((a, b) => a[0] - b[0]);

/** Quintics through keys, at rest at both ends, with the speed of the neighbours in between. */
function splineThrough(keys) {
  return (t) => {
    let i = keys.length - 2;
    while (i > 0 && keys[i][0] > t) i--;
    const slope = (k) => (k === 0 || k === keys.length - 1 ? 0 : (keys[k + 1][1] - keys[k - 1][1]) / (keys[k + 1][0] - keys[k - 1][0]));
    return quintic(keys[i][0], [keys[i][1], slope(i), 0], keys[i + 1][0], [keys[i + 1][1], slope(i + 1), 0])(t);
  };
}

/**
 * score: { period, cycles = 1, travel = 0 (cm along z in a period), flights: [{ start, end, rise, fall, x: [from, to], z }],
 *   mass: { x, y, z } keys over standing; body: { pitch, roll, yaw } of the hips, { curl, bend, twist } of the spine,
 *   { nod, tilt, look } of the head, all keys; spin: keys [t, degrees] that need not come back;
 *   arms: { Left, Right }: { forward, out, elbow, turn, wrist, shrug } keys; feet: { Left, Right }: see makeFoot }
 * Gives the poses, one for each frame.
 */
export function perform({ period, cycles = 1, travel = 0, flights = [], mass = {}, body = {}, spin = [[0, 0]], arms = {}, feet = {} }) {
  const frames = Math.round(period * FPS);
  const keysOf = (keys) => loopSpline(period, keys ?? [[0, 0]]);
  const sample = (curve) => Array.from({ length: frames }, (_, i) => curve(i / FPS));
  const tracks = Object.fromEntries(["pitch", "roll", "yaw", "curl", "bend", "twist"].map((name) => [name, keysOf(body[name])]));
  const head = Object.fromEntries(["nod", "tilt", "look"].map((name) => [name, follow(sample(keysOf(body[name])), FPS, 3.2, 0.6)]));
  const whole = splineThrough(
    spin.length > 1
      ? spin
      : [
          [0, 0],
          [period, 0],
        ],
  );
  const limb = Object.fromEntries(
    SIDES.map(([name]) => {
      const own = arms[name] ?? {};
      const track = (key, rest, frequency, damping) => follow(sample(loopSpline(period, own[key] ?? [[0, rest]])), FPS, frequency, damping);
      const out = track("out", 10, 6, 0.8);
      const late = follow(out, FPS, 2.6, 0.5);
      return [
        name,
        {
          forward: track("forward", 4, 6, 0.8),
          out,
          turn: track("turn", -12, 6, 0.9),
          shrug: track("shrug", 0, 5, 0.9),
          elbow: track("elbow", 18, 4.5, 0.65).map((x) => Math.max(4, x)),
          wrist: track("wrist", 0, 4, 0.6).map((x, i) => clamp(x + (late[i] - out[i]) * 0.4, -50, 50)),
        },
      ];
    }),
  );
  const foot = Object.fromEntries(SIDES.map(([name, sign]) => [name, makeFoot(sign, period, travel, feet[name] ?? {})]));
  const way = (axis, made) => (flights.length > 0 ? withFlights(period, mass[axis] ?? [], flights.map(made)) : keysOf(mass[axis]));
  const [x, y, z] = [way("x", glide("x")), way("y", fall), way("z", glide("z"))];

  const pose = (t, i, root) => {
    const turned = whole(t);
    const hips = multiply(rotY(turned + tracks.yaw(t)), rotX(tracks.pitch(t)), rotZ(-tracks.roll(t)));
    const local = { Hips: hips };
    setSpine(local, { pitch: tracks.curl(t), roll: tracks.bend(t), yaw: tracks.twist(t) });
    let stretch = 0;
    for (const [name] of SIDES) {
      const a = limb[name];
      setArm(local, name, {
        forward: a.forward[i],
        out: a.out[i],
        turn: a.turn[i] - 0.35 * clamp(a.out[i] - 60, 0, 90),
        elbow: a.elbow[i],
        wrist: a.wrist[i],
        shrug: a.shrug[i] + clamp((a.out[i] - 40) * 0.16, 0, 18),
      });
      stretch = Math.max(stretch, solveLeg(local, name, root, hips, foot[name](t, turned)));
    }
    setHead(local, placeJoints({ root, local }).turn, { pitch: head.nod[i], roll: head.tilt[i], yaw: turned + head.look[i] });
    return { root, local, stretch };
  };
  /** Moves the hips until the centre of mass is where it shall be. */
  const balance = (t, i, wanted) => {
    let root = [wanted[0], wanted[1] - 4, wanted[2]];
    let made;
    for (let k = 0; k < 12; k++) {
      made = pose(t, i, root);
      root = add(root, sub(wanted, centreOfMass(placeJoints(made).world)));
    }
    return made;
  };
  const standing = (() => {
    const local = {};
    for (const [name, sign] of SIDES) {
      solveLeg(local, name, [0, HIP_HEIGHT - 2.5, 0], [1, 0, 0, 0, 1, 0, 0, 0, 1], makeFoot(sign, 1, 0, {})(0, 0));
      setArm(local, name, { forward: 4, out: 10, turn: -12, elbow: 18, wrist: 0, shrug: 0 });
    }
    return centreOfMass(placeJoints({ root: [0, HIP_HEIGHT - 2.5, 0], local }).world)[1];
  })();
  const lap = Array.from({ length: frames }, (_, i) => {
    const t = i / FPS;
    const over = rotate(rotY(whole(t)), [0, 0, OVER_FEET]);
    return balance(t, i, [x(t) + over[0], standing + y(t), z(t) + over[2] + (travel * t) / period]);
  });
  return Array.from({ length: cycles * frames }, (_, i) => {
    const { root, local, stretch } = lap[i % frames];
    return { root: add(root, [0, 0, travel * Math.floor(i / frames)]), local, stretch };
  });
}
