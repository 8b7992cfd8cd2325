// What the user said: everything that a project file holds, and nothing that can be computed from it.
// Immutable. The JSON of a project file with one performer is exactly a ProjectDocument; docs/project-format.md explains each field.

export type Vec3 = readonly [number, number, number];

/** An axis of the model file. */
export type Axis = "+x" | "-x" | "+y" | "-y" | "+z" | "-z";

export interface MeshRef {
  /** Path of the model, relative to the project file. */
  readonly file: string;
  /** Which way the model looks, in the file's own axes. Default "+z". */
  readonly facing: Axis;
  /** Which way is up, in the file's own axes. Default "+y". */
  readonly up: Axis;
  /** What is solved: the model's own surface, as in a clean closed one, or a solid inside it that carries it. Default "surface". */
  readonly solve?: Solve;
}

export type Solve = "surface" | "solid";

export interface MotionRef {
  /** One .bvh, or one .asf and one .amc; relative to the project file. */
  readonly files: readonly string[];
}

export type FollowThrough = "stiff" | "bouncy" | "floppy";

/** Of points without a joint. */
export const DEFAULT_FOLLOW: FollowThrough = "bouncy";

/** Of points with a joint. */
export const DEFAULT_WHOLE_POSE = 0.5;

/** A control point: a place on the model and the joint that it follows. */
export interface Point {
  readonly id: string;
  readonly name: string;
  /** On the rest surface, in the model file's own units and axes; the nearest vertex is used. */
  readonly position: Vec3;
  /** Name of the joint that drives it; null: it follows the whole pose. */
  readonly joint: string | null;
  /** How far what it holds reaches, in model heights: a disc along a surface, a ball in a solid; default 0.05. */
  readonly radius?: number;
  /** In a solid it holds a level slab instead of a ball: a trunk does not spin about a slab. */
  readonly slab?: boolean;
  /** Without a joint: how it hangs on the body; default DEFAULT_FOLLOW. */
  readonly follow?: FollowThrough;
  /** With a joint: how much the whole pose counts beside it; default DEFAULT_WHOLE_POSE. */
  readonly wholePose?: number;
  /** Id of the same point on the other side; its own in the middle. One that is not there counts as none. */
  readonly mirror?: string;
}

/** "When the human does this, my model does that." */
export interface Example {
  readonly id: string;
  /** Where it came from: a motion file's name and a frame at 30 fps. Only for showing it on the timeline. */
  readonly source: { readonly motion: string; readonly frame: number };
  /** Body-local joint positions in metres, by joint name: all joints of the skeleton it was made on. */
  readonly joints: Readonly<Record<string, Vec3>>;
  /** Positions of the points by id, in the model file's own units and axes. A point that is missing keeps its rest position. */
  readonly points: Readonly<Record<string, Vec3>>;
  /** By how much points turn beyond what surrounds them, by id: rotation vectors in radians, in the model file's own axes. */
  readonly turns?: Readonly<Record<string, Vec3>>;
}

/** A part of the model that keeps its shape. */
export interface StiffPart {
  readonly id: string;
  /** On the rest surface, as a point's. */
  readonly position: Vec3;
  /** How far it reaches along the surface, in model heights; without: over the whole piece that is connected there. */
  readonly radius?: number;
}

export interface Settings {
  /** lambda_v: 0 flat, 1 natural, 3 juicy. */
  readonly volume: number;
  /** lambda_A at 30 fps: 0 snappy, 1 floaty; default DEFAULT_SMOOTHNESS. */
  readonly smoothness: number;
  /** -1 calm, 0 as taught, 1 as in a cartoon. */
  readonly energy: number;
  /** Feet do not slide. */
  readonly groundContact: boolean;
  /** Root motion in the plane is left out. */
  readonly inPlace: boolean;
  /** Every pose also teaches its mirror image, through the partners of the points. */
  readonly symmetry: boolean;
  /** Deforms and learns as the paper does; energy, ground contact, symmetry and what points say of themselves rest. */
  readonly paper?: boolean;
}

/** A constraint about a point at one frame of a clip. */
export interface Pin {
  readonly id: string;
  readonly point: string;
  /** Of the whole motion, at 30 fps. */
  readonly frame: number;
  /** "place": it is at `position`; "still": it is where it was a frame before; "level": it is as high as `other`; "moves": it comes from
   * the frame before with `velocity`. */
  readonly kind: "place" | "still" | "level" | "moves";
  /** Body-local, in the model file's own units and axes, as in an example. */
  readonly position?: Vec3;
  readonly other?: string;
  /** Body-local, in the model file's own units per second of the motion, and axes. */
  readonly velocity?: Vec3;
}

/** Roles of joints that can be said of a motion whose joints were taken for others. */
export const SAID_ROLES = ["hips", "head", "left hand", "right hand", "left foot", "right foot"] as const;
export type SaidRole = (typeof SAID_ROLES)[number];

/** What a motion's file is, where the guess is wrong. What is left out is guessed. */
export interface FileFacts {
  readonly metresPerUnit?: number;
  readonly fps?: number;
  readonly up?: "+y" | "-y" | "+z" | "-z";
  /** So many degrees it is turned about the vertical, counter-clockwise from above. */
  readonly turn?: 90 | 180 | 270;
  /** Names of joints by role. */
  readonly joints?: Readonly<Partial<Record<SaidRole, string>>>;
}

/** What was said about one motion on this model, beyond its poses. Frames are those of the whole motion, however it is cut. */
export interface ClipEdits {
  readonly file?: FileFacts;
  /** The first and the last frame that are danced. */
  readonly cut?: readonly [number, number];
  /** How fast it is danced; default 1. */
  readonly speed?: number;
  /** Danced as a mirror shows it. */
  readonly mirror?: boolean;
  /** It ends as it begins. */
  readonly loop?: boolean;
  readonly pins?: readonly Pin[];
  /** By point: half-open runs of frames in which it stands, instead of the motion's own. */
  readonly contacts?: Readonly<Record<string, readonly (readonly [number, number])[]>>;
  /** Frame pairs: the last that stands before a flight, and the first after it, instead of the motion's own. */
  readonly flights?: readonly (readonly [number, number])[];
}

/** Who dances: a model, what moves it, and what it was taught. */
export interface Dancer {
  readonly mesh: MeshRef;
  readonly motion: MotionRef;
  readonly points: readonly Point[];
  readonly examples: readonly Example[];
  readonly stiff?: readonly StiffPart[];
  /** Roles of joints whose names do not tell them, such as "left foot", by the name that a point or an example says. */
  readonly joints?: Readonly<Record<string, string>>;
  /** By the motion file's name, without folders. */
  readonly clips?: Readonly<Record<string, ClipEdits>>;
  readonly settings: Settings;
}

/** When and where somebody dances beside the one in hand. */
export interface Offset {
  /** So much later; below 0 earlier. */
  readonly seconds: number;
  /** Metres to the left and to the front, as the one in hand looks, from where that one begins. */
  readonly place: readonly [number, number];
  /** Radians about the vertical, counter-clockwise from above. */
  readonly yaw: number;
}

/** Who dances beside the one in hand. */
export interface Companion extends Omit<Dancer, "motion"> {
  /** Left out: the motion of the one in hand, cut and sped up as that is. */
  readonly motion?: MotionRef;
  readonly offset: Offset;
}

/** What there is of the dancer in hand, and who dances beside. */
export interface ProjectDocument extends Dancer {
  readonly version: 1;
  readonly name: string;
  readonly companion?: Companion | undefined;
}
