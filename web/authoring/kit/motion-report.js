// How believable a motion is, in figures: the same definitions of contact and flight as the engine's.
import { ANKLE_HEIGHT, BALL_HEIGHT, centreOfMass, placeJoints, JOINTS } from "./skeleton.js";
import { angleBetween, identity } from "./rotation.js";
import { distance } from "./vec3.js";

const G = 981;

/** Frames in which a toe or an ankle is lower than 4 cm over its lowest within 1.4 s and slower than 0.7 m/s. */
function contactsOf(worlds, side, fps) {
  const low = (name) => {
    const reach = Math.round(0.7 * fps);
    return worlds.map((w, i) => {
      const floor = Math.min(...worlds.slice(Math.max(0, i - reach), i + reach + 1).map((x) => x[name][1]));
      const [a, b] = [worlds[Math.max(0, i - 1)][name], worlds[Math.min(worlds.length - 1, i + 1)][name]];
      const speed = (distance(a, b) * fps) / (Math.min(worlds.length - 1, i + 1) - Math.max(0, i - 1));
      return { over: w[name][1] - floor, touch: w[name][1] - floor < 4 && speed < 70 };
    });
  };
  const [toe, ankle] = [low(`${side}Toe`), low(`${side}Foot`)];
  return toe.map((x, i) => ({
    touch: x.touch || ankle[i].touch,
    clear: Math.min(x.over, ankle[i].over) > 4.5,
    over: Math.min(x.over, ankle[i].over),
  }));
}

const runs = (flags) => {
  const out = [];
  flags.forEach((on, i) => on && (out.at(-1)?.[1] === i ? (out.at(-1)[1] = i + 1) : out.push([i, i + 1])));
  return out;
};

/** Acceleration of a height curve over a run, by a least-squares parabola. */
function fittedAcceleration(y, [a, b], fps) {
  const n = b - a;
  const ts = Array.from({ length: n }, (_, i) => (i - (n - 1) / 2) / fps);
  const [s0, s2, s4] = [0, 2, 4].map((k) => ts.reduce((s, t) => s + t ** k, 0));
  const r0 = ts.reduce((s, _, i) => s + y[a + i], 0);
  const r2 = ts.reduce((s, t, i) => s + y[a + i] * t * t, 0);
  return (2 * (s0 * r2 - s2 * r0)) / (s0 * s4 - s2 * s2);
}

/** travels: how far the loop moves on, or null. Lengths in centimetres unless named otherwise. */
export function reportMotion(poses, fps, { travels }) {
  const worlds = poses.map((p) => placeJoints(p).world);
  const names = JOINTS.map((j) => j.name);
  const com = worlds.map((w) => centreOfMass(w)[1]);
  const mean = worlds.map((w) => names.reduce((s, n) => s + w[n][1], 0) / names.length);
  const sides = ["Left", "Right"].map((side) => contactsOf(worlds, side, fps));
  const clear = poses.map((_, i) => sides.every((s) => s[i].clear));
  const flights = runs(clear).map((run) => ({
    frames: run,
    seconds: +((run[1] - run[0]) / fps).toFixed(3),
    clearance: +Math.max(...sides[0].slice(...run).map((x) => x.over)).toFixed(1),
    massOverG: +(-fittedAcceleration(com, run, fps) / G).toFixed(3),
    jointMeanOverG: +(-fittedAcceleration(mean, run, fps) / G).toFixed(3),
  }));
  // Planted: the ball lies on the floor.
  const slide = ["Left", "Right"].map((side) => {
    const ball = (i) => worlds[i][`${side}Toe`];
    const planted = runs(poses.map((_, i) => ball(i)[1] < BALL_HEIGHT + 0.01));
    return Math.max(
      0,
      ...planted.map(([a, b]) =>
        Math.max(...Array.from({ length: b - a }, (_, k) => Math.hypot(ball(a + k)[0] - ball(a)[0], ball(a + k)[2] - ball(a)[2]))),
      ),
    );
  });
  const step = (i, j) => names.map((n) => angleBetween(poses[i].local[n] ?? identity, poses[j].local[n] ?? identity));
  const turns = poses.slice(1).map((_, i) => step(i, i + 1));
  const fastest = Math.max(...turns.flat());
  const fastestFrame = turns.findIndex((row) => row.includes(fastest));
  const n = poses.length;
  // A jump at the seam shows as a second difference larger than elsewhere.
  const bend = (i) =>
    Math.max(
      ...names.map((name) => {
        const at = (k) => {
          const shift = travels && k >= n ? travels : [0, 0, 0];
          const w = worlds[((k % n) + n) % n][name];
          return w.map((x, c) => x + shift[c]);
        };
        const [a, b, c] = [at(i), at(i + 1), at(i + 2)];
        return Math.hypot(...a.map((_, k) => a[k] - 2 * b[k] + c[k]));
      }),
    );
  const inner = Array.from({ length: n - 2 }, (_, i) => bend(i));
  return {
    frames: n,
    seconds: +(n / fps).toFixed(2),
    stretch: +Math.max(...poses.map((p) => p.stretch)).toFixed(4),
    lowestToeEnd: +Math.min(...worlds.flatMap((w) => [w["LeftToe_end"][1], w["RightToe_end"][1]])).toFixed(2),
    lowestAnkle: +(Math.min(...worlds.flatMap((w) => [w.LeftFoot[1], w.RightFoot[1]])) - ANKLE_HEIGHT).toFixed(2),
    slideMillimetres: slide.map((x) => +(10 * x).toFixed(3)),
    contacts: sides.map((s) =>
      runs(s.map((x) => x.touch))
        .map((r) => r.join("-"))
        .join(" "),
    ),
    flights,
    fastestTurn: `${fastest.toFixed(1)} deg per frame, ${names[turns[fastestFrame].indexOf(fastest)]} at ${fastestFrame}`,
    seamTurn: `${Math.max(...step(n - 1, 0)).toFixed(2)} deg`,
    secondDifference: {
      worst: `${Math.max(...inner).toFixed(2)} cm at ${inner.indexOf(Math.max(...inner))}`,
      seam: `${Math.max(bend(n - 2), bend(n - 1)).toFixed(2)} cm`,
    },
  };
}
