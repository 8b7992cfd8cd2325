import { expect, test } from "vitest";
import { errorText } from "../../src/app/error-words";

test("an error says its own words, but for those of a browser that cannot fetch a part of the page", () => {
  expect(errorText(new Error("cow.obj is empty."))).toBe("cow.obj is empty.");
  expect(errorText("gone")).toBe("gone");
  for (const words of [
    "Failed to fetch dynamically imported module: http://localhost:5173/assets/project-file-Bq2.js",
    "error loading dynamically imported module: http://localhost:5173/assets/project-file-Bq2.js",
    "Importing a module script failed.",
  ])
    expect(errorText(new TypeError(words))).toMatch(/^A part of the page could not be fetched\./);
});
