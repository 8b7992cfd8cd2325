// One drop of many files: what of it is opened, and as what.

import type { FormatKind } from "./format";
import { formatOf } from "./formats";
import { holdingsOf } from "./holdings";
import { baseName, type NamedFile } from "./named-file";
import { findMotions, type FoundMotion } from "./read-motion-files";
import { refusal } from "./refused";
import { isLeftBehind, isZip, unzip } from "./zip";

export interface SortedFiles {
  /** A project's JSON; its model and motion are among `files`. */
  project: NamedFile | null;
  /** One per model, the one to be opened first. readModel takes it together with `files`, where its materials and pictures are. */
  models: NamedFile[];
  /** The first model holds motions too. */
  moves: boolean;
  motions: FoundMotion[];
  /** Other files that hold motions for readClips. */
  clips: NamedFile[];
  songs: NamedFile[];
  /** Everything, zips unpacked. */
  files: NamedFile[];
  /** What was not used and why, in plain words. */
  problems: string[];
}

interface SortingOptions {
  /** At hand for motions that come without theirs. */
  readonly skeletons?: readonly NamedFile[];
  /** A model that moves is wanted for its motions only. */
  readonly motionsOnly?: boolean;
}

/** Errors (DocumentError): a zip that cannot be opened. */
export async function sortFiles(
  dropped: readonly NamedFile[],
  { skeletons, motionsOnly = false }: SortingOptions = {},
): Promise<SortedFiles> {
  const files = dropped.flatMap((file) => (isZip(file) ? unzip(file) : [file])).filter((file) => !isLeftBehind(file.name));
  const kinds = files.map((file) => formatOf(file)?.kind);
  const of = (kind: FormatKind): NamedFile[] => files.filter((_, k) => kinds[k] === kind);
  const projects = of("project").sort((a, b) => depth(a) - depth(b));
  const { models, moves, clips } = bodiesAndClips(of("model"), motionsOnly);
  const { motions, problems } = await findMotions(files, skeletons);
  files.forEach((file, k) => {
    const kind = kinds[k];
    if (kind === undefined || kind === "archive") {
      problems.push(refusal(file.name));
    } else if ((kind === "picture" || kind === "part") && models.length === 0 && projects.length === 0) {
      problems.push(`${baseName(file.name)} belongs to a model: drop both together.`);
    }
  });
  for (const other of projects.slice(1)) problems.push(`${baseName(other.name)} was not opened: one project at a time.`);
  return { project: projects[0] ?? null, models, moves, motions, clips, songs: of("song"), files, problems };
}

/** A file without a mesh is a motion. Of several models the first that is nothing else is the model, and the others' clips move it. */
function bodiesAndClips(files: readonly NamedFile[], motionsOnly: boolean): Pick<SortedFiles, "models" | "moves" | "clips"> {
  const held = new Map(files.map((file) => [file, holdingsOf(file)]));
  const moves = (file: NamedFile): boolean => held.get(file)?.clips === true;
  const bodies = files.filter((file) => !moves(file) || (held.get(file)?.mesh && !motionsOnly));
  const first = bodies.find((file) => !moves(file)) ?? bodies[0];
  return {
    models: bodies.filter((file) => file === first || !moves(file)),
    moves: first !== undefined && moves(first),
    clips: files.filter((file) => file !== first && moves(file)),
  };
}

function depth(file: NamedFile): number {
  return file.name.split("/").length;
}
