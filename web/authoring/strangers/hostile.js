// Models that are odd on purpose, each with the truth about it: which way is up and front, and where its limbs end.
import { mkdirSync, writeFileSync } from "node:fs";
import { encodePng } from "../kit/png.js";
import { limb, sphere, union } from "../kit/sdf.js";
import { rotX, rotY, rotZ, rotate } from "../kit/rotation.js";
import { add, cross, mix, normalize, scale, sub } from "../kit/vec3.js";
import { ears, fieldOf, horse, person, personLimbs, personSurface, surfaceOf, tail } from "./bodies.js";
import { glbBytes, objText } from "./files.js";
import { Shells } from "./shells.js";

export { glbBytes, objText };

const UPRIGHT = { up: "+y", front: "+z" };

/** Uniform in 0 .. 1, the same each time. */
function dice(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Shells with a truth, as flat arrays. */
function model(what, shells, truth, rest = {}) {
  return {
    what,
    format: "obj",
    positions: Float64Array.from(shells.positions.flat()),
    faces: Uint32Array.from(shells.faces.flat()),
    parts: shells.parts,
    truth: { ...UPRIGHT, ...truth },
    ...rest,
  };
}

const personTruth = (body) => ({ limbs: personLimbs(body) });
const surface = (name, mesh) => new Shells().mesh(name, mesh);

/** A person of one closed surface, and what `change` makes of its shells. */
function surfacePerson(what, pose = "a", options = {}, change = (shells) => shells) {
  const body = person(pose, options);
  return model(what, change(surface("body", personSurface(body, options)), body), personTruth(body));
}

function boneShells(shells, bones, options) {
  for (const { name, a, b, ra, rb } of bones) shells.capsule(name, a, b, ra, rb, options);
  return shells;
}

/** A person of one capsule for each bone and a ball for each joint. */
function shellPerson(body, options) {
  const shells = boneShells(new Shells(), body.bones, options);
  shells.ball("head", body.joints.head, [0.085, 0.12, 0.1]);
  shells.ball("nose", [0, 1.56, 0.11], 0.02);
  return shells;
}

/** Fingers, toes, eyes, ears and balls at the joints: 73 shells that only touch. */
function mannequin() {
  const body = person("t");
  const { joints } = body;
  const shells = shellPerson(body);
  for (const s of [1, -1]) {
    const side = s > 0 ? "left" : "right";
    const radii = { shoulder: 0.062, elbow: 0.05, wrist: 0.04, hip: 0.08, knee: 0.06, ankle: 0.046 };
    for (const [joint, radius] of Object.entries(radii))
      shells.ball(`${side}-${joint}`, joints[`${side}-${joint}`], radius, { around: 8, rings: 5 });
    for (let k = 0; k < 5; k++) {
      const root = add(joints[`${side}-hand`], [0.02 * s, 0, 0.03 - 0.015 * k]);
      for (let n = 0; n < 3; n++) {
        const at = (t) => add(root, [s * t * 0.028, 0, 0]);
        shells.capsule(`${side}-finger-${k}-${n}`, at(n + 0.2), at(n + 0.9), 0.007, 0.006, { around: 6 });
      }
      const toe = add(joints[`${side}-toe`], [s * (0.026 - 0.013 * k), -0.015, 0.035]);
      shells.capsule(`${side}-toe-${k}`, toe, add(toe, [0, 0, 0.025]), 0.009, 0.008, { around: 6 });
    }
    shells.ball(`${side}-eye`, [0.035 * s, 1.6, 0.1], 0.016, { around: 8, rings: 5 });
    shells.ball(`${side}-ear`, [0.09 * s, 1.58, 0], [0.012, 0.03, 0.02], { around: 8, rings: 5 });
  }
  const limbs = personLimbs(body);
  for (const side of ["left", "right"]) limbs[`${side}-hand`] = add(limbs[`${side}-hand`], [side === "left" ? 0.1 : -0.1, 0, 0]);
  return model("a mannequin of shells that only touch", shells, { limbs });
}

/** The clothes are bones grown by 2 cm, open at the ends, a body of its own beneath. */
function hoodie() {
  const body = person("a");
  const shells = surface("body", personSurface(body, { step: 0.03 }));
  const grown = (bone) => ({ ...bone, ra: bone.ra + 0.022, rb: bone.rb + 0.022 });
  const dressed = body.bones.filter(({ name }) => !/hand|foot|neck/.test(name)).map(grown);
  boneShells(shells, dressed, { open: true, around: 14 });
  shells.ball("hood", [0, 1.55, -0.05], [0.13, 0.15, 0.1]);
  for (const side of ["left", "right"]) shells.box(`${side}-sole`, add(body.joints[`${side}-toe`], [0, -0.04, -0.06]), [0.05, 0.015, 0.14]);
  return model("a body under a hoodie, soles under its feet", shells, personTruth(body));
}

/** Faces through `pick(triangle corners, n)`: null drops one. */
function reface(shells, pick) {
  const faces = shells.faces.flatMap((face, n) => {
    const changed = pick(face, n);
    return changed ? [changed] : [];
  });
  return Object.assign(new Shells(), { positions: shells.positions, faces, parts: [{ name: "body", first: 0, count: faces.length }] });
}

function soup(shells) {
  const next = dice(3);
  const out = new Shells();
  return out.part("soup", () => {
    for (const face of shells.faces) {
      const first = out.vertices(face.map((v) => shells.positions[v].map((x) => x + 0.0004 * (next() - 0.5))));
      out.faces.push([first, first + 1, first + 2]);
    }
  });
}

function split(shells) {
  const middle = new Map();
  const out = new Shells();
  out.positions = [...shells.positions];
  const between = (a, b) => {
    const key = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    if (!middle.has(key)) middle.set(key, out.positions.push(mix(out.positions[a], out.positions[b], 0.5)) - 1);
    return middle.get(key);
  };
  out.part("body", () => {
    for (const [a, b, c] of shells.faces) {
      const [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
      out.faces.push([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]);
    }
  });
  return out;
}

/** Turned as a file may hold it: the truth turns along. */
function turned(what, matrix, made, offset = [0, 0, 0]) {
  const positions = Float64Array.from(made.positions);
  for (let i = 0; i < positions.length; i += 3) positions.set(add(rotate(matrix, positions.subarray(i, i + 3)), offset), i);
  const axis = (name) => {
    const sign = name[0] === "-" ? -1 : 1;
    const unit = [0, 1, 2].map((k) => ("xyz"[k] === name[1] ? sign : 0));
    const to = rotate(matrix, unit);
    const k = to.findIndex((x) => Math.abs(x) > 0.5);
    return `${to[k] > 0 ? "+" : "-"}${"xyz"[k]}`;
  };
  const limbs = Object.fromEntries(Object.entries(made.truth.limbs).map(([key, place]) => [key, add(rotate(matrix, place), offset)]));
  return { ...made, what, positions, truth: { up: axis(made.truth.up), front: made.truth.front && axis(made.truth.front), limbs } };
}

/** An outline without thickness, as a sheet: rods' flat cousins in one plane. */
function paperMan() {
  const body = person("a");
  const shells = new Shells();
  const flat = ([x, y]) => [x, y, 0];
  for (const { name, a, b, ra, rb } of body.bones) {
    const [p, q] = [flat(a), flat(b)];
    const long = sub(q, p);
    const side = /foot/.test(name) ? [0.08, 0, 0] : normalize(cross(long, [0, 0, 1]));
    const to = /foot/.test(name) ? add(p, [0, -0.08, 0]) : q;
    shells.sheet(
      name,
      [0, 0.5, 1].map((t) => [-1, 0, 1].map((s) => add(mix(p, to, t), scale(side, s * (ra + (rb - ra) * t))))),
    );
  }
  shells.sheet(
    "head",
    [-1, 0, 1].map((t) => [-1, 0, 1].map((s) => [0.1 * s, 1.58 + 0.12 * t, 0])),
  );
  const limbs = Object.fromEntries(Object.entries(personLimbs(body)).map(([key, place]) => [key, flat(place)]));
  return model("a man cut from paper, without thickness", shells, { front: "+z", limbs });
}

function cape(shells) {
  const rows = Array.from({ length: 9 }, (_, r) =>
    Array.from({ length: 7 }, (_, k) => [0.2 * (1 + 0.06 * r) * (k / 3 - 1), 1.36 - 0.135 * r, -0.15 - 0.012 * r - 0.03 * Math.cos(k - 3)]),
  );
  return shells.sheet("cape", rows);
}

function hairCards(shells) {
  for (let n = 0; n < 40; n++) {
    const angle = Math.PI + (2.4 * Math.PI * (n - 20)) / 40 / 1.2;
    const out = [Math.sin(angle), 0, Math.cos(angle)];
    const side = [out[2], 0, -out[0]];
    const place = (r, s) => add(add([0, 1.68 - 0.08 * r, 0.01], scale(out, 0.06 + 0.018 * Math.min(r, 2))), scale(side, 0.018 * s));
    shells.sheet(
      `hair-${n}`,
      [0, 1, 2, 3, 4].map((r) => [-1, 1].map((s) => place(r, s))),
    );
  }
  return shells;
}

/** Boxes of whole pixels, as in block games: arms hang, limbs touch the trunk. */
function blocks() {
  const shells = new Shells();
  shells.box("head", [0, 1.75, 0], [0.25, 0.25, 0.25]).box("body", [0, 1.125, 0], [0.25, 0.375, 0.125]);
  for (const s of [1, -1]) {
    const side = s > 0 ? "left" : "right";
    shells
      .box(`${side}-arm`, [0.375 * s, 1.125, 0], [0.125, 0.375, 0.125])
      .box(`${side}-leg`, [0.125 * s, 0.375, 0], [0.125, 0.375, 0.125]);
  }
  shells.box("nose", [0, 1.7, 0.27], [0.04, 0.06, 0.02]);
  return model("boxes, as in block games", shells, {
    limbs: {
      head: [0, 2, 0],
      "left-hand": [0.375, 0.75, 0],
      "right-hand": [-0.375, 0.75, 0],
      "left-foot": [0.125, 0, 0],
      "right-foot": [-0.125, 0, 0],
    },
  });
}

function rods() {
  const body = person("a");
  const shells = new Shells();
  for (const { name, a, b } of body.bones) shells.rod(name, a, b, 0.012);
  shells.rod("spine", body.joints.hips, body.joints.neck, 0.012).ball("head", body.joints.head, 0.1);
  for (const side of ["left", "right"]) {
    shells.rod(`${side}-collar`, body.joints.chest, body.joints[`${side}-shoulder`], 0.012);
    shells.rod(`${side}-pelvis`, body.joints.hips, body.joints[`${side}-hip`], 0.012);
  }
  return model("a stick man of thin rods", shells, personTruth(body));
}

function threeMaterials() {
  const body = person("a");
  const shells = shellPerson(body);
  const checks = (rgb) => {
    const pixels = Buffer.alloc(3 * 64);
    for (let i = 0; i < 64; i++) pixels.set((i + (i >> 3)) % 2 ? rgb : rgb.map((x) => x / 2), 3 * i);
    return encodePng(8, 8, pixels);
  };
  const made = model("three materials, two of them with pictures", shells, personTruth(body), {
    format: "glb",
    materials: [{ png: checks([200, 60, 50]) }, { png: checks([50, 90, 190]) }, { color: [0.9, 0.7, 0.5] }],
  });
  const material = (name) => (/thigh|shin|foot/.test(name) ? 1 : /head|hand|nose|neck/.test(name) ? 2 : 0);
  return { ...made, parts: made.parts.map((part) => ({ ...part, material: material(part.name) })) };
}

/** Hands and head do not touch the body at all. */
function looseHands() {
  const body = person("a");
  const shells = boneShells(
    new Shells(),
    body.bones.filter(({ name }) => !/hand|foot|upper-arm|forearm|thigh|shin/.test(name)),
  );
  shells.ball("head", add(body.joints.head, [0, 0.08, 0]), [0.11, 0.13, 0.11]).ball("nose", [0, 1.64, 0.12], 0.025);
  for (const side of ["left", "right"]) {
    shells.ball(`${side}-hand`, body.joints[`${side}-hand`], 0.07).ball(`${side}-foot`, body.joints[`${side}-toe`], [0.06, 0.045, 0.1]);
    shells.ball(`${side}-thumb`, add(body.joints[`${side}-hand`], [0, 0.05, 0.05]), 0.025);
  }
  return model("hands and feet float without arms and legs", shells, personTruth(body));
}

const horseOf = (what, options, more = {}) => {
  const { bones, limbs } = horse(options);
  const all = [...bones, ...(more.bones ?? [])];
  const shells = more.shells ? boneShells(new Shells(), all) : surface("body", surfaceOf(fieldOf(all), 0.032));
  return model(what, shells, { limbs: { ...limbs, ...more.limbs } });
};

function winged() {
  const { bones, limbs } = horse();
  const shells = surface("body", surfaceOf(fieldOf([...bones, tail, ...ears]), 0.032));
  for (const s of [1, -1]) {
    const rows = [0, 1, 2, 3, 4].map((r) =>
      [0, 1, 2].map((k) => [s * (0.12 + 0.22 * r), 1.02 + 0.11 * r, 0.25 - 0.22 * k * (1 - 0.15 * r)]),
    );
    shells.sheet(s > 0 ? "left-wing" : "right-wing", rows);
  }
  const wings = { "left-wing": [1, 1.46, 0.1], "right-wing": [-1, 1.46, 0.1] };
  return model("a horse with tail, ears and wings", shells, {
    limbs: { ...limbs, tail: tail.b, "left-ear": ears[0].b, "right-ear": ears[1].b, ...wings },
  });
}

function bird() {
  const shells = surface(
    "body",
    surfaceOf(
      union(
        0.04,
        limb([
          [0, 0.5, -0.2, 0.13],
          [0, 0.55, 0, 0.2],
          [0, 0.62, 0.16, 0.14],
        ]),
        sphere([0, 0.86, 0.2], 0.13),
        limb([
          [0, 0.84, 0.3, 0.04],
          [0, 0.8, 0.42, 0.02],
        ]),
      ),
      0.03,
    ),
  );
  for (const s of [1, -1]) {
    const side = s > 0 ? "left" : "right";
    shells.sheet(
      `${side}-wing`,
      [0, 1, 2, 3].map((r) => [0, 1, 2].map((k) => [s * (0.15 + 0.16 * r), 0.64 + 0.05 * r, 0.12 - 0.15 * k * (1 - 0.2 * r)])),
    );
    shells
      .rod(`${side}-leg`, [0.08 * s, 0.4, 0], [0.08 * s, 0.04, 0], 0.02)
      .rod(`${side}-toes`, [0.08 * s, 0.02, -0.02], [0.08 * s, 0.02, 0.1], 0.018);
  }
  return model("a bird with sheets for wings and rods for legs", shells, {
    limbs: {
      head: [0, 0.8, 0.44],
      "left-wing": [0.63, 0.79, 0],
      "right-wing": [-0.63, 0.79, 0],
      "left-foot": [0.08, 0, 0.1],
      "right-foot": [-0.08, 0, 0.1],
    },
  });
}

function fish() {
  const shells = surface(
    "body",
    surfaceOf(
      union(
        0.03,
        limb([
          [0, 0.5, 0.5, 0.06],
          [0, 0.5, 0.25, 0.17],
          [0, 0.5, -0.1, 0.15],
          [0, 0.5, -0.5, 0.04],
        ]),
      ),
      0.03,
    ),
  );
  shells.sheet(
    "tail-fin",
    [0, 1].map((r) => [-1, 0, 1].map((s) => [0, 0.5 + s * (0.05 + 0.15 * r), -0.48 - 0.17 * r])),
  );
  shells.sheet(
    "back-fin",
    [0, 1].map((r) => [0, 1].map((k) => [0, 0.63 + 0.14 * r, 0.15 - 0.25 * k - 0.08 * r])),
  );
  for (const s of [1, -1])
    shells.sheet(
      s > 0 ? "left-fin" : "right-fin",
      [0, 1].map((r) => [0, 1].map((k) => [s * (0.13 + 0.2 * r), 0.44 - 0.05 * r, 0.2 - 0.16 * k - 0.1 * r])),
    );
  return model("a fish with sheets for fins", shells, {
    limbs: { head: [0, 0.5, 0.56], tail: [0, 0.5, -0.65], "left-fin": [0.33, 0.39, 0.05], "right-fin": [-0.33, 0.39, 0.05] },
  });
}

function spider() {
  const shells = new Shells().ball("body", [0, 0.4, -0.25], [0.28, 0.24, 0.34]).ball("head", [0, 0.38, 0.16], [0.17, 0.15, 0.18]);
  const limbs = { head: [0, 0.38, 0.34] };
  for (let n = 0; n < 8; n++) {
    const s = n % 2 ? -1 : 1;
    const z = 0.3 - 0.22 * (n >> 1);
    const [root, knee, foot] = [
      [0.14 * s, 0.4, 0.14 - 0.08 * (n >> 1)],
      [0.45 * s, 0.66, 1.1 * z],
      [0.72 * s, 0.02, 1.7 * z],
    ];
    shells
      .capsule(`leg-${n}-upper`, root, knee, 0.03, 0.025, { around: 6 })
      .capsule(`leg-${n}-lower`, knee, foot, 0.025, 0.015, { around: 6 });
    limbs[`${s > 0 ? "left" : "right"}-foot-${(n >> 1) + 1}`] = foot;
  }
  return model("a spider of shells", shells, { limbs });
}

function cup() {
  const shells = new Shells();
  const ring = (y, radius) => ({ centre: [0, y, 0], radius, u: [0, 0, 1], v: [1, 0, 0] });
  const wall = [ring(0, 0.3), ring(0.3, 0.35), ring(0.6, 0.4), ring(0.8, 0.42), ring(0.8, 0.38), ring(0.5, 0.34), ring(0.1, 0.28)];
  shells.lathe("cup", wall, 24, [0, 0, 0], [0, 0.08, 0]);
  const handle = Array.from({ length: 7 }, (_, k) => [0.38 + 0.25 * Math.sin((k * Math.PI) / 6), 0.62 - 0.4 * (k / 6), 0, 0.04]);
  shells.mesh("handle", surfaceOf(limb(handle), 0.02));
  return model("a cup with a handle", shells, { front: null, limbs: {} });
}

function tree() {
  const shells = new Shells().capsule("trunk", [0, 0.05, 0], [0, 1, 0], 0.12, 0.08);
  for (let n = 0; n < 5; n++) {
    const angle = 2.4 * n;
    const end = [0.5 * Math.sin(angle), 1.3 + 0.09 * n, 0.5 * Math.cos(angle)];
    shells.capsule(`branch-${n}`, [0, 0.85, 0], end, 0.05, 0.025, { around: 7 }).ball(`leaves-${n}`, end, 0.22, { around: 8, rings: 5 });
  }
  return model("a tree of shells", shells, { front: null, limbs: {} });
}

function chair() {
  const shells = new Shells().box("seat", [0, 0.48, 0], [0.25, 0.03, 0.25]).box("back", [0, 0.85, -0.23], [0.24, 0.3, 0.025]);
  const limbs = {};
  for (const [name, x, z] of [
    ["left-forefoot", 1, 1],
    ["right-forefoot", -1, 1],
    ["left-hindfoot", 1, -1],
    ["right-hindfoot", -1, -1],
  ]) {
    shells.box(name, [0.21 * x, 0.225, 0.21 * z], [0.025, 0.225, 0.025]);
    limbs[name] = [0.21 * x, 0, 0.21 * z];
  }
  return model("a chair of boxes", shells, { limbs });
}

/** Two discs back to back along a line: an edge of four faces, and a fin of one on top. */
function nonManifold(shells) {
  const fins = [];
  for (let n = 0; n < shells.faces.length; n += 37) {
    const [a, b, c] = shells.faces[n];
    const [p, q, r] = [a, b, c].map((v) => shells.positions[v]);
    const out = normalize(cross(sub(q, p), sub(r, p)));
    fins.push([a, b, add(mix(p, q, 0.5), scale(out, 0.02))]);
  }
  return shells.part("fins", () => {
    for (const [a, b, tip] of fins) shells.faces.push([a, b, shells.vertices([tip])]);
  });
}

/** Arms through the trunk, shins through each other. */
function selfCrossing() {
  const body = person("hanging", { out: 0.13, gap: -0.09 });
  return model("arms run through the trunk, legs through each other", shellPerson(body), personTruth(body));
}

/** Kept whole in `far`: heights of a person that stands where surveys are. */
const UTM = [431_250.37, 0, 5_412_780.61];

function debris(shells) {
  const next = dice(11);
  for (let n = 0; n < 6; n++) shells.box(`crumb-${n}`, [40 * (next() - 0.2), 0.02 + 12 * next(), 40 * (next() - 0.5)], [0.01, 0.01, 0.01]);
  return shells.box("crumb-far", [40, 0.5, -38], [0.02, 0.02, 0.02]);
}

const ground = (shells) =>
  shells.sheet(
    "ground",
    Array.from({ length: 9 }, (_, r) => Array.from({ length: 9 }, (_, k) => [k - 4, 0, 4 - r])),
  );

const flip = (chance, seed) => {
  const next = dice(seed);
  return (shells) => reface(shells, ([a, b, c]) => (next() < chance ? [a, c, b] : [a, b, c]));
};
const drop = (chance, seed) => {
  const next = dice(seed);
  return (shells) => reface(shells, (face) => (next() < chance ? null : face));
};
const doubled = (shells) => shells.part("again", () => shells.faces.push(...shells.faces.map(([a, b, c]) => [a, c, b])));

function million() {
  const body = person("a");
  let shells = surface("body", personSurface(body, { step: 0.0172 }));
  while (shells.faces.length < 1e6) shells = split(shells);
  return model("a million triangles", shells, personTruth(body), { format: "glb" });
}

const plain = () => surfacePerson("a person in A pose");
const quarter = (what, matrix) => turned(what, matrix, plain());

const MAKE = {
  "person-t": () => surfacePerson("a person in T pose, one closed surface", "t"),
  "person-a": plain,
  "person-hanging": () => surfacePerson("a person whose arms hang", "hanging", { out: 0.22 }),
  mannequin,
  hoodie,
  soup: () => surfacePerson("a person of triangles that share nothing", "a", {}, soup),
  holes: () => surfacePerson("a tenth of the faces missing", "a", {}, drop(0.1, 5)),
  "floating-hat": () =>
    surfacePerson("a hat that floats above the head", "a", {}, (shells) =>
      shells.ball("brim", [0, 1.82, 0], [0.22, 0.015, 0.22]).capsule("hat", [0, 1.87, 0], [0, 1.95, 0], 0.12, 0.1),
    ),
  "ground-plane": () => surfacePerson("a person on a wide ground", "a", {}, ground),
  debris: () => surfacePerson("crumbs up to 40 m away", "a", {}, debris),
  "paper-man": paperMan,
  cape: () => surfacePerson("a person with a cape", "a", {}, cape),
  "hair-cards": () => surfacePerson("a person with forty strips of hair", "a", {}, hairCards),
  blocks,
  rods,
  "legs-close": () => surfacePerson("legs one hundredth of its height apart", "a", { gap: 0.017, step: 0.014, fillet: 0.008 }),
  "arms-graze": () =>
    model("arms that graze the trunk", shellPerson(person("hanging", { out: 0.175 })), personTruth(person("hanging", { out: 0.175 }))),
  "three-materials": threeMaterials,
  utm: () => turned("a scan in survey coordinates", rotX(0), plain(), UTM),
  million,
  "upside-down": () => quarter("upside down", rotZ(180)),
  "quarter-left": () => quarter("looks along +x", rotY(90)),
  backwards: () => quarter("looks along -z", rotY(180)),
  "quarter-right": () => quarter("looks along -x", rotY(-90)),
  "z-up": () => quarter("z up, looks along -y", rotX(90)),
  "lies-on-face": () => quarter("-z up", rotX(-90)),
  "lies-on-side": () => quarter("-x up", rotZ(90)),
  "lies-on-other-side": () => quarter("+x up", rotZ(-90)),
  "loose-hands": looseHands,
  horse: () => horseOf("a horse, one closed surface", {}, { bones: [tail], limbs: { tail: tail.b } }),
  "hooves-near": () => horseOf("a horse whose front hooves nearly touch", { near: 0.13 }),
  "horse-striding": () => horseOf("a horse in mid stride", { stride: 0.24 }, { bones: [tail], limbs: { tail: tail.b } }),
  "person-striding": () => surfacePerson("a person in mid stride", "hanging", { out: 0.22, stride: 0.3 }),
  "horse-shells": () => horseOf("a horse of shells", {}, { shells: true, bones: [tail, ...ears], limbs: { tail: tail.b } }),
  winged,
  bird,
  fish,
  spider,
  cup,
  ball: () => model("a ball", new Shells().ball("ball", [0, 0.5, 0], 0.5, { around: 32, rings: 15 }), { front: null, limbs: {} }),
  tree,
  chair,
  "non-manifold": () => surfacePerson("fins on the edges of closed skin", "a", {}, nonManifold),
  "self-crossing": selfCrossing,
  "doubled-faces": () => surfacePerson("every face twice, once each way", "a", {}, doubled),
  "random-winding": () => surfacePerson("faces wound at random", "a", {}, flip(0.5, 9)),
  "inside-out": () => surfacePerson("faces wound inwards", "a", {}, flip(1, 9)),
  "open-shells": () => model("tubes without ends", shellPerson(person("a"), { open: true }), personTruth(person("a"))),
};

export const HOSTILE = Object.fromEntries(Object.entries(MAKE).map(([name, make]) => [name, () => ({ name, ...make() })]));

/** Rows as of docs/figures/strangers.json. */
export function writeHostile(folder, wanted) {
  mkdirSync(folder, { recursive: true });
  return Object.entries(HOSTILE)
    .map(([name, make]) => [`hostile-${name}`, make])
    .filter(([name]) => wanted.test(name))
    .map(([name, make]) => {
      const made = make();
      const path = `${folder}${name}.${made.format}`;
      writeFileSync(path, made.format === "glb" ? glbBytes(made) : objText(made));
      const { up, front } = made.truth;
      return { name, what: made.what, path, truth: { up, front } };
    });
}
