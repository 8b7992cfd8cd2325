// One drop of many files: what of it is opened, and as what.

import { baseName, extension, type NamedFile } from "./named-file";
import { modelFormat } from "./model-format";
import { findMotions, type FoundMotion, motionFormat } from "./read-motion-files";
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

const BESIDE_MODELS = ["mtl", "bin", "png", "jpg", "jpeg", "webp"];

/** Errors (DocumentError): a zip that cannot be opened. */
export function sortFiles(dropped: readonly NamedFile[]): SortedFiles {
  const files = dropped.flatMap((file) => (isZip(file) ? unzip(file) : [file])).filter((file) => !isLeftBehind(file.name));
  const projects = files.filter((file) => extension(file.name) === "json").sort((a, b) => depth(a) - depth(b));
  const isMotion = (file: NamedFile): boolean => motionFormat(file) !== null;
  const models = files.filter((file) => modelFormat(file) !== null && !isMotion(file));
  const { motions, problems } = findMotions(files);
  for (const file of files) {
    const kind = extension(file.name);
    if (models.includes(file) || isMotion(file) || kind === "json") continue;
    if (!BESIDE_MODELS.includes(kind)) {
      problems.push(
        `${baseName(file.name)} is nothing that Rigless opens. Models: OBJ, PLY, STL, GLB, glTF, OFF. Motions: BVH, ASF with AMC.`,
      );
    } else if (models.length === 0 && projects.length === 0) {
      problems.push(`${baseName(file.name)} belongs to a model: drop both together.`);
    }
  }
  for (const other of projects.slice(1)) problems.push(`${baseName(other.name)} was not opened: one project at a time.`);
  return { project: projects[0] ?? null, models, motions, files, problems };
}

function depth(file: NamedFile): number {
  return file.name.split("/").length;
}
