// The boundary to the core. Made by wasm/abi.mjs from wasm/abi.h: change that.

import {
  LENGTH_UNIT_NAMES,
  type LengthUnit,
  FRAME_TIME_UNIT_NAMES,
  type FrameTimeUnit,
  UP_AXIS_NAMES,
  type UpAxis,
  BODY_ROLE_NAMES,
  type BodyRole,
  BODY_PART_NAMES,
  type BodyPart,
  BODY_SIDE_NAMES,
  type BodySide,
} from "../util/constants";

/** A module that answers another number to abi() was built from another description. */
export const ABI = 2039636348;

/** 0: ok; otherwise error * 2^32 + where. */
export type PackedStatus = number;
/** Index and generation; 0 is none. */
export type Handle = number;
export type Integers = Int32Array | Uint32Array;

declare const pointed: unique symbol;
/** Where the core keeps something. */
export type Pointer<T = unknown> = number & { readonly [pointed]?: T };

/** How a struct is read from its doubles. */
export interface Row<T> {
  doubles: number;
  read(n: Float64Array): T;
}

/** Where a mesh is held. */
export interface ControlInput {
  vertex: number;
  /** Of the disc along the surface or of the ball in the solid, metres. */
  radius: number;
  /** Of a solid: holds a level slab instead of a ball. */
  slab: boolean;
  /** Of a solid: it is known to be at the tip of a limb. */
  onLimb: boolean;
  /** Where that limb leaves the trunk, stage metres. */
  base: [number, number, number];
  /** Where it bends at rest, stage metres. */
  bend: [number, number, number];
}

export const writeControlInput = (one: ControlInput): number[] => [
  one.vertex,
  one.radius,
  Number(one.slab),
  Number(one.onLimb),
  ...one.base,
  ...one.bend,
];

/** Where a control is at a frame, or the way to there from a control at a frame, on the axes named; body-local stage metres. */
export interface ConstraintInput {
  control: number;
  frame: number;
  /** -1: the value is a place. */
  fromControl: number;
  fromFrame: number;
  value: [number, number, number];
  /** Whether the value speaks of it. */
  x: boolean;
  y: boolean;
  z: boolean;
}

export const writeConstraintInput = (one: ConstraintInput): number[] => [
  one.control,
  one.frame,
  one.fromControl,
  one.fromFrame,
  ...one.value,
  Number(one.x),
  Number(one.y),
  Number(one.z),
];

export interface BodyReport {
  /** NaN when open. */
  volume: number;
  boundaryEdges: number;
  nonManifoldEdges: number;
  shells: number;
  isolatedVertices: number;
  degenerateFaces: number;
  /** Height of the lowest vertex above y = 0. */
  floor: number;
  /** From there to the highest vertex. */
  height: number;
}

export const bodyReportRow: Row<BodyReport> = {
  doubles: 8,
  read: (n) => ({
    volume: n[0],
    boundaryEdges: n[1],
    nonManifoldEdges: n[2],
    shells: n[3],
    isolatedVertices: n[4],
    degenerateFaces: n[5],
    floor: n[6],
    height: n[7],
  }),
};

/** What is solved inside a mesh. */
export interface SolidInfo {
  /** N. */
  nodes: number;
  /** E. */
  elements: number;
  /** Directed. */
  edges: number;
  /** Edge of an element, metres. */
  cell: number;
}

export const solidInfoRow: Row<SolidInfo> = { doubles: 4, read: (n) => ({ nodes: n[0], elements: n[1], edges: n[2], cell: n[3] }) };

/** Joints and weights for frames of a mesh. */
export interface SkinInfo {
  /** J. */
  joints: number;
  /** F. */
  frames: number;
  /** K. */
  targets: number;
  /** Of all vertices in all frames, in diagonals. */
  rms: number;
  /** The same. */
  worst: number;
  /** Radians, rms. */
  normals: number;
}

export const skinInfoRow: Row<SkinInfo> = {
  doubles: 6,
  read: (n) => ({ joints: n[0], frames: n[1], targets: n[2], rms: n[3], worst: n[4], normals: n[5] }),
};

/** Morph targets for frames of a mesh. */
export interface MorphInfo {
  /** K. */
  targets: number;
  /** F. */
  frames: number;
  /** Of all vertices in all frames, in diagonals. */
  rms: number;
  /** The same. */
  worst: number;
}

export const morphInfoRow: Row<MorphInfo> = { doubles: 4, read: (n) => ({ targets: n[0], frames: n[1], rms: n[2], worst: n[3] }) };

export interface BakeRoot {
  /** Of the body's origin in the world. */
  position: [number, number, number];
  /** Radians. */
  yaw: number;
  /** NaN when open. */
  volumeRatio: number;
}

export const bakeRootRow: Row<BakeRoot> = { doubles: 5, read: (n) => ({ position: [n[0], n[1], n[2]], yaw: n[3], volumeRatio: n[4] }) };

/** What the user says of a motion: instead of what is guessed, and what is danced of it. */
export interface MotionEdits {
  /** 0: guessed. */
  metresPerUnit: number;
  /** 0: the file's. */
  fps: number;
  /** An UpAxis; -1: guessed. */
  up: number;
  /** Quarter turns, counter-clockwise from above. */
  turns: number;
  mirror: boolean;
  /** Frames at 30 fps. */
  first: number;
  last: number;
  loop: boolean;
}

export const writeMotionEdits = (one: MotionEdits): number[] => [
  one.metresPerUnit,
  one.fps,
  one.up,
  one.turns,
  Number(one.mirror),
  one.first,
  one.last,
  Number(one.loop),
];

export interface MotionInfo {
  /** T. */
  frames: number;
  /** J. */
  joints: number;
  sourceFrames: number;
  sourceFps: number;
  /** Of the file. */
  metresPerUnit: number;
  /** Which joints are its feet and its head or hands. */
  told: boolean;
  /** Before it was cut. */
  takeFrames: number;
}

export const motionInfoRow: Row<MotionInfo> = {
  doubles: 7,
  read: (n) => ({
    frames: n[0],
    joints: n[1],
    sourceFrames: n[2],
    sourceFps: n[3],
    metresPerUnit: n[4],
    told: n[5] !== 0,
    takeFrames: n[6],
  }),
};

/** What a joint is; no place of a body has two. */
export interface JointPlace {
  side: BodySide;
  part: BodyPart;
}

export const jointPlaceRow: Row<JointPlace> = { doubles: 2, read: (n) => ({ side: BODY_SIDE_NAMES[n[0]], part: BODY_PART_NAMES[n[1]] }) };

/** What a parser worked around (rigless::ParseNotes), and what was guessed of the file. */
export interface MotionNotes {
  framesDeclared: number;
  framesRead: number;
  frameCut: boolean;
  textAfterEnd: boolean;
  frameTimeAssumed: boolean;
  frameTimeUnit: FrameTimeUnit;
  frameNumbers: boolean;
  rowsReplaced: number;
  /** The line of the first. */
  rowReplaced: number;
  radians: boolean;
  roots: number;
  renamed: number;
  lengthsIgnored: number;
  jointsFolded: number;
  up: UpAxis;
  unit: LengthUnit;
  /** Frames. */
  poseInFront: number;
  facedAway: boolean;
}

export const motionNotesRow: Row<MotionNotes> = {
  doubles: 18,
  read: (n) => ({
    framesDeclared: n[0],
    framesRead: n[1],
    frameCut: n[2] !== 0,
    textAfterEnd: n[3] !== 0,
    frameTimeAssumed: n[4] !== 0,
    frameTimeUnit: FRAME_TIME_UNIT_NAMES[n[5]],
    frameNumbers: n[6] !== 0,
    rowsReplaced: n[7],
    rowReplaced: n[8],
    radians: n[9] !== 0,
    roots: n[10],
    renamed: n[11],
    lengthsIgnored: n[12],
    jointsFolded: n[13],
    up: UP_AXIS_NAMES[n[14]],
    unit: LENGTH_UNIT_NAMES[n[15]],
    poseInFront: n[16],
    facedAway: n[17] !== 0,
  }),
};

export interface PerformanceInfo {
  /** T. */
  frames: number;
  /** C. */
  controls: number;
  flights: number;
  constraints: number;
  asks: number;
  /** Metres per second, without the foot lock. */
  slipBefore: number;
  /** With it. */
  slipAfter: number;
  /** The user's examples, images counted. */
  have: number;
  /** How many would be enough. */
  want: number;
  starters: number;
}

export const performanceInfoRow: Row<PerformanceInfo> = {
  doubles: 10,
  read: (n) => ({
    frames: n[0],
    controls: n[1],
    flights: n[2],
    constraints: n[3],
    asks: n[4],
    slipBefore: n[5],
    slipAfter: n[6],
    have: n[7],
    want: n[8],
    starters: n[9],
  }),
};

/** How far a constraint is missed. */
export interface Miss {
  metres: number;
  /** The constraint that it contradicts, or -1. */
  opponent: number;
}

export const missRow: Row<Miss> = { doubles: 2, read: (n) => ({ metres: n[0], opponent: n[1] }) };

/** A frame that is worth an example. */
export interface Ask {
  frame: number;
  gain: number;
}

export const askRow: Row<Ask> = { doubles: 2, read: (n) => ({ frame: n[0], gain: n[1] }) };

/** A place of a body that its file names, in the mesh's own axes and units; a tip says only that something is there. */
export interface Landmark {
  position: [number, number, number];
  role: BodyRole;
  /** 1 on the body's left, -1 on its right, 0 in the middle. */
  side: number;
}

export const writeLandmark = (one: Landmark): number[] => [...one.position, BODY_ROLE_NAMES.indexOf(one.role), one.side];

/** What a bare mesh says of itself, in its own axes and units. */
export interface Shape {
  up: [number, number, number];
  front: [number, number, number];
  /** Of both, 0 to 1; below a half it is as well to ask. */
  sure: number;
  planePoint: [number, number, number];
  planeNormal: [number, number, number];
  /** Of the mirrored surface, in diagonals. */
  misfit: number;
  /** In the plane. */
  symmetric: boolean;
  points: number;
}

export const shapeRow: Row<Shape> = {
  doubles: 16,
  read: (n) => ({
    up: [n[0], n[1], n[2]],
    front: [n[3], n[4], n[5]],
    sure: n[6],
    planePoint: [n[7], n[8], n[9]],
    planeNormal: [n[10], n[11], n[12]],
    misfit: n[13],
    symmetric: n[14] !== 0,
    points: n[15],
  }),
};

export interface ShapePoint {
  vertex: number;
  role: BodyRole;
  /** 1 on the body's left, -1 on its right, 0 in the middle. */
  side: number;
  /** Index of the same point on the other side, its own on the plane, or -1. */
  partner: number;
  radius: number;
  wanted: boolean;
}

export const shapePointRow: Row<ShapePoint> = {
  doubles: 6,
  read: (n) => ({ vertex: n[0], role: BODY_ROLE_NAMES[n[1]], side: n[2], partner: n[3], radius: n[4], wanted: n[5] !== 0 }),
};

export interface RiglessExports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  body_new(): Handle;
  body_delete(body: Handle): void;
  body_set_mesh(
    body: Handle,
    positions: Pointer<Float32Array>,
    vertices: number,
    faces: Pointer<Integers>,
    faceCount: number,
    rigidity: Pointer<Float32Array>,
    paper: number,
  ): PackedStatus;
  body_set_solid_mesh(
    body: Handle,
    positions: Pointer<Float32Array>,
    vertices: number,
    faces: Pointer<Integers>,
    faceCount: number,
    cell: number,
    nodes: Pointer<Float32Array>,
    nodeCount: number,
    elements: Pointer<Integers>,
    elementCount: number,
    elementOf: Pointer<Integers>,
    first: Pointer<Integers>,
    neighbors: Pointer<Integers>,
    weights: Pointer<Float32Array>,
    parts: Pointer<Integers>,
    paper: number,
  ): PackedStatus;
  body_report(body: Handle): Pointer<BodyReport>;
  body_set_controls(body: Handle, inputs: Pointer<ControlInput>, count: number): PackedStatus;
  body_drag(
    body: Handle,
    targets: Pointer<Float32Array>,
    turns: Pointer<Float32Array>,
    count: number,
    volume: number,
    restart: number,
  ): PackedStatus;
  body_positions(body: Handle): Pointer<Float32Array>;
  body_maps(body: Handle): Pointer<Float32Array>;
  body_volume_ratio(body: Handle): number;
  body_rest_controls(body: Handle): Pointer<Float32Array>;
  body_limbs(body: Handle): Pointer<Float32Array>;
  bake_new(): Handle;
  bake_delete(bake: Handle): void;
  bake_begin(
    bake: Handle,
    body: Handle,
    frames: number,
    controls: Pointer<Float32Array>,
    turns: Pointer<Float32Array>,
    yaw: Pointer<Float32Array>,
    travel: Pointer<Float32Array>,
    flights: Pointer<Integers>,
    flightCount: number,
    volume: number,
  ): void;
  bake_frame(bake: Handle, frame: number): PackedStatus;
  bake_positions(bake: Handle): Pointer<Float32Array>;
  bake_maps(bake: Handle): Pointer<Float32Array>;
  bake_root(bake: Handle): Pointer<BakeRoot>;
  motion_new(): Handle;
  motion_delete(motion: Handle): void;
  motion_read(
    motion: Handle,
    text: Pointer<Uint8Array>,
    bytes: number,
    skeleton: Pointer<Uint8Array>,
    skeletonBytes: number,
    said: Pointer<MotionEdits>,
    joints: Pointer<Uint8Array>,
    jointsBytes: number,
  ): PackedStatus;
  motion_beginning(motion: Handle, frames: number): Handle;
  motion_refused_skeleton(motion: Handle): number;
  motion_info(motion: Handle): Pointer<MotionInfo>;
  motion_notes(motion: Handle): Pointer<MotionNotes>;
  motion_name(motion: Handle, joint: number): Pointer<Uint8Array>;
  motion_name_bytes(motion: Handle, joint: number): number;
  motion_place(motion: Handle, joint: number): Pointer<JointPlace>;
  motion_parents(motion: Handle): Pointer<Integers>;
  motion_left(motion: Handle): Pointer<Uint8Array>;
  motion_right(motion: Handle): Pointer<Uint8Array>;
  motion_positions(motion: Handle): Pointer<Float64Array>;
  motion_local(motion: Handle): Pointer<Float64Array>;
  motion_yaw(motion: Handle): Pointer<Float64Array>;
  performance_new(): Handle;
  performance_delete(performance: Handle): void;
  performance_constrain(performance: Handle, constraints: Pointer<ConstraintInput>, count: number): void;
  performance_stand(performance: Handle, control: number, begin: number, end: number): void;
  performance_fly(performance: Handle, flights: Pointer<Integers>, count: number): void;
  performance_mirror(performance: Handle, partners: Pointer<Integers>, controls: number, x: number, y: number, z: number): void;
  performance_follow(performance: Handle, follow: Pointer<Integers>, weights: Pointer<Float32Array>, controls: number): void;
  performance_begin(
    performance: Handle,
    motion: Handle,
    pairs: Pointer<Integers>,
    rest: Pointer<Float32Array>,
    limbs: Pointer<Float32Array>,
    controls: number,
    floor: number,
    height: number,
    exampleJoints: Pointer<Float32Array>,
    exampleControls: Pointer<Float32Array>,
    examples: number,
    smoothness: number,
    groundContact: number,
    inPlace: number,
    energy: number,
    paper: number,
    turned: number,
  ): PackedStatus;
  performance_advance(performance: Handle): PackedStatus;
  performance_progress(performance: Handle): number;
  performance_info(performance: Handle): Pointer<PerformanceInfo>;
  performance_miss(performance: Handle, constraint: number): Pointer<Miss>;
  performance_ask(performance: Handle, index: number): Pointer<Ask>;
  performance_turn(performance: Handle, control: number, turns: Pointer<Float32Array>, count: number): void;
  performance_controls(performance: Handle): Pointer<Float32Array>;
  performance_turns(performance: Handle): Pointer<Float32Array>;
  performance_contacts(performance: Handle): Pointer<Uint8Array>;
  performance_flights(performance: Handle): Pointer<Integers>;
  performance_yaw(performance: Handle): Pointer<Float32Array>;
  performance_travel(performance: Handle): Pointer<Float32Array>;
  performance_source_contacts(performance: Handle): Pointer<Uint8Array>;
  performance_coverage(performance: Handle): Pointer<Float32Array>;
  abi(): number;
  alloc(bytes: number): Pointer;
  release(memory: Pointer): void;
}

export interface ShapeAnalysisExports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  abi(): number;
  alloc(bytes: number): Pointer;
  release(memory: Pointer): void;
  analyse_shape(
    positions: Pointer<Float32Array>,
    vertices: number,
    faces: Pointer<Integers>,
    faceCount: number,
    file: number,
    upAndFront: Pointer<Float32Array>,
    landmarks: Pointer<Landmark>,
    landmarkCount: number,
  ): PackedStatus;
  shape(): Pointer<Shape>;
  shape_point(index: number): Pointer<ShapePoint>;
  build_solid(
    positions: Pointer<Float32Array>,
    vertices: number,
    faces: Pointer<Integers>,
    faceCount: number,
    part: Pointer<Integers>,
    rigidity: Pointer<Float32Array>,
  ): PackedStatus;
  solid_info(): Pointer<SolidInfo>;
  solid_nodes(): Pointer<Float32Array>;
  solid_elements(): Pointer<Integers>;
  solid_element_of(): Pointer<Integers>;
  solid_first(): Pointer<Integers>;
  solid_neighbors(): Pointer<Integers>;
  solid_weights(): Pointer<Float32Array>;
  solid_parts(): Pointer<Integers>;
}

export interface SkinExports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  abi(): number;
  alloc(bytes: number): Pointer;
  release(memory: Pointer): void;
  begin_skin(positions: Pointer<Float32Array>, vertices: number, faces: Pointer<Integers>, faceCount: number, joints: number): PackedStatus;
  add_skin_frame(positions: Pointer<Float32Array>): PackedStatus;
  advance_skin(): number;
  skin_progress(): number;
  skin_info(): Pointer<SkinInfo>;
  skin_centres(): Pointer<Float32Array>;
  skin_joints(): Pointer<Integers>;
  skin_weights(): Pointer<Float32Array>;
  skin_roots(): Pointer<Float32Array>;
  skin_poses(): Pointer<Float32Array>;
  skin_ways(): Pointer<Float32Array>;
  skin_mix(): Pointer<Float32Array>;
  begin_morphs(positions: Pointer<Float32Array>, vertices: number, targets: number): PackedStatus;
  add_morph_frame(positions: Pointer<Float32Array>): PackedStatus;
  advance_morphs(): number;
  morph_progress(): number;
  morph_info(): Pointer<MorphInfo>;
  morph_ways(): Pointer<Float32Array>;
  morph_weights(): Pointer<Float32Array>;
  morph_roots(): Pointer<Float32Array>;
}
