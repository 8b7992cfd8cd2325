import { defineConfig } from "vitest/config";

export default defineConfig({
  assetsInclude: ["**/draco3dgltf/*.wasm"],
  test: {
    include: ["tests/unit/**/*.test.ts"],
    environment: "node",
    testTimeout: 30_000,
    maxWorkers: 2,
    isolate: false, // no test changes what a module holds
    passWithNoTests: true,
    expect: { poll: { timeout: 20_000 } },
  },
});
