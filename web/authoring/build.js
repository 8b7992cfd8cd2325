// Writes everything in web/assets. Run: node web/authoring/build.js
import { mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { makeCactus } from "./cactus/cactus.js";
import { reportMotion } from "./kit/motion-report.js";
import { writeBvh } from "./kit/skeleton.js";
import * as hop from "./motions/hop.js";
import * as walk from "./motions/walk.js";
import { makeProject } from "./project.js";

const assets = fileURLToPath(new URL("../assets/", import.meta.url));
const write = (path, data) => {
  mkdirSync(new URL(".", new URL(path, new URL("../assets/", import.meta.url))), { recursive: true });
  writeFileSync(assets + path, data);
  console.log(`${path}: ${(Buffer.byteLength(data) / 1000).toFixed(1)} kB`);
};

// A vector on one line.
const toJson = (value) => JSON.stringify(value, null, 1).replace(/\[\s+([-\d.e,\s]+?)\s+\]/g, (_, list) => `[${list.replace(/\s+/g, " ")}]`) + "\n";

const cactus = makeCactus();
const poses = { hop: hop.makeHop(), walk: walk.makeWalk() };
write("cactus/cactus.glb", cactus.glb);
write("cactus/project.json", toJson(makeProject(cactus.vertices, poses)));
write("motions/hop.bvh", writeBvh(poses.hop, hop.FPS));
write("motions/walk.bvh", writeBvh(poses.walk, walk.FPS));

console.log("cactus", cactus.report);
console.dir({ hop: reportMotion(poses.hop, hop.FPS, { travels: null }) }, { depth: 4 });
console.dir({ walk: reportMotion(poses.walk, walk.FPS, { travels: walk.TRAVELS }) }, { depth: 4 });
