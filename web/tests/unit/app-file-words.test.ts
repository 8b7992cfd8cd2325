import { expect, test } from "vitest";
import { guessText, modelText, motionText } from "../../src/app/file-words";
import { readModel } from "../../src/io/read-model";
import { TETRAHEDRON, textFile } from "../support/files";
import { dancingContext } from "./app-support";

test("a model: how tall it is, how it lies, and what its report has", async () => {
  const model = await readModel([textFile("tetra.obj", TETRAHEDRON)]);
  const { title, text } = modelText(model, { file: "tetra.obj", facing: "+z", up: "+z" }, null);
  expect(title).toBe("tetra.obj is 1.00 m tall.");
  expect(text).toContain("It lies down in its file; we stood it up.");
  const { context } = await dancingContext();
  const report = { ...context.workspace.report!, shells: 3, volume: null, nonManifoldEdges: 1 };
  const worn = modelText(model, { file: "tetra.obj", facing: "+x", up: "+y" }, report).text;
  expect(worn).toContain("We turned it to look at you.");
  expect(worn).toContain("3 separate pieces");
  expect(worn).toContain("1 edge shared by 3 or more faces");
  expect(worn).toContain("It is open");
});

test("guesses: how many, and who follows the whole pose", async () => {
  const { context } = await dancingContext();
  const points = context.document.points.slice(0, 3);
  expect(guessText(points).title).toBe("Guessed 3 points and which joints they follow.");
  expect(guessText(points).text).not.toContain("whole pose");
  const loose = points.map((point) => ({ ...point, joint: null }));
  expect(guessText(loose).text).toContain("Top, Right arm and Left arm follow the whole pose.");
  expect(guessText(loose.slice(0, 1)).text).toContain("Top follows the whole pose.");
});

test("a motion: how long it is, and what was worked around, in few lines", async () => {
  const { context } = await dancingContext();
  const { motion } = context;
  expect(motionText("hop.bvh", motion, []).title).toBe("hop.bvh plays now.");
  expect(motionText("hop.bvh", motion, ["One.", "Two."]).text).toBe(["30 frames, 1.0 s.", ...motion!.notes, "One. Two."].join(" "));
  expect(motionText("hop.bvh", motion, ["One.", "Two.", "Three."]).text).toContain("One. And 2 more like it.");
});
