// Draws how models dance that nobody has said anything about: points and joints are guessed, poses are the starters'.

import type { ProjectDocument } from "../../src/document/types";
import { newDocument } from "../../src/document/commands";
import { createBrowserEngine } from "../../src/engine/browser";
import { readModel } from "../../src/io/read-model";
import { findMotions } from "../../src/io/read-motion-files";
import { guessPoints } from "../../src/sync/guess";
import { Workspace } from "../../src/sync/workspace";
import { drawMoments, onTheSpot, theModel } from "./moments";

const PIXELS = 200;

declare global {
  interface Window {
    /** A strip of squares, evenly spread over the dance, as a data URL. */
    drawGuess: (input: { model: string; motion: string[]; frames: number }) => Promise<string>;
  }
}

window.drawGuess = async ({ model: modelUrl, motion: motionUrls, frames }) => {
  const [modelFile, ...motionFiles] = await Promise.all(
    [modelUrl, ...motionUrls].map(async (url) => ({
      name: url.slice(url.lastIndexOf("/") + 1),
      bytes: new Uint8Array(await (await fetch(url)).arrayBuffer()),
    })),
  );
  const model = await readModel([modelFile!]);
  const [motion] = (await findMotions(motionFiles)).motions;
  let present: ProjectDocument = newDocument("", { file: "", facing: "+z", up: "+y" }, { files: [] });
  const workspace = new Workspace(() => present, createBrowserEngine);
  const file = workspace.library.addModel(modelFile!.name, model);
  const files = workspace.library.addMotion(motion!.files, motion!.input);
  present = newDocument("", { file, facing: "+z", up: "+y" }, { files });
  await workspace.tryOn(present);
  await workspace.sync();
  const guess = guessPoints(model, await workspace.analyseShape(model), workspace.motion!.joints);
  present = { ...present, mesh: { file, ...guess.mesh }, points: guess.points };
  await workspace.sync();
  const figure = await theModel(model, present, workspace);
  const moments = Array.from({ length: frames }, (_, k) => onTheSpot(figure.places(Math.floor(((k + 0.5) * figure.frames) / frames))));
  const strip = drawMoments(figure.group, figure.show, moments, PIXELS).toDataURL("image/webp", 0.85);
  workspace.close();
  return strip;
};
