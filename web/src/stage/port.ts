// What stands on the stage and what the hand does there: said by the app, drawn by the viewport. It never solves.

import type { GltfDocument } from "../gltf/document";
import type { Drawn } from "../gltf/drawn";
import type { JointName } from "../skeleton/body-parts";
import type { SolidCells } from "../util/solid-cells";
import type { Standing } from "../util/standing";
import type { Studio } from "./studio";

/** A model as drawn: its document, and where what that shows stands at rest, in stage metres and axes. */
export interface DrawnModel extends Drawn {
  readonly document: GltfDocument;
  /** F x 3 over solver vertices, for picking and the ghost. */
  readonly faces: Uint32Array;
  /** V x 3: the solver vertices at rest. */
  readonly rest: Float32Array;
  /** What carries those; null where they are told themselves. */
  readonly solid: SolidCells | null;
}

/** How a model is shaped, in the world or its own place: V x 3 positions, or, where a solid carries it, N x 12 maps of its nodes. */
export type Shape = Float32Array;

export interface DrawnHuman {
  joints: readonly JointName[];
  parents: Int32Array;
}

/** A numbered mark on the model and, if paired, on the human. */
export interface PointMark {
  id: string;
  /** From 1; colour follows from it. */
  number: number;
  name: string;
  /** Solver vertex. */
  vertex: number;
  /** Joint, or -1 while unpaired. */
  joint: number;
  /** Not a point yet: a dashed mark that a click takes. */
  suggested?: boolean;
  /** The selected point's partner on the other side. */
  twin?: boolean;
}

/** From where it is seen. */
export type StageView = "front" | "three-quarter" | "side" | "top";

/** What the stage shows beside the figures and the points. */
export interface StageLook {
  /** "points": pair lines show, and a click on the mesh or on a joint picks it. Dots on the model drag in both. */
  mode: "pose" | "points";
  /** "side": human left, model right; "overlay": on the same spot. */
  layout: "side" | "overlay";
  /** Two rings around this dot of the model, three times, for a first visit; null stops them. */
  pulse: string | null;
  /** The pair line that follows the pointer starts at this dot. */
  livePair: string | null;
  /** The camera goes around slowly. */
  turning: boolean;
  /** The human asks for a pose of the model: drawn in blue pencil. */
  asking: boolean;
  /** Dashed ghost of a shape behind the model, world. */
  ghost: Shape | null;
  /** A second line on the tag of the dot in the hand, such as the volume; "" for none. */
  note: string;
}

export interface CompanionEvents {
  /** The hand takes it so far over the floor from where it was taken, in metres; not `held`: it was let go there. */
  move: { x: number; z: number; held: boolean };
}

/** Whoever dances beside the model. */
export interface CompanionPort {
  on<K extends keyof CompanionEvents>(name: K, listener: (detail: CompanionEvents[K]) => void): () => void;
  /** Answers once it can be seen. */
  setModel(model: DrawnModel): Promise<void>;
  /** In its own world; drawn at the next animation frame. */
  setShape(shape: Shape, standing: Standing): void;
  /** The model begins anew with the next shape, so far back: the companion goes on from where it is. */
  beginAgain(x: number, z: number): void;
  /** Where it begins, from where the model begins: what is framed does not move before that does. */
  setPlace(x: number, z: number): void;
  /** What a handle at its feet is called; null: it has none. */
  setHandle(words: string | null): void;
  dispose(): void;
}

export interface StageEvents {
  /** The pointer took a dot of the model. */
  "point-grab": { id: string };
  /** World position that the hand asks for. */
  "point-move": { id: string; position: [number, number, number] };
  "point-drop": { id: string };
  /** The pointer is within reach of a dot of the model, or no longer: what moves should wait for the hand. */
  "point-reach": { near: boolean };
  /** Esc or a lost pointer: put it back. */
  "point-cancel": { id: string };
  /** A click without a drag on a dot, on the model or on the human. */
  "point-pick": { id: string; on: "model" | "human" };
  "surface-pick": { vertex: number };
  "joint-pick": { joint: number };
  /** A click on nothing. */
  "empty-pick": Record<string, never>;
  "context-lost": Record<string, never>;
  "context-restored": Record<string, never>;
}

export interface Insets {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface StagePort {
  on<K extends keyof StageEvents>(name: K, listener: (detail: StageEvents[K]) => void): () => void;
  /** Answers once the model can be seen; until then nothing of it is. */
  setModel(model: DrawnModel | null): Promise<void>;
  /** World; drawn at the next animation frame. */
  setShape(shape: Shape): void;
  setHuman(human: DrawnHuman | null): void;
  /** J x 3 world metres. */
  setHumanPose(positions: Float32Array): void;
  /** The next positions are those of the clip's beginning, reached by its end: the figures go on from where they are. */
  beginAgain(): void;
  setPoints(points: readonly PointMark[], selected: string | null): void;
  /** What is left out stays as it is. */
  setLook(look: Partial<StageLook>): void;
  /** Where cards float over the stage, in CSS pixels; figures are framed in what is left. */
  setInsets(insets: Insets): void;
  /** Sees all, from the front unless told otherwise. */
  fit(view?: StageView): void;
  /** Small picture of a shape, local or world, as a data URL. */
  thumbnail(shape: Shape, size: number): string;
  /** For somebody beside the model, one at a time; not part of the first load. */
  companion(): Promise<CompanionPort>;
  /** For films of it; not part of the first load. */
  studio(): Promise<Studio>;
  dispose(): void;
}
