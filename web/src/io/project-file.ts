// A project as one file (`name.rigless`, a zip) or as project.json beside the files that it names.

import { DocumentError, parseProject, serializeProject } from "../document/project";
import type { Companion, MotionRef, ProjectDocument } from "../document/types";
import type { MotionInput } from "../engine/types";
import { listed, modelFormat } from "./formats";
import { baseName, decodeText, findFile, type NamedFile, normalPath } from "./named-file";
import { findMotions } from "./read-motion-files";
import { sortFiles } from "./sort-files";
import { zip } from "./zip";

export interface OpenedProject {
  document: ProjectDocument;
  /** The model's own file first, then everything else: what readModel takes. */
  modelFiles: NamedFile[];
  motion: MotionInput;
  /** The same of whoever dances beside; the motion only where it has one of its own. */
  beside: { readonly modelFiles: NamedFile[]; readonly motion: MotionInput | null } | null;
}

/** What the page calls the file. */
export function projectFileName(document: ProjectDocument): string {
  return `${document.name.replace(/[\s\\/:*?"<>|\x00-\x1f]+/g, " ").trim() || "project"}.rigless`;
}

/**
 * A zip of project.json and `files`: the model with its materials and pictures, and motions.
 * Names keep their folders but never lead upwards. Errors (DocumentError): a file that the project names is not among them.
 */
export function saveProject(document: ProjectDocument, files: readonly NamedFile[]): Uint8Array<ArrayBuffer> {
  const { companion } = document;
  for (const { mesh, motion } of companion ? [document, companion] : [document])
    for (const path of [mesh.file, ...(motion?.files ?? [])]) needed(files, path, "", "The project");
  const inside: ProjectDocument = { ...withNormalPaths(document), ...(companion && { companion: withNormalPaths(companion) }) };
  return zip([
    { name: "project.json", bytes: new TextEncoder().encode(serializeProject(inside)) },
    ...files.map(({ name, bytes }) => ({ name: normalPath(name), bytes })),
  ]);
}

const withNormalPaths = <T extends ProjectDocument | Companion>(dancer: T): T => ({
  ...dancer,
  mesh: { ...dancer.mesh, file: normalPath(dancer.mesh.file) },
  ...(dancer.motion && { motion: { files: dancer.motion.files.map(normalPath) } }),
});

/**
 * Opens a saved zip, or a project.json among the files that it names.
 * Errors (DocumentError): no project; parseProject's; a file that is not with it; one that is no model; files that are no motion.
 */
export async function openProject(dropped: readonly NamedFile[]): Promise<OpenedProject> {
  const { project, files } = await sortFiles(dropped);
  const what = dropped.map((file) => baseName(file.name)).join(", ");
  if (!project) throw new DocumentError(`${what || "Nothing"} holds no project.json.`);
  const name = baseName(project.name);
  const text = decodeText(project.bytes);
  if (text === null) throw new DocumentError(`${name} is not text, so it is no project.`);
  const { document } = parseProject(text, name);
  const modelOf = ({ mesh }: ProjectDocument | Companion): NamedFile => {
    const model = needed(files, mesh.file, project.name, name);
    if (modelFormat(model) === null) throw new DocumentError(`${name} names ${mesh.file}, which is no model (${listed("model")}).`);
    return model;
  };
  const { companion } = document;
  const model = modelOf(document);
  const other = companion && modelOf(companion);
  const filesOf = (own: NamedFile, not?: NamedFile): NamedFile[] => [own, ...files.filter((file) => file !== own && file !== not)];
  const dancedTo = (motion: MotionRef): Promise<MotionInput> =>
    motionOf(
      name,
      motion.files.map((path) => needed(files, path, project.name, name)),
    );
  return {
    document,
    modelFiles: filesOf(model, other),
    motion: await dancedTo(document.motion),
    beside: other ? { modelFiles: filesOf(other, model), motion: companion?.motion ? await dancedTo(companion.motion) : null } : null,
  };
}

async function motionOf(name: string, files: readonly NamedFile[]): Promise<MotionInput> {
  const { motions, problems } = await findMotions(files);
  if (motions.length === 1) return motions[0].input;
  const names = files.map((file) => baseName(file.name)).join(" and ");
  throw new DocumentError(
    problems.length ? `${name}: ${problems[0]}` : `${name}: ${names} should be one motion (${listed("motion", "or")}).`,
  );
}

function needed(files: readonly NamedFile[], path: string, from: string, name: string): NamedFile {
  const file = findFile(files, path, from);
  if (!file) throw new DocumentError(`${name} names ${path}, which is not with it.`);
  return file;
}
