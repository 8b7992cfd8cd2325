// Loads the bare modules. They need no script of their own: two imports, one initialiser.

import { ABI } from "./abi";
import type { RiglessExports, ShapeAnalysisExports, SkinExports } from "./abi";

const IMPORTS = {
  env: { emscripten_notify_memory_growth: () => {} },
  wasi_snapshot_preview1: {
    proc_exit: (code: number) => {
      throw new WebAssembly.RuntimeError(`the core stopped with code ${code}`);
    },
  },
};

/** At once, as only a worker may; for a small module that is used and dropped. */
export function instantiateShapeAnalysis(bytes: ArrayBuffer): ShapeAnalysisExports {
  return begin<ShapeAnalysisExports>(new WebAssembly.Instance(new WebAssembly.Module(bytes), IMPORTS), "shape-analysis.wasm");
}

/** As that one. */
export function instantiateSkin(bytes: ArrayBuffer): SkinExports {
  return begin<SkinExports>(new WebAssembly.Instance(new WebAssembly.Module(bytes), IMPORTS), "skin.wasm");
}

export async function instantiate(bytes: ArrayBuffer): Promise<RiglessExports> {
  return begin<RiglessExports>((await WebAssembly.instantiate(bytes, IMPORTS)).instance, "rigless.wasm");
}

/** The only cast: that a module has these exports is what its number says. */
function begin<T extends RiglessExports | ShapeAnalysisExports | SkinExports>({ exports }: WebAssembly.Instance, file: string): T {
  const module = exports as unknown as T;
  if (module.abi?.() !== ABI) throw new Error(`${file} was not built together with this program; load it anew, or build both again`);
  module._initialize();
  return module;
}
