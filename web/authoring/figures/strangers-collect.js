// Fills a folder with the models of the list, from clones of the repositories that they come from.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, writeFileSync } from "node:fs";
import { dirname, join, posix } from "node:path";

/** rows: of docs/figures/strangers.json; clones: a folder with one git directory per repository, <owner>+<name>. */
export function collect(rows, clones, folder) {
  mkdirSync(folder, { recursive: true });
  for (const { file, repository, commit, path } of rows.filter((row) => row.repository)) {
    const clone = [".git", "repo/.git", "repo", ""].map((inner) => join(clones, repository.replace("/", "+"), inner)).find(existsSync);
    if (!clone) {
      console.log(`${file}: ${repository} is not among the clones`);
      continue;
    }
    const read = (inner) => execFileSync("git", ["-C", clone, "show", `${commit}:${inner}`], { maxBuffer: 1 << 28 });
    const bytes = read(path);
    writeFileSync(join(folder, file), bytes);
    if (!file.endsWith(".gltf")) continue;
    const { buffers = [], images = [] } = JSON.parse(bytes.toString());
    for (const { uri } of [...buffers, ...images]) {
      if (!uri || uri.startsWith("data:")) continue;
      mkdirSync(dirname(join(folder, uri)), { recursive: true });
      writeFileSync(join(folder, uri), read(posix.join(posix.dirname(path), decodeURIComponent(uri))));
    }
  }
}
