import { expect, test } from "vitest";
import { isAbort } from "../../src/app/aborts";
import { EngineError } from "../../src/engine/types";

test("what was called off is no failure, all else is", () => {
  const abort = new AbortController();
  abort.abort();
  expect(isAbort(abort.signal.reason)).toBe(true);
  expect(isAbort(new EngineError("cancelled", "Cancelled."))).toBe(true);
  expect(isAbort(new EngineError("bad_mesh", "No."))).toBe(false);
  expect(isAbort(new Error("No."))).toBe(false);
  expect(isAbort("AbortError")).toBe(false);
});
