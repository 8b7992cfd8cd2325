import { parseProject } from "../../document/project";
import type { ProjectDocument } from "../../document/types";
import cactus from "../../../assets/cactus/cactus.glb?url";
import cactusProject from "../../../assets/cactus/project.json?url";
import hop from "../../../assets/motions/hop.bvh?url";
import walk from "../../../assets/motions/walk.bvh?url";
import { baseName } from "../../io/named-file";

const MOTIONS: Readonly<Record<string, string>> = { "hop.bvh": hop, "walk.bvh": walk };

async function fetched(url: string): Promise<Response> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${baseName(url)} could not be loaded (${response.status}).`);
  return response;
}

/** What comes with the page. Files are named without folders. */
export class Builtins {
  readonly model = { name: "Cactus", file: "cactus.glb" };
  readonly motions: readonly string[] = Object.keys(MOTIONS);

  async project(): Promise<ProjectDocument> {
    const text = await (await fetched(cactusProject)).text();
    const { document } = parseProject(text, "project.json");
    return {
      ...document,
      mesh: { ...document.mesh, file: this.model.file },
      motion: { files: document.motion.files.map(baseName) },
    };
  }

  async modelBytes(): Promise<Uint8Array> {
    return new Uint8Array(await (await fetched(cactus)).arrayBuffer());
  }

  async motionText(file: string): Promise<string> {
    return (await fetched(MOTIONS[file] ?? file)).text();
  }
}
