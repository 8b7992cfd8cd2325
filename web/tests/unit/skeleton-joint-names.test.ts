import { expect, test } from "vitest";
import { readJointNames } from "../../src/skeleton/joint-names";
import { golden } from "./engine-support";

interface Golden {
  skeletons: { vocabulary: string; joints: [name: string, side: string, part: string, label: string][] }[];
}

const { skeletons } = golden<Golden>("joint-names");

// The C++ reader obeys the same table.
test.each(skeletons.map(({ vocabulary, joints }) => [vocabulary, joints] as const))("%s is read as the table says", (_, joints) => {
  const read = readJointNames(joints.map(([name]) => name));
  expect(read.map(({ side, part, label }, j) => [joints[j][0], side ?? "none", part ?? "none", label])).toEqual(joints);
});

test("no two joints of a skeleton are called the same", () => {
  for (const names of [
    ["Hips", "hips", "HIPS", "Hips 2"],
    ["tail", "tail 2", "Tail"],
    ["", " ", "_"],
    ["LeftHand", "left_hand", "Left hand 2"],
  ]) {
    const labels = readJointNames(names).map(({ label }) => label);
    expect(new Set(labels).size).toBe(names.length);
  }
});
