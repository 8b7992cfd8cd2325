import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  appType: "mpa", // a missing file answers 404, not the page
  publicDir: false,
  assetsInclude: ["**/*.glb", "**/*.bvh", "**/*.asf", "**/*.amc", "**/draco3dgltf/*.wasm"],
  build: {
    target: "es2022",
    outDir: "dist",
    assetsInlineLimit: 0, // data: addresses would need a weaker content-security-policy
    chunkSizeWarningLimit: 1000,
  },
  worker: { format: "es" },
  server: { port: 5173, strictPort: true },
  preview: { port: 5173, strictPort: true },
});
