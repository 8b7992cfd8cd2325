// Every motion that comes with the page, in the order in which it shows them; the first one opens.
import { FPS } from "../kit/score.js";
import { makeBow } from "./bow.js";
import { makeDisco } from "./disco.js";
import { makeFolk } from "./folk.js";
import * as hop from "./hop.js";
import { makeIdle } from "./idle.js";
import { makeJump } from "./jump.js";
import { makeKick } from "./kick.js";
import * as run from "./run.js";
import * as sneak from "./sneak.js";
import { makeTurn } from "./turn.js";
import * as walk from "./walk.js";
import { makeWave } from "./wave.js";

const motion = (name, make, fps = FPS, travels = null) => ({ name, make, fps, travels });

/** name, make() giving one pose for each frame, frames per second, and how far the loop travels. */
export const REPERTOIRE = {
  hop: motion("Hop", hop.makeHop, hop.FPS),
  disco: motion("Disco", makeDisco),
  folk: motion("Folk dance", makeFolk),
  wave: motion("Wave", makeWave),
  walk: motion("Walk", walk.makeWalk, walk.FPS, walk.TRAVELS),
  run: motion("Run", run.makeRun, FPS, run.TRAVELS),
  jump: motion("Jump", makeJump),
  kick: motion("Kick", makeKick),
  turn: motion("Turn", makeTurn),
  sneak: motion("Sneak", sneak.makeSneak, FPS, sneak.TRAVELS),
  bow: motion("Bow", makeBow),
  idle: motion("Idle", makeIdle),
};
