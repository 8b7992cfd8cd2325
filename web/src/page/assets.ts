import characters from "../../assets/characters/index.json";
import motions from "../../assets/motions/index.json";
import type { AssetsPort } from "../app/ports";

/** Where the build put each asset, by its path under `assets`. */
const ADDRESSES = new Map(
  Object.entries(
    import.meta.glob<string>(["../../assets/**/project.json", "../../assets/**/*.{glb,bvh,webp}"], {
      query: "?url",
      import: "default",
      eager: true,
    }),
  ).map(([path, url]) => [path.replace(/^.*?\/assets\//, ""), url]),
);

export const assets: AssetsPort = {
  characters: characters as unknown as AssetsPort["characters"],
  motions,
  paths: [...ADDRESSES.keys()],
  address: (path) => ADDRESSES.get(path) ?? null,
  load: async (path) => {
    const response = await fetch(ADDRESSES.get(path) ?? path);
    if (!response.ok) throw new Error(`${path.replace(/^.*\//, "")} could not be loaded (${response.status}).`);
    return new Uint8Array(await response.arrayBuffer());
  },
};
