import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { END_WORDS, LEFT_WORDS, NOISE_WORDS, RIGHT_WORDS, SENSE_WORDS } from "../../src/skeleton/name-senses";

const HEADER = readFileSync(new URL("../../../include/rigless/motion/detail/name_senses.h", import.meta.url), "utf8");

const STRINGS = String.raw`((?:"[^"]*"\s*)+)`;
const words = (strings: string): string[] =>
  [...strings.matchAll(/"([^"]*)"/g)]
    .map(([, text]) => text)
    .join("")
    .trim()
    .split(/\s+/);
const list = (name: string): string[] => words(new RegExp(`${name} =\\s*${STRINGS};`).exec(HEADER)?.[1] ?? "");

it("the core's reader of joint names has the same words", () => {
  const table = [...HEADER.matchAll(new RegExp(String.raw`\{NameSense::(\w+),\s*${STRINGS}\}`, "g"))].map(([, sense, strings]) => [
    sense,
    words(strings),
  ]);
  expect(table.length).toBeGreaterThan(20);
  expect(SENSE_WORDS.map(([sense, all]) => [sense, [...all]])).toEqual(table);
  expect([NOISE_WORDS, END_WORDS, LEFT_WORDS, RIGHT_WORDS].map((all) => [...all])).toEqual(
    ["noise_words", "end_words", "left_words", "right_words"].map(list),
  );
});
