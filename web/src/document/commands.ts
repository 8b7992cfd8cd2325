// Everything that can be done to a document. Each command is a small pure function; an unknown id or a value that is
// already there gives the same document back.

import { DEFAULT_SMOOTHNESS } from "../util/constants";
import { forgetPoint } from "./clips";
import type { Command } from "./store";
import type { Axis, Example, MeshRef, MotionRef, Point, ProjectDocument, Settings, Solve } from "./types";

export const DEFAULT_SETTINGS: Settings = {
  volume: 1,
  smoothness: DEFAULT_SMOOTHNESS,
  energy: 0,
  groundContact: true,
  inPlace: false,
  symmetry: true,
};

/** Roles of joints by name, to be kept as far as the document names these joints. */
type Roles = NonNullable<ProjectDocument["joints"]>;

/** A project that has a model and a motion and says nothing else yet. */
export function newDocument(name: string, mesh: MeshRef, motion: MotionRef): ProjectDocument {
  return { version: 1, name, mesh, motion, points: [], examples: [], settings: DEFAULT_SETTINGS };
}

export const renameProject =
  (name: string): Command =>
  (document) =>
    change(document, { name });

/** Another model. Points and examples are places on the old one, so they go. */
export const setMesh =
  (mesh: MeshRef): Command =>
  ({ clips: _, joints: __, stiff: ___, ...document }) => ({ ...document, mesh, points: [], examples: [] });

/** Says how the same model stands. Points and examples are in the file's own axes, so they stay. */
export const turnMesh =
  (facing: Axis, up: Axis): Command =>
  (document) =>
    change(document, { mesh: change(document.mesh, { facing, up }) });

/** What of the same model is solved. */
export const solveMesh =
  (solve: Solve): Command =>
  (document) =>
    change(document, { mesh: change(document.mesh, { solve }) });

/** Another motion. Examples stay: they know joints by name. */
export const setMotion =
  (motion: MotionRef): Command =>
  (document) =>
    change(document, { motion });

export const setSettings =
  (settings: Partial<Settings>): Command =>
  (document) =>
    change(document, { settings: change(document.settings, settings) });

export const addPoint =
  (point: Point, roles: Roles = {}): Command =>
  (document) =>
    has(document.points, point.id) ? document : withRoles({ ...document, points: [...document.points, point] }, roles);

export const addPoints =
  (points: readonly Point[], roles: Roles = {}): Command =>
  (document) =>
    points.reduce((next, point) => addPoint(point, roles)(next), document);

/** What a point says of itself alone; the rest has commands of its own. */
export type PointSettings = Partial<Omit<Point, "id" | "position" | "joint" | "mirror">>;

export const setPoint = (id: string, settings: PointSettings): Command => updatePoint(id, settings);

/** Lets a joint drive a point; null: it follows the whole pose. */
export const pairPoint =
  (id: string, joint: string | null, roles: Roles = {}): Command =>
  (document) =>
    withRoles(updatePoint(id, { joint })(document), roles);

/** Takes a point away, from the examples, the clips and its partner too. */
export const removePoint =
  (id: string): Command =>
  (document) => {
    if (!has(document.points, id)) return document;
    const examples = document.examples.map((example) => {
      const { points, turns } = example;
      if (![points, turns ?? {}].some((said) => Object.hasOwn(said, id))) return example;
      return { ...example, points: without(points, id), ...(turns && { turns: without(turns, id) }) };
    });
    const points = document.points
      .filter((point) => point.id !== id)
      .map((point) => {
        if (point.mirror !== id) return point;
        const { mirror: _, ...alone } = point;
        return alone;
      });
    const clips = forgetPoint(document.clips, id);
    return { ...document, points, examples, ...(clips && { clips }) };
  };

export const addExample =
  (example: Example, roles: Roles = {}): Command =>
  (document) =>
    has(document.examples, example.id) ? document : withRoles({ ...document, examples: [...document.examples, example] }, roles);

/** Another pose in the place of the one with its id. */
export const replaceExample =
  (example: Example, roles: Roles = {}): Command =>
  (document) =>
    withRoles(change(document, { examples: replace(document.examples, example.id, () => example) }), roles);

export const removeExample =
  (id: string): Command =>
  (document) =>
    has(document.examples, id) ? { ...document, examples: document.examples.filter((example) => example.id !== id) } : document;

/** "p4" for the prefix "p": an id that none of these has. */
export function freeId(taken: readonly { readonly id: string }[], prefix: string): string {
  let n = taken.length + 1;
  while (has(taken, prefix + n)) n++;
  return prefix + n;
}

function without<T>(record: Readonly<Record<string, T>>, id: string): Record<string, T> {
  return Object.fromEntries(Object.entries(record).filter(([key]) => key !== id));
}

function updatePoint(id: string, values: Partial<Point>): Command {
  return (document) => change(document, { points: replace(document.points, id, (point) => change(point, values)) });
}

/** Keeps what roles say of joints that the document names, and forgets those that it names no longer. */
function withRoles(document: ProjectDocument, roles: Roles): ProjectDocument {
  const named = namedJoints(document);
  const { joints: old = {}, ...rest } = document;
  const kept = Object.entries({ ...old, ...roles }).filter(([name]) => named.has(name));
  if (kept.length === Object.keys(old).length && kept.every(([name, role]) => Object.hasOwn(old, name) && old[name] === role))
    return document;
  return kept.length > 0 ? { ...document, joints: Object.fromEntries(kept) } : rest;
}

/** The joints of points and examples, by name. */
function namedJoints({ points, examples }: ProjectDocument): Set<string> {
  return new Set([...points.flatMap(({ joint }) => joint ?? []), ...examples.flatMap(({ joints }) => Object.keys(joints))]);
}

/** The same object if all these values are there already. */
function change<T extends object>(object: T, values: Partial<T>): T {
  const changed = (Object.keys(values) as (keyof T)[]).some((key) => object[key] !== values[key]);
  return changed ? { ...object, ...values } : object;
}

/** The same list if the item is not in it or does not change. */
function replace<T extends { readonly id: string }>(list: readonly T[], id: string, update: (item: T) => T): readonly T[] {
  const at = list.findIndex((item) => item.id === id);
  if (at < 0) return list;
  const item = update(list[at]);
  return item === list[at] ? list : list.with(at, item);
}

function has(list: readonly { readonly id: string }[], id: string): boolean {
  return list.some((item) => item.id === id);
}
