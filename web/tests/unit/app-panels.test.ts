import { expect, test } from "vitest";
import { PANELS } from "../../src/app/panels";

test("every panel has a name of its own", () => {
  expect(PANELS.length).toBeGreaterThan(3);
  expect(new Set(PANELS.map(({ id }) => id)).size).toBe(PANELS.length);
  for (const { id, name } of PANELS) expect(name.toLowerCase()).toBe(id);
});
