import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const absent = fileURLToPath(new URL("src/viewport/absent.ts", import.meta.url));
const ABSENT = [...readFileSync(absent, "utf8").matchAll(/(?:Absent|Idle) as (\w+)|export const (\w+)/g)].map(
  ([, name, other]) => name ?? other,
);

const shorterStyles = (styles: string): string =>
  styles
    .replace(/\/\*[^]*?\*\//g, "")
    .replace(/\s+/g, " ")
    .replace(/ ?([{};,]) ?/g, "$1")
    .replace(/: /g, ":")
    .replace(/;}/g, "}");

const KEEPER = "service-worker";
/** Large, and rarely needed: film, and decoders of packed models and pictures. */
const NOT_AHEAD = /^assets\/(reels|gif-reel|unpack-draco|ktx2|ktx2-worker|basis_transcoder)-[^.]*\.\w+$/;

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
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: "index", test: /\/src\/main\.ts$/ }] } }, // what is loaded first is one file
    },
    modulePreload: { polyfill: false }, // browsers without it fetch a little later
  },
  worker: {
    format: "es",
    // A service worker keeps its name: by that a browser knows the next version.
    rolldownOptions: { output: { entryFileNames: ({ name }) => (name === KEEPER ? `${KEEPER}.js` : "assets/[name]-[hash].js") } },
  },
  server: { port: 5173, strictPort: true },
  preview: { port: 5173, strictPort: true },
  plugins: [
    {
      name: "dense", // projects and motions are laid out for people who read them: nobody does on their way into the page
      apply: "build",
      generateBundle(_, bundle) {
        for (const asset of Object.values(bundle)) {
          if (asset.type !== "asset") continue;
          if (asset.fileName.endsWith(".json")) asset.source = JSON.stringify(JSON.parse(String(asset.source)));
          if (asset.fileName.endsWith(".bvh"))
            asset.source = String(asset.source)
              .replace(/\n[ \t]+/g, "\n")
              .replace(/\b0\./g, ".");
        }
      },
    },
    {
      name: "absent",
      apply: "build",
      transform(code, id) {
        if (!id.endsWith("/loaders/GLTFLoader.js")) return null;
        const without = ABSENT.reduce((text, name) => text.replace(new RegExp(`^\\t${name},?$`, "m"), ""), code);
        return `import { ${ABSENT.join(", ")} } from ${JSON.stringify(absent)};\n${without}`;
      },
    },
    {
      name: "shorter", // what a minifier leaves alone, being text: our styles, the indentation of markup and shaders, and remarks in these
      apply: "build",
      transform: (code, id) => (/\/src\/.*\.ts$/.test(id) ? code.replace(/\bcss(?: = )?`[^`]+`/g, shorterStyles) : null),
      generateBundle(_, bundle) {
        for (const part of Object.values(bundle))
          if (part.type === "chunk") part.code = part.code.replace(/\n[ \t\n]+/g, "\n").replace(/\n\/\/[^`\n]*(?=\n)/g, "");
      },
    },
    {
      name: "kept", // tells the service worker which files there are
      apply: "build",
      enforce: "post",
      generateBundle: {
        order: "post",
        handler(_, bundle) {
          const { [`${KEEPER}.js`]: keeper, ...files } = bundle;
          if (keeper?.type !== "asset") return;
          const list = Object.entries(files).flatMap(([url, file]) => {
            if (NOT_AHEAD.test(url)) return [];
            const content = file.type === "asset" ? file.source : file.code;
            return [{ url, revision: url.startsWith("assets/") ? null : createHash("sha256").update(content).digest("hex") }];
          });
          keeper.source = String(keeper.source).replace("self.__WB_MANIFEST", JSON.stringify(list));
        },
      },
    },
  ],
});
