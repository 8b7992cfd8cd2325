// The command line as one file with nothing to install: dist-node/rigless.js beside the core.

import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  ssr: { noExternal: true },
  build: { ssr: "cli/cli.ts", outDir: "dist-node", target: "node20", rollupOptions: { output: { entryFileNames: "rigless.js" } } },
  plugins: [
    {
      name: "core",
      generateBundle() {
        for (const fileName of ["rigless.wasm", "shape-analysis.wasm"]) {
          this.emitFile({ type: "asset", fileName, source: readFileSync(new URL(`src/engine/${fileName}`, import.meta.url)) });
        }
      },
    },
  ],
});
