// The cactus as one closed surface: a lattice of rings from the pot's bottom to the top, with two arms and a flower grown
// out of holes in it. A lattice, and not a remeshed level set: the ribs then follow the edges, the pot's rim stays crisp, and
// left and right are mirror images. Metres, Y up, facing +Z; the cactus's left is +X.
import { relax, startAt, stitch, Surface } from "../kit/surface.js";
import { add, cross, distance, dot, normalize, scale, sub } from "../kit/vec3.js";

const SEGMENTS = 20; // every second one is the crest of a rib
const FRONT = 5; // the column that faces +Z
const BACK = 15; // the texture's seam
const TAU = 2 * Math.PI;

// Profile from the bottom up: radius, height, depth of the ribs.
const POT_RINGS = [
  { r: 0.205, y: 0.0 },
  { r: 0.218, y: 0.066 },
  { r: 0.231, y: 0.132 },
  { r: 0.244, y: 0.198 },
  { r: 0.257, y: 0.264 },
  { r: 0.306, y: 0.294 },
  { r: 0.313, y: 0.378 },
  { r: 0.257, y: 0.386 },
  { r: 0.214, y: 0.352 },
];
const BODY_RINGS = [
  { r: 0.246, y: 0.42, rib: 0.005 },
  { r: 0.268, y: 0.494, rib: 0.009 },
  { r: 0.283, y: 0.57, rib: 0.012 },
  { r: 0.292, y: 0.648, rib: 0.012 },
  { r: 0.296, y: 0.727, rib: 0.012 },
  { r: 0.297, y: 0.806, rib: 0.011 },
  { r: 0.294, y: 0.885, rib: 0.01 },
  { r: 0.288, y: 0.964, rib: 0.01 },
  { r: 0.279, y: 1.043, rib: 0.011 },
  { r: 0.263, y: 1.122, rib: 0.012 },
  { r: 0.236, y: 1.198, rib: 0.011 },
  { r: 0.194, y: 1.268, rib: 0.008 },
];
const CROWN = { r: 0.108, y: 1.331 };
const TOP = 1.354;
const BOTTOM_RING = 0.112;

const ARMS = [
  { name: "rightArm", column: 10, ring: 2, side: -1, reach: 0.1, rise: 0.19 },
  { name: "leftArm", column: 0, ring: 5, side: 1, reach: 0.1, rise: 0.18 },
];
const ARM_RADIUS = 0.086;
const HOLE_RADIUS = 0.102;
const FLOWER = { column: 2, ring: 10, axis: [0.5, 0.62, 0.6], lift: 0.042 };

function onRing(column, r, y) {
  const a = (TAU * column) / SEGMENTS;
  return [r * Math.cos(a), y, r * Math.sin(a)];
}

/** Texture columns count from the seam at the back, so that no quad of a strip wraps around. */
const unwrap = (column) => (column - BACK + 2 * SEGMENTS) % SEGMENTS;

function ringStrip(surface, part, low, high, vLow, vHigh) {
  for (let i = 0; i < SEGMENTS; i++) {
    const j = (i + 1) % SEGMENTS;
    const u = unwrap(i);
    const a = [low[i], u, vLow];
    const b = [low[j], u + 1, vLow];
    const c = [high[j], u + 1, vHigh];
    const d = [high[i], u, vHigh];
    // The diagonal leans away from the front on both sides: mirrored, and every vertex keeps six neighbours.
    const leftHalf = i >= BACK || i < FRONT;
    if (leftHalf) {
      surface.triangle(part, a, d, b);
      surface.triangle(part, b, d, c);
    } else {
      surface.triangle(part, a, d, c);
      surface.triangle(part, a, c, b);
    }
  }
}

/** A ring of 20 to one of 10 to a centre; uv is the position seen along y. */
function closeDisc(surface, part, outer, inner, centre, up) {
  const corner = (v) => [v, surface.vertices[v][0], surface.vertices[v][2]];
  const put = (a, b, c) => (up ? surface.triangle(part, corner(a), corner(b), corner(c)) : surface.triangle(part, corner(a), corner(c), corner(b)));
  for (let j = 0; j < inner.length; j++) {
    const next = (j + 1) % inner.length;
    put(outer[2 * j], inner[j], outer[2 * j + 1]);
    put(outer[2 * j + 1], inner[j], inner[next]);
    put(outer[2 * j + 1], inner[next], outer[(2 * j + 2) % outer.length]);
    put(inner[j], centre, inner[next]);
  }
}

function makeRing(surface, { r, y, rib = 0 }) {
  return Array.from({ length: SEGMENTS }, (_, i) => surface.vertex(onRing(i, r + (i % 2 ? -rib : rib), y)));
}

/** Removes a patch of two by two quads; gives the eight vertices around it, clockwise seen from outside. */
function openHole(surface, rings, ring, column) {
  const at = (dr, dc) => rings[ring + dr][(column + dc + SEGMENTS) % SEGMENTS];
  const loop = [at(-1, -1), at(-1, 0), at(-1, 1), at(0, 1), at(1, 1), at(1, 0), at(1, -1), at(0, -1)];
  surface.removePatch([...loop, at(0, 0)]);
  return loop;
}

/** Centre line of an arm: out of the body, around a bend, up; with the direction at each station and how far along it is. */
function armPath(arm) {
  const base = BODY_RINGS[arm.ring];
  const bend = 0.172;
  const stations = [];
  let at = [base.r + 0.035, base.y - 0.004];
  let angle = 0.04;
  const push = (radius) => stations.push({ at: [...at], angle, radius });
  const walk = (step, turn) => {
    const middle = angle + turn / 2;
    at = [at[0] + step * Math.cos(middle), at[1] + step * Math.sin(middle)];
    angle += turn;
  };
  push(ARM_RADIUS * 1.1);
  walk(arm.reach - 0.035, 0.06);
  push(ARM_RADIUS);
  for (let k = 0; k < 3; k++) {
    walk(bend * 0.42, 0.42);
    push(ARM_RADIUS * 1.01);
  }
  for (const radius of [1, 0.98, 0.93]) {
    walk(arm.rise / 3, 0.04);
    push(ARM_RADIUS * radius);
  }
  walk(0.044, 0.02);
  push(ARM_RADIUS * 0.7);
  walk(0.026, 0);
  stations.push({ at: [...at], angle, radius: 0 });
  return stations;
}

/** Radius of the body without its ribs. */
function bodyRadius(y) {
  const k = BODY_RINGS.findIndex((ring) => ring.y > y);
  const [a, b] = [BODY_RINGS[k - 1], BODY_RINGS[k]];
  return a.r + ((b.r - a.r) * (y - a.y)) / (b.y - a.y);
}

/** Makes the square hole of an arm round, on the body. */
function roundHole(surface, loop, arm) {
  for (const v of loop) {
    const [, y, z] = surface.vertices[v];
    const centre = BODY_RINGS[arm.ring].y;
    const s = HOLE_RADIUS / Math.hypot(y - centre, z);
    const [ny, nz] = [centre + (y - centre) * s, z * s];
    surface.vertices[v] = [arm.side * Math.sqrt(bodyRadius(ny) ** 2 - nz * nz), ny, nz];
  }
}

function growArm(surface, rings, arm) {
  let previous = openHole(surface, rings, arm.ring, arm.column);
  roundHole(surface, previous, arm);
  const fillet = [...previous];
  const stations = armPath(arm);
  let along = 0;
  // Seen from its own side each arm is the same: toward +z for the left arm, toward -z for the right one.
  const place = (s, j) => {
    const phi = (TAU * (j - 3)) / 8;
    const across = s.radius * Math.cos(phi) * arm.side;
    const up = s.radius * Math.sin(phi);
    return [arm.side * (s.at[0] - up * Math.sin(s.angle)), s.at[1] + up * Math.cos(s.angle), across + 0.03 * (s.at[1] - stations[0].at[1])];
  };
  stations.forEach((s, k) => {
    const last = k === stations.length - 1;
    const ring = last ? [] : Array.from({ length: 8 }, (_, j) => surface.vertex(place(s, j)));
    const tip = last ? surface.vertex(place(s, 0)) : -1;
    const next = along + (k === 0 ? 0.05 : Math.hypot(s.at[0] - stations[k - 1].at[0], s.at[1] - stations[k - 1].at[1]));
    for (let j = 0; j < 8; j++) {
      // The strip's seam lies at the back of the arm.
      const shift = arm.side > 0 ? 1 : 5;
      const u = (j + shift) % 8;
      const a = [previous[j], u, along];
      const b = [previous[(j + 1) % 8], u + 1, along];
      if (last) {
        surface.triangle(arm.name, a, [tip, u + 0.5, next], b);
        continue;
      }
      const d = [ring[j], u, next];
      const c = [ring[(j + 1) % 8], u + 1, next];
      const diagonal = distance(surface.vertices[a[0]], surface.vertices[c[0]]) - distance(surface.vertices[b[0]], surface.vertices[d[0]]);
      const flip = Math.abs(diagonal) > 1e-6 ? diagonal > 0 : j < 3;
      if (flip) {
        surface.triangle(arm.name, a, d, b);
        surface.triangle(arm.name, b, d, c);
      } else {
        surface.triangle(arm.name, a, d, c);
        surface.triangle(arm.name, a, c, b);
      }
    }
    if (k === 0) fillet.push(...ring);
    previous = ring;
    along = next;
  });
  relax(surface, fillet, 2);
  return along;
}

/** Five petals: a rim of twenty vertices, an inner ring of ten, the heart. */
function growFlower(surface, rings) {
  const hole = openHole(surface, rings, FLOWER.ring, FLOWER.column);
  const axis = normalize(FLOWER.axis);
  const middle = scale(hole.reduce((sum, v) => add(sum, surface.vertices[v]), [0, 0, 0]), 1 / 8);
  const origin = add(middle, scale(axis, FLOWER.lift));
  const ex = normalize(cross([0, 1, 0], axis));
  const ey = cross(axis, ex);
  const place = (r, degrees, h) => {
    const a = (degrees * Math.PI) / 180;
    return surface.vertex(add(add(origin, scale(axis, h)), add(scale(ex, r * Math.cos(a)), scale(ey, r * Math.sin(a)))));
  };
  const rim = [];
  const inner = [];
  for (let petal = 0; petal < 5; petal++) {
    const start = 72 * petal + 90 - 36;
    rim.push(place(0.066, start, 0.006), place(0.109, start + 17, 0.01), place(0.121, start + 36, 0.012), place(0.109, start + 55, 0.01));
    inner.push(place(0.041, start, 0.013), place(0.055, start + 36, 0.017));
  }
  const heart = place(0, 0, 0.024);
  const corner = (v) => {
    const d = sub(surface.vertices[v], origin);
    return [v, dot(d, ex), dot(d, ey)];
  };
  // The hole runs clockwise seen from outside; the rim counter-clockwise.
  const holeLoop = startAt(surface, [...hole].reverse(), surface.vertices[rim[0]]);
  stitch(surface, "flowerBack", holeLoop, rim, corner);
  stitch(surface, "flower", rim, inner, corner);
  for (let k = 0; k < 10; k++) surface.triangle("flower", corner(inner[k]), corner(inner[(k + 1) % 10]), corner(heart));
}

/** Distances along the profile, for the strips' v. */
function profileLength(rings, start) {
  const out = [start];
  for (let k = 1; k < rings.length; k++) out.push(out[k - 1] + Math.hypot(rings[k].r - rings[k - 1].r, rings[k].y - rings[k - 1].y));
  return out;
}

export function buildCactus() {
  const surface = new Surface();
  const pot = POT_RINGS.map((ring) => makeRing(surface, ring));
  const body = BODY_RINGS.map((ring) => makeRing(surface, ring));

  const potV = profileLength(POT_RINGS, 0);
  for (let k = 1; k < pot.length; k++) ringStrip(surface, "pot", pot[k - 1], pot[k], potV[k - 1], potV[k]);
  const bodyRings = [POT_RINGS.at(-1), ...BODY_RINGS];
  const bodyV = profileLength(bodyRings, 0);
  [pot.at(-1), ...body].forEach((ring, k, all) => {
    if (k > 0) ringStrip(surface, "body", all[k - 1], ring, bodyV[k - 1], bodyV[k]);
  });

  const tens = (r, y) => Array.from({ length: 10 }, (_, j) => surface.vertex(onRing(2 * j, r, y)));
  closeDisc(surface, "crown", body.at(-1), tens(CROWN.r, CROWN.y), surface.vertex([0, TOP, 0]), true);
  closeDisc(surface, "bottom", pot[0], tens(BOTTOM_RING, 0), surface.vertex([0, 0, 0]), false);

  const armLength = ARMS.map((arm) => growArm(surface, body, arm));
  growFlower(surface, body);
  surface.compact();
  return {
    vertices: surface.vertices,
    faces: surface.faces,
    lengths: { pot: potV.at(-1), body: bodyV.at(-1), rightArm: armLength[0], leftArm: armLength[1] },
    segments: SEGMENTS,
  };
}
