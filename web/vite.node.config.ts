// What the npm package holds, with nothing to install: the command line, and the library for Node and for pages, beside the core.

import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  assetsInclude: ["**/draco3dgltf/*.wasm"],
  ssr: { noExternal: true },
  // Draco's decoder, a script of Node's old kind, asks where it lies although it is handed its binary.
  define: { __dirname: '""' },
  build: {
    ssr: true,
    outDir: "dist-node",
    target: "es2022",
    rollupOptions: {
      input: {
        rigless: "cli/main.ts",
        node: "src/package/node.ts",
        browser: "src/package/browser.ts",
        worker: "src/engine/worker.ts",
        "parse-thread": "cli/parse-thread.ts",
      },
      // All in one folder: each finds the core beside itself.
      output: { entryFileNames: "[name].js", chunkFileNames: "[name]-[hash].js" },
    },
  },
  plugins: [
    {
      name: "core",
      renderChunk: (code) => code.replace('new URL("./worker.ts"', 'new URL("./worker.js"'),
      generateBundle() {
        for (const fileName of ["rigless.wasm", "shape-analysis.wasm", "skin.wasm"]) {
          this.emitFile({ type: "asset", fileName, source: readFileSync(new URL(`src/engine/${fileName}`, import.meta.url)) });
        }
      },
    },
  ],
});
