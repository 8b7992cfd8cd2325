// The project as a file of its own: not part of the first load.

import { projectFileName, saveProject as zipped } from "../io/project-file";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { Ports } from "./ports";
import type { Sources } from "./sources";

export async function saveProject(context: Context, sources: Sources, files: Ports["files"]): Promise<void> {
  const { document, model, history, notices } = context;
  if (!model) return;
  try {
    const zip = zipped(document, sources.filesOf(model, document.motion.files));
    files.download(projectFileName(document), zip.slice(), "application/zip");
    history.markSaved();
  } catch (error) {
    notices.say({ bad: true, title: "The project could not be saved.", text: errorText(error) });
  }
}
