// A film of the dance, frame by frame from what is solved: however slowly that is drawn, it plays at 30 frames a second.

import type { FilmKind, FilmShot, Moment, Shot, Studio } from "../stage/studio";
import { FPS } from "../util/constants";
import { bytes as sizeOf, seconds as sayTime } from "../util/words";
import { isAbort } from "./aborts";
import type { Context } from "./context";
import type { Duet } from "./duet";
import { errorText } from "./error-words";
import type { KeptSong, Ports } from "./ports";
import type { Presenter } from "./presenter";
import type { Song } from "./song";

export const FRAMES = [
  { name: "Square", width: 1080, height: 1080 },
  { name: "Upright", width: 1080, height: 1920 },
  { name: "Wide", width: 1920, height: 1080 },
] as const;

/** Seconds. */
export const SHORTEST = 2;
export const LONGEST = 30;
/** Of a camera that goes around. */
const TURN_SECONDS = 8;
/** A GIF holds every pixel of every frame: it is so many times smaller. */
const GIF_SHRINKS = 3;
/** So many times smaller is what shows how it will look. */
const PREVIEW_SHRINKS = 3;

const TYPES: Readonly<Record<FilmKind, string>> = { mp4: "video/mp4", webm: "video/webm", gif: "image/gif" };

export interface FilmWish {
  readonly frame: (typeof FRAMES)[number];
  readonly seconds: number;
  /** The camera goes around, or stays where the person put it. */
  readonly turntable: boolean;
  /** Without the human. */
  readonly alone: boolean;
  /** Nothing behind; a WebM alone can be so. */
  readonly clear: boolean;
  /** What is behind instead of the stage: "#rrggbb". */
  readonly colour: string | null;
  readonly kind: FilmKind;
  /** Without the song. */
  readonly silent: boolean;
}

export interface Film {
  readonly name: string;
  readonly type: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export type FilmState =
  | { readonly kind: "wished" }
  | { readonly kind: "making" /** Frames. */; readonly done: number; readonly of: number }
  | { readonly kind: "made"; readonly film: Film }
  | { readonly kind: "failed"; readonly why: string };

export class Filming {
  wish: FilmWish = {
    frame: FRAMES[0],
    seconds: SHORTEST,
    turntable: false,
    alone: false,
    clear: false,
    colour: null,
    kind: "mp4",
    silent: false,
  };
  state: FilmState = { kind: "wished" };
  /** What this browser can make; empty until that is known. */
  kinds: readonly FilmKind[] = [];
  /** A PNG of how it will look. */
  preview: Uint8Array<ArrayBuffer> | null = null;
  private work = new AbortController();

  constructor(
    private readonly context: Context,
    private readonly presenter: Presenter,
    private readonly ports: Pick<Ports, "files">,
    private readonly beside: { readonly song: Song | null; readonly duet: Duet | null },
  ) {
    context.signals.on("document", () => this.stop());
  }

  /** How long the dance is, in seconds of film. */
  get danceSeconds(): number {
    const { pace } = this.context.player;
    return this.danceFrames / FPS / pace;
  }

  show(): void {
    const seconds = Math.min(LONGEST, Math.max(SHORTEST, this.danceSeconds));
    this.want({ seconds, silent: this.song?.muted ?? false });
  }

  /** What plays with the dance. */
  get song(): KeptSong | null {
    return this.beside.song?.kept ?? null;
  }

  want(change: Partial<FilmWish>): void {
    this.stop();
    this.wish = { ...this.wish, ...change };
    if (change.kind && change.kind !== "webm") this.wish = { ...this.wish, clear: false };
    if (change.clear) this.wish = { ...this.wish, kind: "webm", colour: null };
    if (change.colour) this.wish = { ...this.wish, clear: false };
    this.tell({ kind: "wished" });
    void this.look();
  }

  /** Nothing is made any more, and nothing of it is left. */
  stop(): void {
    this.work.abort();
    this.work = new AbortController();
    if (this.state.kind === "making") this.tell({ kind: "wished" });
  }

  close(): void {
    this.stop();
    this.state = { kind: "wished" };
    this.preview = null;
  }

  async make(): Promise<void> {
    this.stop();
    const { wish } = this;
    const { signal } = this.work;
    const { player, signals, document } = this.context;
    const frames = Math.round(wish.seconds * FPS);
    const { playing } = player;
    player.pause();
    const tell = (state: FilmState): void => {
      if (!signal.aborted) this.tell(state);
    };
    tell({ kind: "making", done: 0, of: frames });
    try {
      const studio = await this.studio();
      const turns = wish.turntable ? Math.max(1, Math.round(wish.seconds / TURN_SECONDS)) : 0;
      const shot: FilmShot = {
        ...this.shot(wish.kind === "gif" ? GIF_SHRINKS : 1),
        kind: wish.kind,
        frames,
        fps: FPS,
        turns,
        song: wish.silent ? null : (this.song?.bytes ?? null),
      };
      const onProgress = (done: number): void => tell({ kind: "making", done, of: frames });
      const bytes = await studio.film(shot, (n) => this.momentAt(n, signal), { signal, onProgress });
      tell({ kind: "made", film: { name: `${document.name}.${wish.kind}`, type: TYPES[wish.kind], bytes } });
    } catch (error) {
      tell(isAbort(error) ? { kind: "wished" } : { kind: "failed", why: errorText(error) });
    } finally {
      signals.tell("frame"); // the stage shows again what is at the playhead
      if (playing) player.play();
    }
  }

  /** The made film is downloaded. */
  save(): void {
    if (this.state.kind !== "made") return;
    const { name, type, bytes } = this.state.film;
    this.ports.files.download(name, bytes.slice(), type);
    const { width, height } = this.shot(this.wish.kind === "gif" ? GIF_SHRINKS : 1);
    this.context.notices.say({
      title: `${name} is ${sizeOf(bytes.length)}.`,
      text: `It lasts ${sayTime(this.wish.seconds)} and has ${width} by ${height} pixels.`,
      icon: "save",
    });
  }

  /** What is at the playhead, as a PNG. */
  async savePicture(): Promise<void> {
    const { document, notices } = this.context;
    try {
      const picture = await this.picture(1);
      const name = `${document.name}.png`;
      this.ports.files.download(name, picture, "image/png");
      notices.say({ title: `${name} is ${sizeOf(picture.length)}.`, icon: "save" });
    } catch (error) {
      notices.say({ bad: true, title: "The picture could not be made.", text: errorText(error) });
    }
  }

  private get danceFrames(): number {
    const { frames, closed } = this.context.player;
    return Math.max(1, frames - Number(closed));
  }

  private shot(shrinks: number): Shot {
    const { frame, alone, clear, colour } = this.wish;
    return { width: frame.width / shrinks, height: frame.height / shrinks, alone, clear, colour };
  }

  private tell(state: FilmState): void {
    this.state = state;
    this.context.signals.tell("export");
  }

  private async studio(): Promise<Studio> {
    const { stage } = this.presenter;
    if (!stage) throw new Error("This browser shows no 3D graphics, so there is nothing to film.");
    return stage.studio();
  }

  /** What can be made in this size, and how it will look. */
  private async look(): Promise<void> {
    const { signal } = this.work;
    try {
      const kinds = await (await this.studio()).kinds(this.wish.frame);
      if (signal.aborted) return;
      this.kinds = kinds;
      if (!kinds.includes(this.wish.kind) && kinds[0]) this.wish = { ...this.wish, kind: kinds[0], clear: false };
      const preview = await this.picture(PREVIEW_SHRINKS);
      if (signal.aborted) return;
      this.preview = preview;
      this.tell(this.state);
    } catch (error) {
      if (!signal.aborted) this.tell({ kind: "failed", why: errorText(error) });
    }
  }

  private async picture(shrinks: number): Promise<Uint8Array<ArrayBuffer>> {
    const { context } = this;
    const { frame } = context.player;
    const shape = context.workspace.cache.nearest(frame)?.shape;
    if (!shape) throw new Error("There is no dance yet.");
    const companion = this.beside.duet?.at(context.player.seconds, 0) ?? null;
    const moment = { shape, companion, pose: this.poseAt(frame), again: false };
    const picture = await (await this.studio()).picture(this.shot(shrinks), moment);
    context.signals.tell("frame");
    return picture;
  }

  private async momentAt(n: number, signal: AbortSignal): Promise<Moment> {
    const { workspace, player } = this.context;
    const { danceFrames } = this;
    const danced = (of: number): number => Math.floor(of * player.pace + 1e-6);
    const frame = danced(n) % danceFrames;
    const round = (of: number): number => Math.floor(danced(of) / danceFrames);
    if (!workspace.cache.isFresh(frame)) {
      workspace.focus(frame);
      await workspace.sync();
      signal.throwIfAborted();
    }
    const shape = workspace.cache.at(frame)?.shape;
    if (!shape) throw new Error("The dance was not solved, so there is nothing to film.");
    const companion = (await this.beside.duet?.freshAt(n / FPS, round(n), signal)) ?? null;
    return { shape, companion, pose: this.poseAt(frame), again: n > 0 && round(n) !== round(n - 1) };
  }

  private poseAt(frame: number): Float32Array | null {
    return this.context.motion ? this.presenter.humanPose(frame) : null;
  }
}
