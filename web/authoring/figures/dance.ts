// A project of ours with any motion, solved and baked by the page's own engine.

import { parseProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { createBrowserEngine } from "../../src/engine/browser";
import type { Model } from "../../src/io/model";
import { readModel } from "../../src/io/read-model";
import { Workspace } from "../../src/sync/workspace";

export interface Dance {
  model: Model;
  document: ProjectDocument;
  workspace: Workspace;
}

/** folder: the address that the project lies in; motion: a BVH's. Close the workspace in the end. */
export async function solvedDance(folder: string, project: string, motion: string): Promise<Dance> {
  const { document: parsed } = parseProject(await (await fetch(folder + project)).text(), project);
  const bytes = new Uint8Array(await (await fetch(folder + parsed.mesh.file)).arrayBuffer());
  const model = await readModel([{ name: parsed.mesh.file, bytes }]);
  let present: ProjectDocument = parsed;
  const workspace = new Workspace(() => present, createBrowserEngine);
  const file = workspace.library.addModel(parsed.mesh.file, model);
  const name = motion.slice(motion.lastIndexOf("/") + 1);
  const files = workspace.library.addMotion([name], { name, text: await (await fetch(motion)).text() });
  present = { ...parsed, mesh: { ...parsed.mesh, file }, motion: { files } };
  await workspace.sync();
  return { model, document: present, workspace };
}
