// A project of one of our characters in an address: what differs from it, deflated. docs/project-format.md explains it.

import { deflateSync, inflateSync } from "fflate";
import { applied, difference } from "../document/difference";
import { DocumentError, parseProject } from "../document/project";
import type { Example, ProjectDocument, Vec3 } from "../document/types";

/** Characters of an address that chats and mails leave whole. */
export const MOST_CHARACTERS = 4096;

const VERSION = 1;
const NAME = "dance";

/** The joints of a pose, told by its motion and frame alone; null where they cannot be. The document has no examples. */
export type JointsOf = (document: ProjectDocument, source: Example["source"]) => Promise<Readonly<Record<string, Vec3>> | null>;

/** What stands behind the address's "#": `base` is the character's own project, and `of` its id. */
export async function writeLink(of: string, base: ProjectDocument, document: ProjectDocument, jointsOf: JointsOf): Promise<string> {
  const known = new Map(base.examples.map((example) => [example.id, example]));
  const examples = await Promise.all(
    document.examples.map(async (example) => {
      const { joints, ...named } = example;
      const before = known.get(example.id);
      if (before && difference(before.joints, joints) === undefined) return example;
      const found = await jointsOf({ ...document, examples: [] }, example.source);
      return found && difference(found, joints) === undefined ? { ...named, joints: null } : example;
    }),
  );
  const json = JSON.stringify([VERSION, of, difference(base, { ...document, examples }) ?? null]);
  const packed = deflateSync(new TextEncoder().encode(json), { level: 9 });
  const text = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(""));
  return `${NAME}=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

/** Whether what stands behind an address's "#" is a link of ours. */
export const isLink = (text: string): boolean => text.startsWith(`${NAME}=`);

/**
 * The project again, given the character's own. Errors (DocumentError): it is not whole, from a newer Rigless, or no project.
 */
export async function readLink(
  text: string,
  baseOf: (of: string) => Promise<ProjectDocument | null>,
  jointsOf: JointsOf,
): Promise<{ of: string; document: ProjectDocument }> {
  const [version, of, change] = unpacked(text);
  if (version !== VERSION) throw new DocumentError("It was made by a newer Rigless.");
  const base = typeof of === "string" ? await baseOf(of) : null;
  if (typeof of !== "string" || !base) throw new DocumentError("It is of a character that is not here.");
  const raw = whole(() => applied(base, change ?? undefined)) as ProjectDocument;
  const examples = Array.isArray(raw.examples) ? raw.examples : [];
  const told = examples.map((example: Example) => (example?.joints === null ? { ...example, joints: {} } : example));
  const { document } = parseProject(JSON.stringify({ ...raw, examples: told }), "The link");
  const filled = await Promise.all(
    document.examples.map(async (example, n) => {
      if (examples[n]?.joints !== null) return example;
      const joints = await jointsOf({ ...document, examples: [] }, example.source);
      if (!joints) throw new DocumentError(`Its pose at frame ${example.source.frame} of ${example.source.motion} is not there.`);
      return { ...example, joints };
    }),
  );
  return { of, document: { ...document, examples: filled } };
}

function unpacked(text: string): readonly unknown[] {
  return whole(() => {
    const packed = text
      .slice(NAME.length + 1, MOST_CHARACTERS)
      .replaceAll("-", "+")
      .replaceAll("_", "/");
    const bytes = inflateSync(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)));
    const json: unknown = JSON.parse(new TextDecoder().decode(bytes));
    if (!Array.isArray(json)) throw new RangeError();
    return json;
  });
}

function whole<T>(read: () => T): T {
  try {
    return read();
  } catch {
    throw new DocumentError("A part of it is missing: links are long, and some places cut them off.");
  }
}
