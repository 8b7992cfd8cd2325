// The npm package: a motion onto a mesh in one call. What stands between them (the stage, welded vertices, guesses, joints by
// name) is the package's, not the caller's.

import { newDocument } from "../document/commands";
import { parseProject, serializeProject } from "../document/project";
import { fromStage } from "../document/stage-transform";
import type { Axis, Example, Point, ProjectDocument, Settings, Vec3 } from "../document/types";
import { EngineError, FPS } from "../engine/types";
import type { Engine, Motion, MotionInput } from "../engine/types";
import { buildSurface } from "../io/surface";
import type { JointRoles } from "../skeleton/pair-joints";
import { bake } from "../sync/bake";
import { Binding } from "../sync/binding";
import { guessProject } from "../sync/guess";
import type { NamedJoint } from "../sync/named-body";
import { pairingNotes, sayPose } from "../sync/pairing";
import { type SolverModel, stageFor } from "../sync/placement";
import { shapeInput } from "../sync/shape-input";

/** Any units, any axes. Vertices may be there twice, at the seams of a texture for example, or unused. */
export interface Mesh {
  /** V x 3. */
  readonly positions: ArrayLike<number>;
  /** F x 3, counter-clockwise. */
  readonly faces: ArrayLike<number>;
  /** The name of its file: kinds of files agree on which way up they hold a body, OBJ on +y for example and STL on +z. */
  readonly file?: string;
  /** The skeleton that its file brings: names tell where its head, hands and feet are. */
  readonly joints?: readonly NamedJoint[];
  /** Which way is up and which way it looks, in its own axes; by default guessed from its shape. */
  readonly up?: Axis;
  readonly facing?: Axis;
}

/** The text of a motion file; with that of the skeleton beside it where its format has one, as an AMC has an ASF. */
export type MotionText = string | { readonly text: string; readonly skeleton: string };

/** "When the human does this, my mesh does that." */
export interface Pose {
  /** What the human does: a frame of the motion (at 30 fps), or body-local joint positions in metres by name. */
  readonly human: number | Example["joints"];
  /** Where points are, by id, in the mesh's own units and axes; the others keep their rest position. */
  readonly points: Readonly<Record<string, Vec3>>;
}

export interface RetargetTask {
  readonly mesh: Mesh;
  readonly motion: MotionText;
  /** Places on the mesh and the joints that they follow; by default guessed from its shape. */
  readonly points?: readonly Point[];
  /** By default none: the mesh moves as the human does. */
  readonly poses?: readonly Pose[];
  readonly settings?: Partial<Settings>;
}

export interface RetargetOptions {
  /** Rejects with EngineError "cancelled". */
  readonly signal?: AbortSignal;
  /** What is being done, and 0..1 of it. */
  readonly onProgress?: (step: string, done: number) => void;
}

/** A mesh that moves: frames at 30 fps. */
export interface Dance {
  readonly fps: number;
  readonly frames: number;
  /** How the mesh was taken to stand. */
  readonly up: Axis;
  readonly facing: Axis;
  /** As they were given or guessed. */
  readonly points: readonly Point[];
  /** What was guessed or worked around, in plain words. */
  readonly notes: readonly string[];
  /** V x 3, the caller's vertices in the mesh's own units and axes; a new array. Those that no face uses stay. */
  frame(index: number): Float32Array;
}

export interface Rigless {
  /**
   * Binds, solves and deforms the whole motion, one task after the other. Keeps about V x 3 floats per frame.
   * Rejects with ModelError (mesh), DocumentError (points, poses, settings) or EngineError (motion, cancelled, and what cannot be solved).
   */
  retarget(task: RetargetTask, options?: RetargetOptions): Promise<Dance>;
  /** Ends the engine; in Node the process stays alive until then. */
  close(): void;
}

const NAME = "The mesh";

/** What both entries share: they differ in how an engine is made. */
export class RiglessWithEngine implements Rigless {
  private queue: Promise<unknown> = Promise.resolve();
  private closed = false;

  private constructor(
    private readonly createEngine: () => Promise<Engine>,
    private engine: Engine,
  ) {}

  static async create(createEngine: () => Promise<Engine>): Promise<Rigless> {
    return new RiglessWithEngine(createEngine, await createEngine());
  }

  retarget(task: RetargetTask, options: RetargetOptions = {}): Promise<Dance> {
    const dance = this.queue.then(() => this.inTurn(task, options));
    this.queue = dance.catch(() => undefined);
    return dance;
  }

  close(): void {
    this.closed = true;
    this.engine.close();
  }

  private async inTurn(task: RetargetTask, options: RetargetOptions): Promise<Dance> {
    try {
      return await retarget(this.engine, task, options);
    } catch (error) {
      // One that died is replaced for whoever asks next.
      if (!this.closed && error instanceof EngineError && error.code === "engine_lost") this.engine = await this.createEngine();
      throw error;
    }
  }
}

async function retarget(engine: Engine, task: RetargetTask, options: RetargetOptions): Promise<Dance> {
  const { signal, onProgress } = options;
  const notes: string[] = [];
  const { positions, faces } = task.mesh;
  const surface = buildSurface(NAME, { positions, triangles: faces }, notes);
  const binding = new Binding(engine);
  const input = motionInput(task.motion);
  const motion = await binding.takeMotion({ motion: { files: [input.name] } }, input, (step) => ({
    ...(signal && { signal }),
    onProgress: (done) => onProgress?.(step, done),
  }));
  const document = await documentOf(engine, task, surface, motion, signal);
  const baked = await bake(binding, document, { model: surface, motion: input }, options);
  const { up, facing } = document.mesh;
  const stage = stageFor(surface, document.mesh);
  return {
    fps: FPS,
    frames: baked.frames.length,
    up,
    facing,
    points: document.points,
    notes: [...notes, ...motion.notes, ...pairingNotes(document, motion)],
    frame: (index) => {
      const frame = baked.frames[index];
      if (!frame) throw new RangeError(`There is no frame ${index}: they go from 0 to ${baked.frames.length - 1}.`);
      return onCallersVertices(fromStage(stage, frame.positions), positions, surface.vertexOf);
    },
  };
}

function motionInput(motion: MotionText): MotionInput {
  const name = "The motion";
  if (typeof motion === "string") return { name, text: motion };
  return { name, text: motion.text, skeleton: { name: "The skeleton", text: motion.skeleton } };
}

/** What a project file would say; what the task leaves open is guessed. */
async function documentOf(
  engine: Engine,
  { mesh, points, poses = [], settings }: RetargetTask,
  surface: SolverModel,
  motion: Motion,
  signal?: AbortSignal,
): Promise<ProjectDocument> {
  const known = points !== undefined && mesh.up !== undefined && mesh.facing !== undefined;
  const files = ["The motion"];
  const base = known
    ? newDocument("", { file: NAME, up: mesh.up, facing: mesh.facing }, { files })
    : guessProject(
        "",
        NAME,
        files,
        surface,
        await engine.analyseShape(shapeInput({ ...surface, name: mesh.file ?? NAME, ...(mesh.joints && { joints: mesh.joints }) }), {
          ...(signal && { signal }),
        }),
        motion.joints,
      );
  const said = poses.map((pose, n) => exampleOf(base, pose, n, motion));
  const document: ProjectDocument = {
    ...base,
    joints: Object.assign({}, base.joints, ...said.map(({ roles }) => roles)) as JointRoles,
    mesh: { file: NAME, up: mesh.up ?? base.mesh.up, facing: mesh.facing ?? base.mesh.facing },
    points: points ?? base.points,
    examples: said.map(({ example }) => example),
    settings: { ...base.settings, ...settings },
  };
  if (document.points.length === 0) throw new EngineError("bad_controls", "There is no place to hold the mesh by. Give it points.");
  return parseProject(serializeProject(document), "The task").document;
}

function exampleOf(document: ProjectDocument, { human, points }: Pose, n: number, motion: Motion): { example: Example; roles: JointRoles } {
  const id = String(n);
  if (typeof human !== "number") return { example: { id, source: { motion: "The motion", frame: 0 }, joints: human, points }, roles: {} };
  if (!(Number.isInteger(human) && human >= 0 && human < motion.frames)) {
    throw new EngineError("bad_examples", `Pose ${n + 1} is at frame ${human}, but the motion's go from 0 to ${motion.frames - 1}.`);
  }
  const J = motion.joints.length;
  const { joints, roles } = sayPose(document, motion, motion.local.subarray(3 * J * human, 3 * J * (human + 1)));
  return { example: { id, source: { motion: "The motion", frame: human }, joints, points }, roles };
}

function onCallersVertices(solved: Float32Array, rest: ArrayLike<number>, vertexOf: Int32Array): Float32Array {
  const out = Float32Array.from(rest);
  vertexOf.forEach((vertex, i) => {
    if (vertex >= 0) for (let k = 0; k < 3; k++) out[3 * i + k] = solved[3 * vertex + k];
  });
  return out;
}
