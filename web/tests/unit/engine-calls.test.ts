// How calls end: cancelled, superseded, refused with a sentence, or lost with the engine.

import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { createNodeEngine } from "../../src/engine/node";
import { EngineError } from "../../src/engine/types";
import type { Engine, MotionInput, RetargetInput } from "../../src/engine/types";
import { nod, post, postControls, restControls, setUpPost } from "./engine-support";

let engine: Engine;
beforeEach(async () => {
  engine = await createNodeEngine();
});
afterEach(() => {
  engine.close();
  vi.restoreAllMocks();
});

const input: RetargetInput = { pairs: Int32Array.of(-1, 1), examples: [], smoothness: 0.3, volume: 1, groundContact: true, inPlace: false };

/** The error that a call ends with. */
async function refusal(call: Promise<unknown>): Promise<EngineError> {
  const error = await call.then(
    () => null,
    (reason: unknown) => reason,
  );
  expect(error).toBeInstanceOf(EngineError);
  return error as EngineError;
}

describe("cancelling", () => {
  test("ends a retarget between two slices; the last performance stays", async () => {
    await setUpPost(engine);
    await engine.retarget(input);
    let before: Float32Array | undefined;
    await engine.frames([7], (_, frame) => (before = frame.positions));

    await engine.setMotion(nod(20_000));
    const abort = new AbortController();
    const progress: number[] = [];
    const call = engine.retarget(input, {
      signal: abort.signal,
      onProgress: (done) => {
        progress.push(done);
        abort.abort();
      },
    });
    expect((await refusal(call)).code).toBe("cancelled");
    expect(progress.length).toBeGreaterThan(0);
    await engine.frames([7], (_, frame) => expect(frame.positions).toEqual(before));
  });

  test("ends frames; no frame comes after", async () => {
    await setUpPost(engine, 2000);
    await engine.retarget(input);
    const abort = new AbortController();
    let frames = 0;
    const call = engine.frames(
      Array.from({ length: 2000 }, (_, f) => f),
      () => {
        if (++frames === 5) abort.abort();
      },
      { signal: abort.signal },
    );
    expect((await refusal(call)).code).toBe("cancelled");
    expect(frames).toBe(5);
    await engine.frames([0], () => ++frames);
    expect(frames).toBe(6);
  });

  test("reaches a call that has not begun, or was never made", async () => {
    await setUpPost(engine, 5000);
    const running = engine.retarget(input);
    const abort = new AbortController();
    const waiting = engine.setMotion(nod(), { signal: abort.signal });
    abort.abort();
    expect((await refusal(waiting)).code).toBe("cancelled");
    expect((await refusal(engine.setMotion(nod(), { signal: abort.signal }))).code).toBe("cancelled");
    expect((await running).frames).toBe(5000);
  });
});

describe("drags", () => {
  test("keep one slot: the newest wins and overtakes a retarget", async () => {
    const mesh = await setUpPost(engine, 5000);
    const targets = restControls(mesh, postControls(mesh));
    let retargeted = false;
    const running = engine.retarget(input).then(() => (retargeted = true));
    const drags = [0.1, 0.2, 0.3].map((x) => {
      const moved = targets.slice();
      moved[3] = x;
      return engine.drag(moved, { volume: 1 });
    });
    const [first, second] = await Promise.all(drags.slice(0, 2).map(refusal));
    expect([first?.code, second?.code]).toEqual(["superseded", "superseded"]);
    const newest = await drags[2];
    expect(newest?.shape[3 * 73]).toBeCloseTo(0.3, 6);
    expect(retargeted).toBe(false);
    await running;
  });

  test("wait for the mesh and the controls they were made for", async () => {
    const mesh = post();
    const controls = postControls(mesh);
    const bound = [engine.setMesh(mesh), engine.setControls(controls)];
    const frame = await engine.drag(restControls(mesh, controls), { volume: 1 });
    expect(frame.shape.length).toBe(mesh.positions.length);
    await Promise.all(bound);
  });
});

describe("what cannot be used is refused by name, and what was there stays", () => {
  const bvh = (text: string): MotionInput => ({ name: "dance.bvh", text });
  const good = nod(3).text;
  const lines = good.split("\n");
  const asf =
    ":units\n  length 0.45\n:root\n  order TX TY TZ RX RY RZ\n  position 0 0 0\n  orientation 0 0 0\n:bonedata\n" +
    "  begin\n    id 1\n    name head\n    direction 0 1 0\n    length 10\n    axis 0 0 0 XYZ\n    dof rx\n  end\n" +
    ":hierarchy\n  begin\n    root head\n  end\n";
  const acclaim = (skeleton: string, text: string): MotionInput => ({
    skeleton: { name: "man.asf", text: skeleton },
    name: "walk.amc",
    text,
  });

  const motions: [string, MotionInput, RegExp][] = [
    ["an empty file", bvh(" \n"), /^dance\.bvh is empty/],
    ["another format", bvh("solid cube\nfacet normal 0 0 1\n"), /^dance\.bvh is not a motion in a format that/],
    ["a cut file", bvh(lines.slice(0, 8).join("\n")), /^dance\.bvh stops in line 8: more of the motion should follow/],
    [
      "a word for a number",
      bvh(good.replace("OFFSET 0 0.8 0", "OFFSET 0 up 0")),
      /^dance\.bvh, line 8 \(OFFSET 0 up 0\): a number is missing/,
    ],
    ["a misspelt keyword", bvh(good.replace("JOINT", "JIONT")), /^dance\.bvh, line 6 \(JIONT Head\): this line is not/],
    ["no frame", bvh(lines.slice(0, 18).join("\n")), /^dance\.bvh has no whole frame/],
    ["a skeleton that is none", acclaim("hello", "1\nroot 0 0 0 0 0 0\n"), /^man\.asf is not a skeleton in a format that/],
    [
      "a bone that the skeleton has not",
      acclaim(asf, ":DEGREES\n1\nroot 0 0 0 0 0 0\ntail 4\n"),
      /^walk\.amc, line 4 \(tail 4\): this bone is not in the skeleton/,
    ],
    ["a bad value in a motion", acclaim(asf, ":DEGREES\n1\nroot 0 0 0 0 0 0\nhead x\n"), /^walk\.amc, line 4 \(head x\): a number/],
  ];
  test.each(motions)("%s", async (_, motion, message) => {
    await setUpPost(engine);
    const error = await refusal(engine.setMotion(motion));
    expect(error.code).toBe("bad_motion");
    expect(error.message).toMatch(message);
    expect((await engine.retarget(input)).frames).toBe(60);
  });

  test("meshes", async () => {
    const mesh = await setUpPost(engine);
    const none = await refusal(engine.setMesh({ positions: mesh.positions, faces: new Uint32Array() }));
    expect([none.code, none.message]).toEqual(["bad_mesh", expect.stringMatching(/no triangles/)]);
    const faces = mesh.faces.slice();
    faces[31] = 999;
    expect((await refusal(engine.setMesh({ positions: mesh.positions, faces }))).message).toMatch(/^Triangle 11 of the model/);
    const positions = mesh.positions.slice();
    positions[3 * 20 + 1] = NaN;
    expect((await refusal(engine.setMesh({ positions, faces: mesh.faces }))).message).toMatch(/^Point 21 of the model/);
    expect((await refusal(engine.setMesh({ positions: positions.slice(1), faces: mesh.faces }))).code).toBe("bad_mesh");
    const frame = await engine.drag(restControls(mesh, postControls(mesh)), { volume: 1 });
    expect(frame.shape.length).toBe(mesh.positions.length);
  });

  test("controls", async () => {
    const mesh = await setUpPost(engine);
    expect(await refusal(engine.setControls([]))).toMatchObject({ code: "bad_controls" });
    const outside = await refusal(
      engine.setControls([
        { vertex: 0, radius: 0 },
        { vertex: 5000, radius: 0 },
      ]),
    );
    expect([outside.code, outside.message]).toEqual(["bad_controls", expect.stringMatching(/^Control 2 /)]);
    const targets = restControls(mesh, postControls(mesh));
    expect((await refusal(engine.drag(targets.slice(3), { volume: 1 }))).code).toBe("bad_controls");
    expect(
      (
        await refusal(
          engine.drag(
            targets.map(() => NaN),
            { volume: 1 },
          ),
        )
      ).code,
    ).toBe("bad_controls");
    expect((await engine.drag(targets, { volume: 1 })).shape.every(Number.isFinite)).toBe(true);
  });

  test("examples and pairs", async () => {
    await setUpPost(engine);
    await engine.retarget(input);
    const joints = new Float32Array(9);
    const controls = Float32Array.of(0, 0, 0, 0, NaN, 0);
    const bad = await refusal(engine.retarget({ ...input, examples: [{ joints, controls }] }));
    expect([bad.code, bad.message]).toEqual(["bad_examples", expect.stringMatching(/^Pose 1 /)]);
    const short = { joints, controls: controls.slice(3) };
    expect((await refusal(engine.retarget({ ...input, examples: [short] }))).code).toBe("bad_examples");
    const unpaired = await refusal(engine.retarget({ ...input, pairs: Int32Array.of(-1, 77) }));
    expect([unpaired.code, unpaired.message]).toEqual(["bad_controls", expect.stringMatching(/^Control 2 /)]);
    expect((await refusal(engine.retarget({ ...input, pairs: Int32Array.of(0) }))).code).toBe("bad_controls");
    let frames = 0;
    await engine.frames([0, 59], () => ++frames);
    expect(frames).toBe(2);
    expect((await refusal(engine.frames([60], () => {}))).message).toMatch(/Frame 61/);
  });

  test("calls that come too early", async () => {
    expect((await refusal(engine.setControls([{ vertex: 0, radius: 0 }]))).code).toBe("bad_controls");
    expect((await refusal(engine.drag(new Float32Array(3), { volume: 1 }))).code).toBe("bad_mesh");
    const mesh = post();
    await engine.setMesh(mesh);
    expect((await refusal(engine.retarget(input))).code).toBe("bad_controls");
    await engine.setControls(postControls(mesh));
    expect((await refusal(engine.retarget(input))).code).toBe("bad_motion");
    expect((await refusal(engine.frames([0], () => {}))).code).toBe("bad_examples");
  });

  test("frames of controls that are gone", async () => {
    const mesh = await setUpPost(engine);
    await engine.retarget(input);
    await engine.setControls(postControls(mesh));
    expect((await refusal(engine.frames([0], () => {}))).code).toBe("bad_examples");
  });
});

describe("an engine that is gone", () => {
  test("rejects every pending and every later call after a trap", async () => {
    engine.close();
    const memories: WebAssembly.Memory[] = [];
    const instantiate = WebAssembly.instantiate.bind(WebAssembly) as (
      bytes: BufferSource,
      imports?: WebAssembly.Imports,
    ) => Promise<WebAssembly.WebAssemblyInstantiatedSource>;
    vi.spyOn(WebAssembly, "instantiate").mockImplementation((async (bytes: BufferSource, imports?: WebAssembly.Imports) => {
      const source = await instantiate(bytes, imports);
      memories.push(source.instance.exports["memory"] as WebAssembly.Memory);
      return source;
    }) as unknown as typeof WebAssembly.instantiate);
    engine = await createNodeEngine();
    const mesh = await setUpPost(engine);
    // Stray writes all over the heap: the next call reads addresses that do not exist.
    new Uint8Array(memories[0]?.buffer ?? new ArrayBuffer(0)).fill(0xf7);
    const pending = [engine.retarget(input), engine.drag(restControls(mesh, postControls(mesh)), { volume: 1 })];
    for (const call of pending) expect((await refusal(call)).code).toBe("engine_lost");
    expect((await refusal(engine.setMesh(mesh))).code).toBe("engine_lost");
  });

  test("rejects what is pending when it is closed", async () => {
    await setUpPost(engine, 5000);
    const call = engine.retarget(input);
    engine.close();
    expect((await refusal(call)).code).toBe("engine_lost");
    expect((await refusal(engine.setMotion(nod()))).code).toBe("engine_lost");
  });

  test("says so when its file is not what it should be", async () => {
    engine.close();
    engine = await createNodeEngine(new URL("../../package.json", import.meta.url));
    expect((await refusal(engine.setMotion(nod()))).code).toBe("engine_lost");
  });
});
