// Films and pictures of the stage, drawn frame by frame on its own canvas at the film's size: the same scene, on the same card.

import { Color } from "three";
import { nextTask } from "../util/next-task";
import type { FilmCall, FilmKind, FilmShot, Moment, Shot, Studio } from "../stage/studio";
import type { CameraRig } from "./camera-rig";
import type { StageCompanion } from "./companion";
import type { Figures } from "./figures";
import { FilmCamera } from "./film-camera";
import type { Content } from "./framing";
import type { Reel } from "./reels";
import type { Scenery } from "./scenery";

/** What must stay in the frame is looked for in every so many-th frame. */
const EVERY = 4;
/** Frames from which a GIF's palette is made. */
const SAMPLES = 6;
/** A line of the grid is as wide as on a screen of so many pixels' width. */
const SCREEN = 540;
/** Behind everything. */
const NO_FOG = 1e3;

/** What a film takes over of the stage. */
interface Stage {
  readonly scenery: Scenery;
  readonly figures: Figures;
  readonly rig: CameraRig;
  readonly beside: StageCompanion | null;
  /** The picture that is due, or 0. */
  frame: number;
  /** Draws at the stage's own size. */
  resize(): void;
}

export class StageStudio implements Studio {
  constructor(private readonly stage: Stage) {}

  async kinds(shot: Pick<Shot, "width" | "height">): Promise<readonly FilmKind[]> {
    return (await import("./reels")).encodableKinds(shot);
  }

  async film(shot: FilmShot, momentAt: (frame: number) => Promise<Moment>, { signal, onProgress }: FilmCall) {
    const { frames, turns, fps } = shot;
    const canvas = this.stage.scenery.renderer.domElement;
    const end = this.begin(shot);
    canvas.style.visibility = "hidden";
    let reel: Reel | null = null;
    try {
      const contents: Content[] = [];
      for (let n = 0; n < frames; n += EVERY) {
        contents.push(this.arrange({ ...(await momentAt(n)), again: false }));
        signal.throwIfAborted();
      }
      const camera = this.camera(shot, contents, turns > 0);
      const show = async (n: number, again?: false): Promise<void> => {
        const moment = await momentAt(n);
        this.arrange({ ...moment, again: again ?? moment.again });
        camera.turn((2 * Math.PI * turns * n) / frames);
        this.draw(shot, camera, 1 / fps);
      };
      if (shot.kind === "gif") {
        const gif = new (await import("./gif-reel")).GifReel(shot.width, shot.height, fps);
        for (let k = 0; k < SAMPLES; k++) {
          await show(Math.floor((k * frames) / SAMPLES), false);
          gif.sample(canvas);
        }
        reel = gif;
        this.settle();
      } else reel = await (await import("./reels")).videoReel(shot, canvas);
      for (let n = 0; n < frames; n++) {
        await show(n);
        await reel.add(canvas);
        signal.throwIfAborted();
        onProgress(n + 1);
        await nextTask();
      }
      return await reel.finish();
    } catch (error) {
      await reel?.cancel();
      throw error;
    } finally {
      canvas.style.visibility = "";
      end();
    }
  }

  async picture(shot: Shot, moment: Moment): Promise<Uint8Array<ArrayBuffer>> {
    const end = this.begin(shot);
    let made: Promise<Blob | null>;
    try {
      const camera = this.camera(shot, [this.arrange(moment)], false);
      camera.turn(0);
      this.draw(shot, camera, 0);
      made = new Promise((resolve) => this.stage.scenery.renderer.domElement.toBlob(resolve));
    } finally {
      end(); // before anybody sees it
    }
    const blob = await made;
    if (!blob) throw new Error("The picture could not be made.");
    return new Uint8Array(await blob.arrayBuffer());
  }

  /** The stage as a shot wants it; the answer makes it what it was. */
  private begin(shot: Shot): () => void {
    const { scenery } = this.stage;
    const { scene, human, ground } = scenery;
    const { background } = scene;
    const { width } = human;
    const grid = ground.group.children[0];
    const plain = shot.clear || shot.colour !== null;
    const behind = shot.colour === null ? null : new Color(shot.colour);
    const dress = (on: boolean): void => {
      scene.background = on && plain ? behind : background;
      if (grid) grid.visible = !(on && plain);
      human.group.visible = !(on && shot.alone);
      this.stage.beside?.hideHandle(on);
      scenery.setWidth(human, on && shot.alone ? 0 : width); // and the stage begins where the figures are
    };
    this.hold();
    dress(true);
    return () => {
      dress(false);
      this.stage.frame = 0;
      this.stage.resize();
    };
  }

  /** The stage draws nothing of its own: a picture seems to be due, so none is asked for. */
  private hold(): void {
    cancelAnimationFrame(this.stage.frame);
    this.stage.frame = -1;
  }

  /** Puts a moment on the stage; answers what of it must be seen. */
  private arrange({ shape, companion, pose, again }: Moment): Content {
    const { scenery, figures } = this.stage;
    const { model } = figures;
    if (!model?.body.takes(shape)) throw new Error("The model has changed meanwhile.");
    if (again) {
      scenery.beginAgain();
      if (companion) this.stage.beside?.beginAgain(...companion.way);
    }
    figures.setShape(shape);
    if (pose) figures.setPose(pose);
    figures.take();
    if (companion) this.stage.beside?.setShape(companion.shape, companion.standing);
    scenery.arrange();
    const beyond = Math.max(0, 2 * reach(model.body.outline(shape), scenery.model.traveller.ground) - scenery.model.width);
    const { width, height, depth } = scenery.content;
    return { width: width + beyond, height, depth: depth + beyond };
  }

  private camera(shot: Shot, contents: readonly Content[], around: boolean): FilmCamera {
    const most = (of: keyof Content): number => contents.reduce((so, content) => Math.max(so, content[of]), 0);
    const camera = new FilmCamera(this.stage.rig);
    camera.fit({ width: most("width"), height: most("height"), depth: most("depth") }, shot.width, shot.height, around);
    this.settle();
    return camera;
  }

  /** The next moment is where the figures begin: what was looked through before leaves no trace. */
  private settle(): void {
    const { scenery } = this.stage;
    scenery.setWidth(scenery.model, scenery.model.width);
  }

  private draw({ width, height, clear, colour }: Shot, { camera, distance }: FilmCamera, seconds: number): void {
    const { scenery } = this.stage;
    const { renderer } = scenery;
    this.hold(); // a window that changed its size gave the stage back to itself
    if (renderer.getContext().isContextLost()) throw new Error("The graphics card is busy with something else. Try again.");
    scenery.follow(seconds, false);
    if (renderer.domElement.width !== width || renderer.domElement.height !== height) {
      const ratio = Math.max(1, Math.floor(Math.min(width, height) / SCREEN));
      scenery.resize(width / ratio, height / ratio, ratio);
    }
    scenery.render(camera, clear || colour !== null ? NO_FOG : distance);
  }
}

/** How far from a place the farthest vertex is, across the ground. */
function reach(vertices: Float32Array, from: { x: number; y: number }): number {
  let most = 0;
  for (let v = 0; v < vertices.length; v += 3) most = Math.max(most, Math.hypot(vertices[v]! - from.x, vertices[v + 2]! - from.y));
  return most;
}
