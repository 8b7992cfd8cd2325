import { expect, test } from "vitest";
import { Library } from "../../src/sync/library";

const model = () => ({ positions: new Float32Array(9), faces: Uint32Array.of(0, 1, 2) });

test("two models of one name are two models", () => {
  const library = new Library();
  const [a, b] = [model(), model()];
  expect(library.addModel("cow.obj", a)).toBe("cow.obj");
  expect(library.addModel("cow.obj", a)).toBe("cow.obj");
  expect(library.addModel("cow.obj", b)).toBe("cow 2.obj");
  expect(library.model("cow.obj")).toBe(a);
  expect(library.model("cow 2.obj")).toBe(b);
});

test("the same motion opened twice is kept once; another text of that name gets a name of its own", () => {
  const library = new Library();
  const bvh = (text: string) => ({ name: "a.bvh", text }) as const;
  expect(library.addMotion(["a.bvh"], bvh("1"))).toEqual(["a.bvh"]);
  expect(library.addMotion(["a.bvh"], bvh("1"))).toEqual(["a.bvh"]);
  expect(library.addMotion(["a.bvh"], bvh("2"))).toEqual(["a 2.bvh"]);
  expect(library.motionFiles).toEqual([["a.bvh"], ["a 2.bvh"]]);
});
