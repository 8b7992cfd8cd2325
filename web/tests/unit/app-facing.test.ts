import { expect, test } from "vitest";
import { nextFacing, withUp } from "../../src/app/facing";
import type { Axis } from "../../src/document/types";

test("four quarter turns about any up axis are none, and no two look the same way", () => {
  for (const up of ["+x", "-x", "+y", "-y", "+z", "-z"] as const) {
    const { facing } = withUp({ file: "", facing: "+z", up: "+y" }, up);
    expect(facing[1]).not.toBe(up[1]);
    const turns: Axis[] = [facing];
    for (let k = 0; k < 4; k++) turns.push(nextFacing(turns[k], up));
    expect(turns[4]).toBe(turns[0]);
    expect(new Set(turns).size).toBe(4);
    expect(turns.every((axis) => axis[1] !== up[1])).toBe(true);
  }
});
