// The project as a file of its own: not part of the first load.

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
    const zip = zipped(document, sources.filesOf(model, [document.motion.files, ...others]));
    files.download(projectFileName(document), zip.slice(), "application/zip");
    history.markSaved();
  } catch (error) {
    notices.say({ bad: true, title: "The project could not be saved.", text: errorText(error) });
  }
}
