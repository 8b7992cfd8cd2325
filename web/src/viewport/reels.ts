// What a film's frames are wound up on: MP4 and WebM by the browser's own encoders, or a GIF where it has none.

import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  type VideoCodec,
  WebMOutputFormat,
} from "mediabunny";
import type { FilmKind, FilmShot, Shot } from "../stage/studio";

export interface Reel {
  /** What the canvas shows now is the next frame. */
  add(canvas: HTMLCanvasElement): Promise<void>;
  finish(): Promise<Uint8Array<ArrayBuffer>>;
  cancel(): Promise<void>;
}

/** An MP4 holds what phones and chats play; another codec in it would play in fewer places than a WebM. */
const CODECS: Readonly<Record<"mp4" | "webm", VideoCodec[]>> = { mp4: ["avc"], webm: ["vp9", "vp8"] };

export async function encodableKinds({ width, height }: Pick<Shot, "width" | "height">): Promise<FilmKind[]> {
  const kinds: FilmKind[] = [];
  for (const kind of ["mp4", "webm"] as const)
    if (await getFirstEncodableVideoCodec(CODECS[kind], { width, height, quality: QUALITY_HIGH })) kinds.push(kind);
  return kinds.length > 0 ? kinds : ["gif"];
}

export async function videoReel({ kind, width, height, clear, fps }: FilmShot, canvas: HTMLCanvasElement): Promise<Reel> {
  const codecs = CODECS[kind === "mp4" ? "mp4" : "webm"];
  const codec = await getFirstEncodableVideoCodec(codecs, { width, height, quality: QUALITY_HIGH });
  if (!codec) throw new Error(`This browser cannot make a ${kind.toUpperCase()} of ${width} by ${height} pixels.`);
  const target = new BufferTarget();
  const output = new Output({ format: kind === "mp4" ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new CanvasSource(canvas, { codec, quality: QUALITY_HIGH, alpha: clear ? "keep" : "discard" });
  output.addVideoTrack(source, { frameRate: fps });
  await output.start();
  let frames = 0;
  return {
    add: () => source.add(frames++ / fps, 1 / fps),
    finish: async () => {
      await output.finalize();
      return new Uint8Array(target.buffer ?? new ArrayBuffer(0));
    },
    cancel: () => output.cancel(),
  };
}
