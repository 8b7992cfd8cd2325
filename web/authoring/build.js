// Writes everything in web/assets, or only what is named. Run: node web/authoring/build.js [cactus dinosaur bird gnome hop walk]
import { mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { reportMotion } from "./kit/motion-report.js";
import { makeProject } from "./kit/project.js";
import { writeBvh } from "./kit/skeleton.js";
import { REPERTOIRE } from "./motions/repertoire.js";

/** Frames a second that are shown, and so all that a file holds; motions are made, and judged, with more. */
const SHOWN = 30;

const assets = fileURLToPath(new URL("../assets/", import.meta.url));
const write = (path, data) => {
  mkdirSync(new URL(".", new URL(path, new URL("../assets/", import.meta.url))), { recursive: true });
  writeFileSync(assets + path, data);
  console.log(`${path}: ${(Buffer.byteLength(data) / 1000).toFixed(1)} kB`);
};

// A vector on one line.
const toJson = (value) =>
  JSON.stringify(value, null, 1).replace(/\[\s+([-\d.e,\s]+?)\s+\]/g, (_, list) => `[${list.replace(/\s+/g, " ")}]`) + "\n";

const motions = Object.fromEntries(
  Object.entries(REPERTOIRE).map(([id, { make, ...motion }]) => [id, { ...motion, file: `${id}.bvh`, poses: make() }]),
);
// Folder in assets, and module.
const characters = {
  cactus: ["cactus", "cactus/cactus.js"],
  dinosaur: ["characters/dinosaur", "characters/dinosaur/dinosaur.js"],
  bird: ["characters/bird", "characters/bird/bird.js"],
  gnome: ["characters/gnome", "characters/gnome/gnome.js"],
  egg: ["characters/egg", "characters/egg/egg.js"],
  puppy: ["characters/puppy", "characters/puppy/puppy.js"],
  lamp: ["characters/lamp", "characters/lamp/lamp.js"],
};
const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.includes(name);

for (const [id, [folder, module]] of Object.entries(characters).filter(([name]) => isWanted(name))) {
  const { make, POINTS, POSES, SETTINGS } = await import(`./${module}`);
  const { glb, vertices, report } = await make();
  const name = id[0].toUpperCase() + id.slice(1);
  write(`${folder}/${id}.glb`, glb);
  const tables = { points: POINTS, poses: POSES, settings: SETTINGS };
  write(
    `${folder}/project.json`,
    toJson(
      makeProject({
        name,
        file: `${id}.glb`,
        vertices,
        ...tables,
        motions,
        opens: "hop",
        motionsFolder: folder.replace(/[^/]+/g, "..") + "/motions/",
      }),
    ),
  );
  console.log(id, report);
}
for (const [name, { file, fps, poses, travels }] of Object.entries(motions).filter(([id]) => isWanted(id))) {
  write(
    `motions/${file}`,
    writeBvh(
      poses.filter((_, frame) => frame % (fps / SHOWN) === 0),
      SHOWN,
    ),
  );
  console.dir({ [name]: reportMotion(poses, fps, { travels }) }, { depth: 4 });
}

const manifest = Object.values(motions).map(({ file, name, fps, poses, travels }) =>
  JSON.stringify({
    file,
    name,
    seconds: +(poses.length / fps).toFixed(1),
    loops: true,
    travels: +(Math.hypot(...(travels ?? [0])) / 100).toFixed(2),
  }),
);
write("motions/index.json", `[\n  ${manifest.join(",\n  ")}\n]\n`);
