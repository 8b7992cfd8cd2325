import { expect, test } from "vitest";
import { Signals } from "../../src/app/signals";

test("who listens to a topic hears it, and no other, until they stop", () => {
  const signals = new Signals();
  const heard: unknown[] = [];
  const stop = signals.on("panel", () => heard.push("panel"));
  signals.on("freeze", ({ frame }) => heard.push(frame));
  signals.tell("panel");
  signals.tell("layout");
  signals.emit("freeze", { frame: 4, playOn: true });
  stop();
  signals.tell("panel");
  expect(heard).toEqual(["panel", 4]);
});
