// Turns what the core says in numbers (math/status.h) into sentences for the person who chose the file:
// what happened, where, and what to do.

import { CORE_ERROR_NAMES, PERSON_HEIGHT } from "../util/constants";
import type { CoreError, LengthUnit, UpAxis } from "../util/constants";
import type { MotionNotes, PackedStatus } from "./abi";
import { EngineError } from "./types";
import type { EngineErrorCode } from "./types";

/** What the engine was asked to take in when the core refused. */
export type Subject =
  | { kind: "motion"; name: string; text: string; skeleton?: unknown }
  /** What lies beside a motion. */
  | { kind: "skeleton"; name: string; text: string }
  | { kind: "mesh" }
  | { kind: "controls" }
  | { kind: "retarget" }
  | { kind: "frames" };

function unpackStatus(packed: PackedStatus): { error: CoreError; where: number } {
  const error = Math.floor(packed / 2 ** 32);
  return { error: CORE_ERROR_NAMES[error], where: (packed - error * 2 ** 32) | 0 };
}

export function engineError(packed: PackedStatus, subject: Subject): EngineError {
  const { error, where } = unpackStatus(packed);
  if (error === "out_of_memory") return outOfMemory();
  switch (subject.kind) {
    case "mesh":
      return new EngineError("bad_mesh", meshMessage(error, where));
    case "controls":
      return new EngineError("bad_controls", controlsMessage(error, where));
    case "retarget":
      return retargetError(error, where);
    case "frames":
      return new EngineError("bad_examples", `Frame ${count(where + 1)} is not in this motion.`);
    default:
      return new EngineError("bad_motion", motionMessage(error, where, subject));
  }
}

export function outOfMemory(): EngineError {
  return new EngineError("out_of_memory", "There is not enough memory for this. A model with fewer triangles would fit.");
}

const count = (n: number) => n.toLocaleString("en-US");

/** Letters of a line at fault. */
const MOST_QUOTED = 40;

function motionMessage(error: CoreError, where: number, subject: Extract<Subject, { name: string }>): string {
  const { kind, name, text } = subject;
  const line = where > 0 ? (text.split(/\r\n|\r|\n/, where)[where - 1] ?? "").trim() : "";
  const quoted = line.length > MOST_QUOTED ? `${line.slice(0, MOST_QUOTED)}…` : line;
  const at = where > 0 ? `${name}, line ${count(where)}${quoted && ` (${quoted})`}` : name;
  const stops = where > 0 ? `${name} stops in line ${count(where)}` : `${name} stops too early`;
  switch (error) {
    case "empty_input":
      return `${name} is empty. Choose a file with a motion in it.`;
    case "not_this_format":
      return `${name} is not a ${kind} in a format that Rigless reads, or begins with something else. Choose another file.`;
    case "unexpected_end":
      return `${stops}: more of the ${kind} should follow. It may be cut off; download or export it again.`;
    case "bad_number":
      return `${at}: a number is missing or cannot be read. Correct this line, or export the file again.`;
    case "bad_syntax":
      return `${at}: this line is not what the format asks for here. Correct it, or export the file again.`;
    case "unknown_joint":
      return subject.kind === "motion" && subject.skeleton
        ? `${at}: this bone is not in the skeleton. Choose the skeleton that belongs to this motion.`
        : `${at}: this joint was never declared. Export the file again.`;
    case "duplicate_joint":
      return `${at}: this joint's name is used twice. Give one of the two another name.`;
    case "unsupported":
      return `${at}: this is valid but cannot be used here. Export the motion again, in another format.`;
    case "no_frames":
      return `${name} has no whole frame of motion in it. Choose a file that holds a motion, not only a pose.`;
    case "not_finite":
      return `${at}: a number is infinite or not a number. Correct this line, or export the file again.`;
    default:
      return `${at}: the motion could not be read (${error.replaceAll("_", " ")}).`;
  }
}

const UNITS: Record<LengthUnit, string> = {
  metre: "",
  centimetre: "centimetres",
  millimetre: "millimetres",
  inch: "inches",
  cmu: "CMU units of 0.45 inch",
  foot: "feet",
  none: "",
};

const UPS: Record<UpAxis, string> = {
  y: "",
  z: "the Z axis points up; it was turned upright",
  minus_y: "people stand on their heads; it was turned upright",
  minus_z: "the Z axis points down; it was turned upright",
};

/** What a reader worked around or guessed; `fps`: how fast it plays. */
export function motionNotes(name: string, found: MotionNotes, fps: number): string[] {
  const { framesDeclared: declared, framesRead: read, roots, renamed, lengthsIgnored: lengths, unit } = found;
  const notes: string[] = [];
  if (declared > read) notes.push(`${name} announces ${count(declared)} frames and holds ${count(read)}: these are used.`);
  else if (found.frameCut) notes.push(`The last frame of ${name} is incomplete and left out: ${count(read)} frames are used.`);
  if (found.textAfterEnd) notes.push(`${name} goes on after its ${count(read)} announced frames; the rest is not used.`);
  if (found.frameTimeAssumed) notes.push(`${name} does not say how fast it plays: ${Math.round(fps)} frames per second are assumed.`);
  if (found.frameTimeUnit !== "seconds")
    notes.push(`${name} has its frame time in ${found.frameTimeUnit === "rate" ? "frames a second" : "milliseconds"}, and is read so.`);
  if (found.frameNumbers) notes.push(`Each row of ${name} begins with its number, which is not read.`);
  if (found.rowsReplaced > 0)
    notes.push(
      `${name} has ${found.rowsReplaced === 1 ? "a row" : `${count(found.rowsReplaced)} rows`} of a wrong length, first in line ` +
        `${count(found.rowReplaced)}: the frame before stays.`,
    );
  if (found.radians) notes.push(`The angles of ${name} seem to be in radians, and are read so.`);
  if (roots > 1) notes.push(`${name} holds ${count(roots)} figures; the first is used.`);
  if (renamed > 0) notes.push(`${count(renamed)} ${renamed === 1 ? "joint has" : "joints have"} no name of its own and got a number.`);
  if (lengths > 0)
    notes.push(`${name} changes the length of ${count(lengths)} ${lengths === 1 ? "bone" : "bones"}; the lengths at rest are used.`);
  if (found.jointsFolded > 0) notes.push(`The motion of what stands above the hips in ${name} is theirs.`);
  if (UPS[found.up] !== "") notes.push(`In ${name} ${UPS[found.up]}.`);
  if (found.poseInFront > 0) notes.push(`The pose in front of ${name} is left out.`);
  if (found.facedAway) notes.push(`${name} begins facing away; it was turned around.`);
  if (unit === "none") notes.push(`${name} is in no common unit; the person in it was made ${PERSON_HEIGHT} m tall.`);
  else if (UNITS[unit] !== "") notes.push(`${name} seems to be in ${UNITS[unit]}.`);
  return notes;
}

function meshMessage(error: CoreError, where: number): string {
  switch (error) {
    case "empty_input":
    case "no_faces":
      return "The model has no triangles. Choose a file that holds a surface.";
    case "index_out_of_range":
      return `Triangle ${count(where + 1)} of the model uses a point that does not exist. Export the model again.`;
    case "not_finite":
      return `Point ${count(where + 1)} of the model has no position (not a number). Export the model again.`;
    case "factorization_failed":
      return "The model's triangles cannot be computed with. Export the model again, or repair it in a modelling program.";
    default:
      return `The model could not be used (${error.replaceAll("_", " ")}).`;
  }
}

function controlsMessage(error: CoreError, where: number): string {
  switch (error) {
    case "no_controls":
      return where >= 0
        ? `Nothing holds the piece of the model around point ${count(where + 1)}. Place a control on it.`
        : "Nothing holds the model yet. Place a control on it.";
    case "index_out_of_range":
      return `Control ${count(where + 1)} is not on the model. Place it again.`;
    case "not_finite":
      return `Control ${count(where + 1)} has no position (not a number).`;
    case "factorization_failed":
      return "These controls do not hold the model. Move one of them to another place.";
    case "size_mismatch":
      return "The number of positions is not the number of controls.";
    default:
      return `The controls could not be used (${error.replaceAll("_", " ")}).`;
  }
}

function retargetError(error: CoreError, where: number): EngineError {
  const make = (code: EngineErrorCode, message: string) => new EngineError(code, message);
  switch (error) {
    case "no_controls":
      return make("bad_controls", "The model has no controls yet. Place at least one.");
    case "index_out_of_range":
      return make("bad_controls", `Control ${count(where + 1)} follows a joint that this motion does not have. Pair it again.`);
    case "no_frames":
      return make("bad_motion", "There is no motion yet. Choose one.");
    case "no_examples":
      return make("bad_examples", "There is no pose to learn from. Add one.");
    case "not_finite":
      return make("bad_examples", `Pose ${count(where + 1)} has no usable positions (not a number). Make it again.`);
    case "bad_constraint":
      return make("bad_examples", `Pin ${count(where + 1)} is for a point, a frame or a place that does not exist. Remove it.`);
    case "infeasible":
      return make("bad_examples", "The poses contradict each other. Change or remove one of them.");
    case "size_mismatch":
      return make("bad_examples", "A pose does not have as many joints or controls as the motion and the model.");
    default:
      return make("bad_examples", "The motion cannot be carried over from these poses. Change or remove one of them.");
  }
}
