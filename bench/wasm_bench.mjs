// The core in WebAssembly against the native builds: the same drags, in turns.
// node bench/wasm_bench.mjs FOLDER [--csv FILE] [--small]; FOLDER: where drag_bench and drag_bench_sse2 lie.
import { execFileSync } from "node:child_process";
import { appendFileSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";

const { values: options, positionals: [folder] } = parseArgs({
  allowPositionals: true,
  options: { csv: { type: "string" }, small: { type: "boolean", default: false } },
});
const size = options.small ? ["--small"] : [];
const rounds = options.small ? 1 : 5;
const scratch = mkdtempSync(join(tmpdir(), "rigless-"));

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** "figure" -> milliseconds of one run of a native program. */
function native(program) {
  const csv = join(scratch, "native.csv");
  rmSync(csv, { force: true });
  execFileSync(join(folder, program), [...size, "--csv", csv]);
  return new Map(readFileSync(csv, "utf8").trim().split("\n").map((line) => {
    const [, name, milliseconds] = line.split(",");
    return [name, Number(milliseconds)];
  }));
}

async function loadCore() {
  const bytes = readFileSync(new URL("../web/src/engine/rigless.wasm", import.meta.url));
  const { instance } = await WebAssembly.instantiate(bytes, {
    env: { emscripten_notify_memory_growth: () => {} },
    wasi_snapshot_preview1: { proc_exit: (code) => { throw new Error(`the core stopped with code ${code}`); } },
  });
  instance.exports._initialize();
  return instance.exports;
}

/** A body ready to be dragged, from a file of drag_bench --cases. */
function makeBody(core, file) {
  const bytes = readFileSync(file);
  const [vertices, faces, controls] = new Int32Array(bytes.buffer, bytes.byteOffset, 3);
  let from = 12;
  const lend = (length) => {
    const at = core.alloc(length);
    new Uint8Array(core.memory.buffer, at, length).set(bytes.subarray(from, (from += length)));
    return at;
  };
  const check = (status) => { if (status !== 0) throw new Error(`the core refused: ${status}`); };
  const body = core.body_new();
  check(core.body_set_mesh(body, lend(12 * vertices), vertices, lend(12 * faces), faces));
  const [at, radii, held] = [lend(4 * controls), lend(4 * controls), core.alloc(16 * controls)];
  const { buffer } = core.memory;
  const inputs = new Float64Array(buffer, held, 2 * controls);  // ControlInput of wasm/abi.h
  new Int32Array(buffer, at, controls).forEach((vertex, c) => inputs.set([vertex], 2 * c));
  new Float32Array(buffer, radii, controls).forEach((radius, c) => inputs.set([radius], 2 * c + 1));
  check(core.body_set_controls(body, held, controls));
  const targets = lend(12 * controls);
  return (restart) => check(core.body_drag(body, targets, controls, 1, Number(restart)));
}

function time(work, runs) {
  const times = Array.from({ length: runs }, () => {
    const begin = process.cpuUsage().user;  // as the native side: what others do meanwhile is not ours
    work();
    return (process.cpuUsage().user - begin) / 1000;
  });
  return median(times);
}

try {
  execFileSync(join(folder, "drag_bench"), [...size, "--cases", scratch]);
  const core = await loadCore();
  const drags = readdirSync(scratch).sort().map((name) => ({ name, move: makeBody(core, join(scratch, name)) }));
  const results = new Map();
  for (let round = 0; round < rounds; ++round) {
    const avx2 = native("drag_bench");
    const sse2 = native("drag_bench_sse2");
    for (const { name, move } of drags) {
      for (const [what, restart, runs] of [["drag from rest", true, 9], ["drag", false, 25]]) {
        time(() => move(restart), options.small ? 1 : 5);  // until the compiler has done its best
        const figure = `${name}: ${what}`;
        const wasm = time(() => move(restart), options.small ? 1 : runs);
        const row = { wasm, avx2: wasm / avx2.get(figure), sse2: wasm / sse2.get(figure) };
        results.set(figure, [...(results.get(figure) ?? []), row]);
      }
    }
  }
  const report = (name, value, unit) => {
    console.log(`wasm ${name.padEnd(72)} ${value.toPrecision(4).padStart(11)} ${unit}`);
    if (options.csv) appendFileSync(options.csv, `wasm,${name},${value.toPrecision(5)},,${unit},\n`);
  };
  for (const [figure, rows] of results) {
    report(figure, median(rows.map((row) => row.wasm)), "ms");
    report(`${figure} / native with AVX2`, median(rows.map((row) => row.avx2)), "x");
    report(`${figure} / native with SSE2`, median(rows.map((row) => row.sse2)), "x");
  }
} finally {
  rmSync(scratch, { recursive: true });
}
