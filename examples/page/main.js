import { createRigless } from "rigless";
import { mesh } from "./mesh.js";

const motion = await (await fetch(new URL("./dance.bvh", import.meta.url))).text();
const rigless = await createRigless();
const dance = await rigless.retarget({ mesh, motion });

const context = document.querySelector("canvas").getContext("2d");
requestAnimationFrame(function draw(milliseconds) {
  const points = dance.frame(Math.floor((milliseconds / 1000) * dance.fps) % dance.frames);
  context.clearRect(0, 0, 400, 400);
  for (let v = 0; v < points.length; v += 3) context.fillRect(200 + points[v], 300 - points[v + 1], 3, 3);
  requestAnimationFrame(draw);
});
