// One drop of many files: what of it is opened, and as what.

import type { FormatKind } from "./format";
import { formatOf } from "./formats";
import { baseName, type NamedFile } from "./named-file";
import { findMotions, type FoundMotion } from "./read-motion-files";
import { refusal } from "./refused";
import { isLeftBehind, isZip, unzip } from "./zip";

export interface SortedFiles {
  /** A project's JSON; its model and motion are among `files`. */
  project: NamedFile | null;
  /** One per model. readModel takes it together with `files`, where its materials and pictures are. */
  models: NamedFile[];
  motions: FoundMotion[];
  /** Everything, zips unpacked. */
  files: NamedFile[];
  /** What was not used and why, in plain words. */
  problems: string[];
}

/** Errors (DocumentError): a zip that cannot be opened. */
export async function sortFiles(dropped: readonly NamedFile[]): Promise<SortedFiles> {
  const files = dropped.flatMap((file) => (isZip(file) ? unzip(file) : [file])).filter((file) => !isLeftBehind(file.name));
  const kinds = files.map((file) => formatOf(file)?.kind);
  const of = (kind: FormatKind): NamedFile[] => files.filter((_, k) => kinds[k] === kind);
  const projects = of("project").sort((a, b) => depth(a) - depth(b));
  const models = of("model");
  const { motions, problems } = await findMotions(files);
  files.forEach((file, k) => {
    const kind = kinds[k];
    if (kind === undefined || kind === "archive") {
      problems.push(refusal(file.name));
    } else if ((kind === "picture" || kind === "part") && models.length === 0 && projects.length === 0) {
      problems.push(`${baseName(file.name)} belongs to a model: drop both together.`);
    }
  });
  for (const other of projects.slice(1)) problems.push(`${baseName(other.name)} was not opened: one project at a time.`);
  return { project: projects[0] ?? null, models, motions, files, problems };
}

function depth(file: NamedFile): number {
  return file.name.split("/").length;
}
