// The engine's public face: plain values in, plain values out. No DOM, no three.js.
// Spaces: "stage" is metres, Y up, the model facing +Z and standing on y = 0 around x = z = 0.
// Letters: V vertices, F triangles, C controls, J joints, T frames (at 30 fps), N examples.

import type { BodyRole, BodyPart as CorePart, BodySide as CoreSide, FileAxes, FollowThrough, Solve } from "../util/constants";
import type { SolidCells } from "../util/solid-cells";
import type { ConstraintInput, ControlInput as CoreControl, Landmark, MotionEdits as CoreEdits } from "./abi";

export { FPS } from "../util/constants";

export type BodyPart = Exclude<CorePart, "none">;
export type BodySide = Exclude<CoreSide, "none">;

export interface MeshInput {
  /** V x 3, stage. */
  positions: Float32Array;
  /** F x 3. */
  faces: Uint32Array;
}

export interface BoundMeshInput extends MeshInput {
  /** V: of which part each vertex is, as in limbParts; parts that touch or cross do not grow together in a solid. */
  parts?: Int32Array | null;
  /** What is solved: the surface itself, or a solid inside it that carries it; default "surface". */
  solve?: Solve;
  /** V: how much stiffer the model is there than elsewhere, above 0; null (default): 1 everywhere. */
  rigidity?: Float32Array | null;
  /** Deforms as the paper does: cells scale freely, and what points hold does not turn by itself. */
  paper?: boolean;
}

export type { SolidCells };

export interface MeshReport {
  vertices: number;
  faces: number;
  /** Volume in cubic metres, of what is solved; null for an open surface. */
  volume: number | null;
  boundaryEdges: number;
  nonManifoldEdges: number;
  shells: number;
  /** Vertices that no face uses. */
  isolatedVertices: number;
  degenerateFaces: number;
  /** What carries it, where a solid is solved. */
  solid: SolidCells | null;
}

export type AxisName = "+x" | "-x" | "+y" | "-y" | "+z" | "-z";

/** Where a mesh is held; a ball unless `slab` says otherwise. */
export type ControlInput = Pick<CoreControl, "vertex" | "radius"> & Partial<CoreControl>;

export type { Solve };

/** What a point of a body is; a tip is an extremity without a name: an ear, a horn, a wing. */
export type { BodyRole };

/** A place where a model may well be held. */
export interface BodyPoint {
  vertex: number;
  role: BodyRole;
  /** The body's own; null in the middle. */
  side: "left" | "right" | null;
  /** Index of the same point on the other side; its own on the plane of symmetry; -1 where there is none. */
  partner: number;
  /** Geodesic radius of what moves as one piece with it, in the mesh's units. */
  radius: number;
  /** A body needs it to dance; the others are there to be chosen. */
  wanted: boolean;
}

export type { Landmark };

/** A mesh in its file's axes and units. */
export interface ShapeInput extends MeshInput {
  /** What files of its kind mostly hold upright; default "unknown". */
  axes?: FileAxes;
  /** How it stands, where that is known. */
  stands?: { up: AxisName; facing: AxisName } | null;
  /** Places that are named already: those of a role stand for all of that role, feet for forelegs too. */
  landmarks?: Landmark[];
}

/** What a bare mesh says of itself, in its own axes and units. A guess: it may be wrong, and is meant to be shown. */
export interface ShapeAnalysis {
  up: AxisName;
  /** Which way it looks. */
  facing: AxisName;
  /** How much speaks for both, 0..1: below a half it is as well to ask. */
  sure: number;
  /** The plane in which it is its own mirror image, within 2 % of its diagonal; null: it is not. */
  symmetry: { point: [number, number, number]; normal: [number, number, number]; misfit: number } | null;
  /** At most 32, those that are wanted first. */
  points: BodyPoint[];
}

/** A file of text, under the name that people know it by. */
export interface TextFile {
  name: string;
  text: string;
}

/** A motion in any format that the core reads, with the skeleton beside it if its format has one. */
export interface MotionInput extends TextFile {
  skeleton?: TextFile;
  edits?: MotionEdits;
}

/** What is said of a motion: its file where a guess would be wrong, and what of it is danced, and how. */
export interface MotionEdits extends CoreEdits {
  /** Names of its hips, head, left and right hand, left and right foot; "": guessed. */
  joints: readonly string[];
}

export interface Joint {
  name: string;
  /** -1 for the root. */
  parent: number;
  /** What it is of the body, as no other joint is; null on the middle line, or where that cannot be told. */
  side: BodySide | null;
  part: BodyPart | null;
}

/** A clip resampled to 30 fps. */
export interface Motion {
  frames: number;
  /** Of the whole of it, before it was cut. */
  takeFrames: number;
  joints: Joint[];
  /** Whether its feet and its head or hands can be told. */
  told: boolean;
  /** T x J x 3, world metres; the floor under the feet is y = 0. */
  positions: Float32Array;
  /** T x J x 3, body-local: root at the origin, yaw removed. */
  local: Float32Array;
  /** T, radians about +Y, unwrapped. */
  yaw: Float32Array;
  /** T each, 1 while the foot stands. */
  stands: { left: Uint8Array; right: Uint8Array };
  source: { frames: number; fps: number; metresPerUnit: number };
  /** What the reader worked around, in plain words; usually empty. */
  notes: string[];
}

export interface ExampleInput {
  /** J x 3 body-local metres, in the order of the loaded motion's joints; NaN where the example does not know the joint. */
  joints: Float32Array;
  /** C x 3, stage. */
  controls: Float32Array;
}

export type { ConstraintInput };

/**
 * Where a control stands, said by the user instead of taken from the motion: half-open runs of frames, which replace that
 * control's own. Without runs it never stands.
 */
export interface ContactInput {
  control: number;
  runs: [number, number][];
}

export interface RetargetInput {
  /** C: joint index that drives each control, or -1 (it follows the whole pose). */
  pairs: Int32Array;
  examples: ExampleInput[];
  /** lambda_A at 30 fps. */
  smoothness: number;
  /** lambda_v. */
  volume: number;
  groundContact: boolean;
  inPlace: boolean;
  /** -1 calm, 0 as taught, 1 as in a cartoon; default 0. */
  energy?: number;
  /** C: how controls without a joint hang on the body; default stiff. */
  follow?: FollowThrough[];
  /** Constraints on single controls at single frames; default none. Repeated or contradicting ones meet half way: see `missed`. */
  constraints?: ConstraintInput[];
  /** Only the controls whose contacts were edited; default none. */
  contacts?: ContactInput[];
  /** Supported-to-supported frame pairs [a, b]; null (default): from the motion. */
  flights?: [number, number][] | null;
  /** C: each control's partner (itself on the plane, -1: none): examples are doubled by their mirror images; null (default): off. */
  mirror?: Int32Array | null;
  /** C: how much the whole pose counts beside each control's own joint; null (default): .5 for each. */
  poseWeights?: Float32Array | null;
  /** How examples turn single controls: rotation vectors of the examples that know the control, images included; default none. */
  turns?: { control: number; ways: Float32Array }[];
  /** Learns as the paper does: a control from its joint and the four nearest examples alone. */
  paper?: boolean;
  /** The mesh's plane of symmetry, stage; null (default): x = 0. Only its direction counts: controls mirror how they move from rest. */
  mirrorPlane?: { point: [number, number, number]; normal: [number, number, number] } | null;
}

/** How the model's points move; vertices follow by frame(). */
export interface Performance {
  frames: number;
  /** T x C x 3, body-local stage metres: the deformer's targets. */
  controls: Float32Array;
  /** T x C x 3: rotation vectors by which controls turn beyond what surrounds them; null: none does. */
  turns: Float32Array | null;
  /** T x C, 1 while the control stands on the ground. */
  contacts: Uint8Array;
  /** Half-open supported-to-supported frame pairs [a, b]. */
  flights: [number, number][];
  /** T, radians put back after deforming. */
  yaw: Float32Array;
  /** T x 3, metres: x and z of the model's origin; how high its lowest vertex is, but in flights. */
  travel: Float32Array;
  /** Mean horizontal speed of standing controls, metres per second, before and after the foot lock. */
  slip: { before: number; after: number };
  /**
   * In the order of the input: metres by which each constraint is missed, 0 where it holds; and the index of the constraint that
   * it contradicts, -1 where there is none (what is missed then stands against the ground).
   */
  missed: { worst: Float32Array; against: Int32Array };
  /**
   * T, how far each frame is from what the user's poses (not the starters) teach: 0 taught, about 1 as far as a random frame is
   * from the mean pose. With no pose at all, the distance from a random frame (1.4 on average).
   */
  coverage: Float32Array;
  /** Frames worth coverage next, best first (at most 8), given the poses there are; gain: by how much the mean coverage (rms) falls. */
  ask: { frame: number; gain: number }[];
  /** The user's poses (mirror images counted) and how many would bring the rms of the coverage below .15; never less than `have`. */
  enough: { have: number; want: number };
  /** Synthesised poses still in use beside the user's. */
  starters: number;
  /** T x C, contacts before edits; `contacts` and `flights` are those after. */
  sourceContacts: Uint8Array;
  milliseconds: number;
}

/** What is known of a deformed frame. */
interface Deformed {
  /** Volume over rest volume; null for an open surface. */
  volumeRatio: number | null;
  /** World: x, y, z of the model's origin and yaw; zeros for a dragged frame. */
  root: [number, number, number, number];
  milliseconds: number;
}

/** One deformed frame. Retargeted: in world metres, on the ground. Dragged: body-local. The receiver owns its array. */
export interface Frame extends Deformed {
  /** V x 3. */
  positions: Float32Array;
}

/** The same as it is drawn: where a solid carries the mesh, nothing of it is as large as the mesh. */
export interface ShapedFrame extends Deformed {
  /** V x 3 positions; or, of a solid, N x 12: rows of (B | b), by which a node takes what is around it from x to B x + b. */
  shape: Float32Array;
}

export type EngineErrorCode =
  | "bad_mesh"
  | "bad_motion"
  | "bad_controls"
  | "bad_examples"
  | "cancelled"
  | "superseded"
  | "engine_lost"
  | "out_of_memory";

/** Every promise of the engine rejects with this and nothing else. `message` is made to be shown. */
export class EngineError extends Error {
  constructor(
    readonly code: EngineErrorCode,
    message: string,
  ) {
    super(message);
    this.name = "EngineError";
  }
}

export interface CallOptions {
  signal?: AbortSignal;
  /** 0..1 */
  onProgress?: (done: number) => void;
}

export interface DragOptions {
  volume: number;
  restart?: boolean;
  /** C x 3, as in a performance. */
  turns?: Float32Array | null;
}

/** V vertices, F frames. */
export interface SkinInput extends MeshInput {
  /** V x 3 each, of all motions that share the skin. */
  frames: readonly Float32Array[];
  /** At most so many joints: the fewest that are like the frames to .13 % rms and .8 % in the worst place, if so many do. */
  joints: number;
}

/** J joints. Errors are in diagonals of the box around the mesh. A pose is a quaternion x, y, z, w and a place. */
export interface BuiltSkin {
  /** J x 3, at rest. */
  centres: Float32Array;
  /** V x 4. */
  joints: Uint8Array;
  /** V x 4; four sum to one. */
  weights: Float32Array;
  /** F x 7, about the origin: comes after the joints. */
  roots: Float32Array;
  /** F x J x 7: p goes to turn (p - centre) + place. */
  poses: Float32Array;
  /** K x V x 3 and F x K: morph targets that act before the joints do; none where joints are enough. */
  ways: Float32Array;
  mix: Float32Array;
  rms: number;
  worst: number;
  /** Radians, rms. */
  normals: number;
}

/** V vertices, F frames. */
export interface MorphsInput extends Pick<SkinInput, "positions" | "frames"> {
  /** At most so many: the fewest that are like the frames to .13 % rms and .8 % in the worst place, if so many do. */
  targets: number;
}

/** K targets. Vertex v is at root (rest + sum_k weight_k way_k). */
export interface BuiltMorphs extends Pick<BuiltSkin, "roots" | "rms" | "worst"> {
  /** K x V x 3. */
  ways: Float32Array;
  /** F x K: of each the largest is 1 or -1. */
  weights: Float32Array;
}

/** Wherever it runs. Rejects with EngineError: bad_mesh, out_of_memory; on abort with the signal's reason. */
export type BuildSkin = (input: SkinInput, options?: CallOptions) => Promise<BuiltSkin>;
/** As that one. */
export type BuildMorphs = (input: MorphsInput, options?: CallOptions) => Promise<BuiltMorphs>;

export interface Engine {
  /** Binds a mesh; forgets controls. Rejects with bad_mesh; the previous mesh stays. */
  setMesh(mesh: BoundMeshInput, options?: CallOptions): Promise<MeshReport>;
  /** Guesses how a mesh stands and where to hold it; binds nothing. Any axes and units. Rejects with bad_mesh. */
  analyseShape(mesh: ShapeInput, options?: CallOptions): Promise<ShapeAnalysis>;
  /** Binds controls on the present mesh (ordering, factorisation). */
  setControls(controls: ControlInput[], options?: CallOptions): Promise<void>;
  /** Reads a motion; on failure (bad_motion) the previous one stays. */
  setMotion(motion: MotionInput, options?: CallOptions): Promise<Motion>;
  /**
   * Deforms towards C x 3 body-local targets from where the last drag left the mesh. One slot: a newer drag rejects the older
   * with "superseded".
   */
  drag(targets: Float32Array, options: DragOptions): Promise<ShapedFrame>;
  /**
   * Solves the whole clip for the present mesh, controls and motion. `onLook`: is told frame 0 of a motion of minutes, nearly as it
   * will be, before all of it is solved.
   */
  retarget(input: RetargetInput, options?: CallOptions, onLook?: (frame: ShapedFrame) => void): Promise<Performance>;
  /** Deforms frames of the last performance, in the order asked for, as each is ready. Depends on nothing but the inputs. */
  frames(order: ArrayLike<number>, onFrame: (frame: number, result: Frame) => void, options?: CallOptions): Promise<void>;
  /** The same frames as they are drawn. */
  shapes(order: ArrayLike<number>, onShape: (frame: number, result: ShapedFrame) => void, options?: CallOptions): Promise<void>;
  /** Ends the worker; every pending call rejects with engine_lost. */
  close(): void;
}
