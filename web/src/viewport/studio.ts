// Films and pictures of the stage, drawn frame by frame on its own canvas at the film's size: the same scene, on the same card.

import type { FilmCall, FilmKind, FilmShot, Moment, Shot, Studio } from "../stage/studio";
import { FPS } from "../util/constants";
import type { CameraRig } from "./camera-rig";
import type { Figures } from "./figures";
import { FilmCamera } from "./film-camera";
import type { Content } from "./framing";
import type { Reel } from "./reels";
import type { Scenery } from "./scenery";

/** What must stay in the frame is looked for in every so many-th frame. */
const EVERY = 4;
/** A line of the grid is as wide as on a screen of so many pixels' width. */
const SCREEN = 540;
/** Behind everything. */
const NO_FOG = 1e3;

export class StageStudio implements Studio {
  /** `hold`: the stage draws nothing of its own, and then again. */
  constructor(
    private readonly scenery: Scenery,
    private readonly figures: Figures,
    private readonly rig: CameraRig,
    private readonly hold: (on: boolean) => void,
  ) {}

  async kinds(shot: Pick<Shot, "width" | "height">): Promise<readonly FilmKind[]> {
    return (await import("./reels")).encodableKinds(shot);
  }

  async film(shot: FilmShot, momentAt: (frame: number) => Promise<Moment>, { signal, onProgress }: FilmCall) {
    const { frames, turns } = shot;
    const canvas = this.scenery.renderer.domElement;
    const { videoReel } = await import("./reels");
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
      reel = await videoReel(shot, canvas);
      for (let n = 0; n < frames; n++) {
        this.arrange(await momentAt(n));
        camera.turn((2 * Math.PI * turns * n) / frames);
        this.draw(shot, camera);
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
      this.draw(shot, camera);
      made = new Promise((resolve) => this.scenery.renderer.domElement.toBlob(resolve));
    } finally {
      end(); // before anybody sees it
    }
    const blob = await made;
    if (!blob) throw new Error("The picture could not be made.");
    return new Uint8Array(await blob.arrayBuffer());
  }

  /** The stage as a shot wants it; the answer makes it what it was. */
  private begin(shot: Shot): () => void {
    const { scenery, hold } = this;
    const { scene, human, ground } = scenery;
    const { background } = scene;
    const { width } = human;
    const grid = ground.group.children[0];
    const dress = (on: boolean): void => {
      scene.background = on && shot.clear ? null : background;
      if (grid) grid.visible = !(on && shot.clear);
      human.group.visible = !(on && shot.alone);
      scenery.setWidth(human, on && shot.alone ? 0 : width); // and the stage begins where the figures are
    };
    hold(true);
    dress(true);
    return () => {
      dress(false);
      hold(false);
    };
  }

  /** Puts a moment on the stage; answers what of it must be seen. */
  private arrange({ shape, pose, again }: Moment): Content {
    const { scenery, figures } = this;
    const { model } = figures;
    if (!model?.body.takes(shape)) throw new Error("The model has changed meanwhile.");
    if (again) scenery.beginAgain();
    figures.setShape(shape);
    if (pose) figures.setPose(pose);
    figures.take();
    scenery.arrange();
    const beyond = Math.max(0, 2 * reach(model.body.outline(shape), scenery.model.traveller.ground) - scenery.model.width);
    const { width, height, depth } = scenery.content;
    return { width: width + beyond, height, depth: depth + beyond };
  }

  private camera(shot: Shot, contents: readonly Content[], around: boolean): FilmCamera {
    const most = (of: keyof Content): number => contents.reduce((so, content) => Math.max(so, content[of]), 0);
    const camera = new FilmCamera(this.rig);
    camera.fit({ width: most("width"), height: most("height"), depth: most("depth") }, shot.width, shot.height, around);
    this.scenery.setWidth(this.scenery.model, this.scenery.model.width); // what was looked through leaves no trace
    return camera;
  }

  private draw({ width, height, clear }: Shot, { camera, distance }: FilmCamera): void {
    const { scenery, hold } = this;
    const { renderer } = scenery;
    hold(true); // a window that changed its size gave the stage back to itself
    if (renderer.getContext().isContextLost()) throw new Error("The graphics card is busy with something else. Try again.");
    scenery.follow(1 / FPS, false);
    if (renderer.domElement.width !== width || renderer.domElement.height !== height) {
      const ratio = Math.max(1, Math.floor(Math.min(width, height) / SCREEN));
      scenery.resize(width / ratio, height / ratio, ratio);
    }
    scenery.render(camera, clear ? NO_FOG : distance);
  }
}

/** How far from a place the farthest vertex is, across the ground. */
function reach(vertices: Float32Array, from: { x: number; y: number }): number {
  let most = 0;
  for (let v = 0; v < vertices.length; v += 3) most = Math.max(most, Math.hypot(vertices[v]! - from.x, vertices[v + 2]! - from.y));
  return most;
}

/** Lets the page breathe; unlike a timer it does not wait longer where nobody looks. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
