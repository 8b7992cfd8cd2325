// Numbers and names that the core knows too. Made by wasm/abi.mjs from wasm/abi.h: change that.

/** Of every performance. */
export const FPS = 30;

/** Metres, where nothing better is known. */
export const PERSON_HEIGHT = 1.7;

/** How tall a model stands on the stage, metres. */
export const STAGE_HEIGHT = 1.7;

/** How much of its width counts as height. */
export const WIDTH_SHARE = 0.6;

/** Of a point, in model heights. */
export const DEFAULT_RADIUS = 0.05;

/** Frames of a motion that may close. */
export const SHORTEST_LOOP = 8;

/** Weight of acceleration at 30 fps. */
export const DEFAULT_SMOOTHNESS = 0.3;

export const CORE_ERROR_NAMES = [
  "none",
  "empty_input",
  "not_this_format",
  "unexpected_end",
  "bad_number",
  "bad_syntax",
  "unknown_joint",
  "duplicate_joint",
  "unsupported",
  "no_frames",
  "no_faces",
  "index_out_of_range",
  "not_finite",
  "no_controls",
  "factorization_failed",
  "size_mismatch",
  "no_examples",
  "bad_constraint",
  "infeasible",
  "out_of_memory",
] as const;
export type CoreError = (typeof CORE_ERROR_NAMES)[number];

export const LENGTH_UNIT_NAMES = ["metre", "centimetre", "millimetre", "inch", "cmu", "foot", "none"] as const;
export type LengthUnit = (typeof LENGTH_UNIT_NAMES)[number];

export const FRAME_TIME_UNIT_NAMES = ["seconds", "milliseconds", "rate"] as const;
export type FrameTimeUnit = (typeof FRAME_TIME_UNIT_NAMES)[number];

export const UP_AXIS_NAMES = ["y", "z", "minus_y", "minus_z"] as const;
export type UpAxis = (typeof UP_AXIS_NAMES)[number];

export const BODY_ROLE_NAMES = ["tip", "head", "hand", "foot", "foreleg", "tail", "hips", "chest", "elbow", "knee"] as const;
export type BodyRole = (typeof BODY_ROLE_NAMES)[number];

export const FILE_AXES_NAMES = ["unknown", "y_up", "z_up", "y_up_by_rule"] as const;
export type FileAxes = (typeof FILE_AXES_NAMES)[number];

export const BODY_PART_NAMES = [
  "none",
  "hips",
  "spine",
  "chest",
  "neck",
  "head",
  "shoulder",
  "upper_arm",
  "lower_arm",
  "hand",
  "finger",
  "upper_leg",
  "lower_leg",
  "foot",
  "toe",
  "tip",
  "end",
] as const;
export type BodyPart = (typeof BODY_PART_NAMES)[number];

export const BODY_SIDE_NAMES = ["none", "left", "right"] as const;
export type BodySide = (typeof BODY_SIDE_NAMES)[number];

export const SOLVE_NAMES = ["surface", "solid"] as const;
export type Solve = (typeof SOLVE_NAMES)[number];

export const FOLLOW_THROUGH_NAMES = ["stiff", "bouncy", "floppy"] as const;
export type FollowThrough = (typeof FOLLOW_THROUGH_NAMES)[number];
