// A project file's text to a document and back. docs/project-format.md explains each field.

import { pinFault, pointsOfPin } from "./clips";
import schema from "./project-schema.json";
import { findFault, withDefaults } from "./schema";
import type { ClipEdits, Companion, Dancer, Offset, ProjectDocument } from "./types";

/** The newest that is read and written. Who dances alone is written as version 1, which older readers know too. */
export const VERSION = 2;

/** What a file of version 2 holds. */
interface Duet {
  readonly name: string;
  /** The one in hand, and perhaps a companion. */
  readonly performers: readonly Companion[];
}

/** A project that cannot be opened. `message` names the file and the field and is made to be shown. */
export class DocumentError extends Error {
  constructor(message: string) {
    super(message);
    this.name = "DocumentError";
  }
}

/**
 * Reads a project, with the defaults where it says nothing.
 * Errors (DocumentError): not JSON; saved by a newer version; a field that is missing, unknown or of another kind; two points or
 * examples with one id; an example that places a point that does not exist.
 */
export function parseProject(text: string, fileName: string): { document: ProjectDocument } {
  const value = parseJson(text, fileName);
  const version = typeof value === "object" && value !== null && "version" in value ? value.version : undefined;
  if (typeof version === "number" && version > VERSION) {
    throw new DocumentError(
      `${fileName}: This project was saved by a newer Rigless (version ${version}). ` +
        `This one reads version ${VERSION}; reload the page or update to open it.`,
    );
  }
  const { solo, duet } = schema.$defs;
  const fault = findFault(value, version === VERSION ? duet : solo, schema);
  if (fault) throw new DocumentError(`${fileName}: ${fault}`);
  const document =
    version === VERSION ? fromDuet(withDefaults(value, duet, schema) as Duet) : (withDefaults(value, solo, schema) as ProjectDocument);
  const broken = typeof document === "string" ? document : brokenReference(document);
  if (typeof document === "string" || broken) throw new DocumentError(`${fileName}: ${broken}`);
  return { document };
}

/** Or what is wrong with it. */
function fromDuet({ name, performers }: Duet): ProjectDocument | string {
  const { performer, offset } = schema.$defs;
  const [hand, beside] = performers.map((one) => withDefaults(one, performer, schema) as Companion);
  const { motion, offset: own, ...dancer } = hand;
  if (!motion) return "performers[0].motion is missing.";
  if (own) return "performers[0].offset is not a field that Rigless knows: the other one's is told from where this one is.";
  for (const [n, one] of [hand, beside].entries()) {
    const broken = one && brokenReference(one);
    if (broken) return `performers[${n}].${broken}`;
  }
  const document: ProjectDocument = { version: 1, name, ...dancer, motion };
  if (!beside) return document;
  return { ...document, companion: { ...beside, offset: beside.offset ?? (withDefaults({}, offset, schema) as Offset) } };
}

/** The text of a project file: two spaces deep, each list of numbers on one line. */
export function serializeProject(document: ProjectDocument): string {
  const { companion, version: _, name, ...dancer } = document;
  const text = JSON.stringify(companion ? { version: VERSION, name, performers: [dancer, companion] } : document, null, 2);
  // A string of JSON never holds a line break, so this meets lists only.
  return text.replace(/\[\n\s+([-+.\deE,\s]+?)\n\s+\]/g, (_, numbers: string) => `[${numbers.replace(/\s+/g, " ")}]`) + "\n";
}

function parseJson(text: string, fileName: string): unknown {
  if (text.trim() === "") throw new DocumentError(`${fileName} is empty.`);
  try {
    return JSON.parse(text.replace(/^\uFEFF/, ""));
  } catch (error) {
    throw new DocumentError(`${fileName} is not whole JSON: ${error instanceof Error ? error.message : String(error)}.`);
  }
}

/** What the schema cannot say. */
function brokenReference({ points, examples, stiff = [], clips = {} }: Omit<Dancer, "motion">): string | null {
  const ids = new Set<string>();
  for (const [n, { id }] of points.entries()) {
    if (ids.has(id)) return `points[${n}].id is "${id}", which another point has already.`;
    ids.add(id);
  }
  const exampleIds = new Set<string>();
  for (const [n, example] of examples.entries()) {
    if (exampleIds.has(example.id)) return `examples[${n}].id is "${example.id}", which another example has already.`;
    exampleIds.add(example.id);
    for (const said of ["points", "turns"] as const) {
      const stranger = Object.keys(example[said] ?? {}).find((id) => !ids.has(id));
      if (stranger !== undefined) return `examples[${n}].${said} places "${stranger}", but no point has this id.`;
    }
  }
  const twin = stiff.findIndex(({ id }, n) => stiff.findIndex((other) => other.id === id) < n);
  if (twin >= 0) return `stiff[${twin}].id is "${stiff[twin].id}", which another stiff part has already.`;
  for (const [name, clip] of Object.entries(clips)) {
    const broken = brokenClip(clip, ids);
    if (broken) return `clips[${JSON.stringify(name.slice(0, 60))}].${broken}`;
  }
  return null;
}

function brokenClip({ cut, pins = [], contacts = {}, flights = [] }: ClipEdits, points: ReadonlySet<string>): string | null {
  if (cut && cut[0] >= cut[1]) return `cut goes from ${cut[0]} to ${cut[1]}: its first frame should come before its last.`;
  const ids = new Set<string>();
  for (const [n, pin] of pins.entries()) {
    if (ids.has(pin.id)) return `pins[${n}].id is "${pin.id}", which another pin has already.`;
    ids.add(pin.id);
    const stranger = pointsOfPin(pin).find((id) => !points.has(id));
    if (stranger !== undefined) return `pins[${n}] holds "${stranger}", but no point has this id.`;
    const fault = pinFault(pin);
    if (fault) return `pins[${n}].${fault}`;
  }
  const stranger = Object.keys(contacts).find((id) => !points.has(id));
  if (stranger !== undefined) return `contacts names "${stranger}", but no point has this id.`;
  const runs = [
    ...Object.entries(contacts).flatMap(([id, list]) => list.map((run) => [`contacts.${id}`, run] as const)),
    ...flights.map((run) => ["flights", run] as const),
  ];
  const empty = runs.find(([, [a, b]]) => a >= b);
  return empty ? `${empty[0]} has a run from ${empty[1][0]} to ${empty[1][1]}, but it should end after it begins.` : null;
}
