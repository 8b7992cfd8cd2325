// The project as a file of its own: not part of the first load.

import type { ProjectDocument } from "../document/types";
import type { NamedFile } from "../io/named-file";
import { projectFileName, saveProject as zipped } from "../io/project-file";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { Motions } from "./motions";
import type { Ports } from "./ports";
import type { Sources } from "./sources";

interface Helpers {
  readonly sources: Sources;
  readonly motions: Motions;
}

/** With every motion that was brought in, the one that plays first. */
export async function saveProject(context: Context, { sources, motions }: Helpers, files: Ports["files"]): Promise<void> {
  const { document, model, history, notices } = context;
  if (!model) return;
  try {
    const others = motions.list.filter(({ builtin }) => !builtin).map((entry) => entry.files);
    const { companion } = document;
    const played = [document.motion.files, ...(companion?.motion ? [companion.motion.files] : []), ...others];
    const zip = zipped(...withCompanion(document, sources.filesOf(model, played), context, sources));
    files.download(projectFileName(document), zip.slice(), "application/zip");
    history.markSaved();
  } catch (error) {
    notices.say({ bad: true, title: "The project could not be saved.", text: errorText(error) });
  }
}

/** Adds whoever dances beside; files of theirs whose names are taken by others lie in a folder. */
function withCompanion(
  document: ProjectDocument,
  files: readonly NamedFile[],
  { workspace }: Context,
  sources: Sources,
): [ProjectDocument, readonly NamedFile[]] {
  const { companion } = document;
  const model = companion && workspace.library.model(companion.mesh.file);
  if (!companion || !model) return [document, files];
  const known = new Map(files.map((file) => [file.name, file.bytes]));
  const theirs = sources.filesOf(model, []);
  const free = (folder: string): boolean =>
    theirs.every(({ name, bytes }) => !known.has(folder + name) || known.get(folder + name) === bytes);
  let folder = "";
  for (let n = 1; !free(folder); n++) folder = n > 1 ? `companion ${n}/` : "companion/";
  const placed = theirs.map(({ name, bytes }) => ({ name: folder + name, bytes }));
  const mesh = { ...companion.mesh, file: folder + companion.mesh.file };
  return [{ ...document, companion: { ...companion, mesh } }, [...files, ...placed.filter(({ name }) => !known.has(name))]];
}
