import { expect, test } from "vitest";
import { Notices } from "../../src/app/notices";
import { newDocument } from "../../src/document/commands";

test("newest first; the same words again take the place of the older ones", () => {
  const notices = new Notices();
  let changes = 0;
  notices.on("change", () => changes++);
  for (const title of ["A", "B", "C", "D", "B"]) notices.say({ title });
  expect(notices.all.map(({ title }) => title)).toEqual(["B", "D", "C", "A"]);
  notices.dismissTitle("D");
  notices.dismiss(notices.all[0].id);
  expect(notices.all.map(({ title }) => title)).toEqual(["C", "A"]);
  expect(changes).toBe(7);
});

test("what speaks of a document goes with it, or loses what can be done about it", () => {
  const notices = new Notices();
  const of = newDocument("A", { file: "", facing: "+z", up: "+y" }, { files: [] });
  const undo = { label: "Undo", run: () => {}, of };
  notices.say({ title: "Made.", actions: [undo, { label: "Show", run: () => {} }] });
  notices.outdate(of);
  expect(notices.all[0].actions).toHaveLength(2);
  notices.outdate({ ...of });
  expect(notices.all[0].actions.map(({ label }) => label)).toEqual(["Show"]);
  notices.say({ title: "Made again.", bad: true, actions: [undo] });
  expect(notices.all[0].icon).toBe("warning");
  notices.retract(of);
  expect(notices.all.map(({ title }) => title)).toEqual(["Made."]);
});
