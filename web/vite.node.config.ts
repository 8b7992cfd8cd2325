// The command line as one file with nothing to install: dist-node/rigless.js beside the core.

import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  ssr: { noExternal: true },
  build: {
    ssr: "bin/cli.ts",
    outDir: "dist-node",
    target: "node20",
    rollupOptions: { output: { entryFileNames: "rigless.js" } },
  },
  plugins: [
    {
      name: "core",
      generateBundle() {
        this.emitFile({ type: "asset", fileName: "rigless.wasm", source: readFileSync(new URL("src/engine/rigless.wasm", import.meta.url)) });
      },
    },
  ],
});
