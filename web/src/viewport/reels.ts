// What a film's frames are wound up on: MP4 and WebM by the browser's own encoders, or a GIF where it has none.

import {
  type AudioCodec,
  AudioBufferSource,
  BufferTarget,
  CanvasSource,
  getFirstEncodableAudioCodec,
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

/** Some browsers may not make AAC. */
const SOUNDS: Readonly<Record<"mp4" | "webm", AudioCodec[]>> = { mp4: ["aac", "opus"], webm: ["opus"] };
/** Opus knows no 44.1 kHz. */
const RATE = 48_000;
const CHANNELS = 2;

export async function encodableKinds({ width, height }: Pick<Shot, "width" | "height">): Promise<FilmKind[]> {
  const kinds: FilmKind[] = [];
  for (const kind of ["mp4", "webm"] as const)
    if (await getFirstEncodableVideoCodec(CODECS[kind], { width, height, quality: QUALITY_HIGH })) kinds.push(kind);
  return kinds.length > 0 ? kinds : ["gif"];
}

/** A film's length of a song, over and over where it is shorter. */
async function lengthOf(song: Uint8Array, seconds: number): Promise<AudioBuffer> {
  const context = new OfflineAudioContext(CHANNELS, Math.round(seconds * RATE), RATE);
  const source = context.createBufferSource();
  source.buffer = await context.decodeAudioData(song.slice().buffer);
  source.loop = true;
  source.connect(context.destination);
  source.start();
  return context.startRendering();
}

async function soundTrack(container: "mp4" | "webm"): Promise<AudioBufferSource> {
  const codec = await getFirstEncodableAudioCodec(SOUNDS[container], {
    numberOfChannels: CHANNELS,
    sampleRate: RATE,
    quality: QUALITY_HIGH,
  });
  if (!codec) throw new Error("This browser cannot put a song into a film. Choose no sound, or the other kind.");
  return new AudioBufferSource({ codec, quality: QUALITY_HIGH });
}

export async function videoReel(shot: FilmShot, canvas: HTMLCanvasElement): Promise<Reel> {
  const { kind, width, height, clear, fps, song } = shot;
  const container = kind === "mp4" ? "mp4" : "webm";
  const codec = await getFirstEncodableVideoCodec(CODECS[container], { width, height, quality: QUALITY_HIGH });
  if (!codec) throw new Error(`This browser cannot make a ${kind.toUpperCase()} of ${width} by ${height} pixels.`);
  const target = new BufferTarget();
  const output = new Output({ format: kind === "mp4" ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new CanvasSource(canvas, { codec, quality: QUALITY_HIGH, alpha: clear ? "keep" : "discard" });
  output.addVideoTrack(source, { frameRate: fps });
  const sound = song && (await soundTrack(container));
  if (sound) output.addAudioTrack(sound);
  await output.start();
  let frames = 0;
  return {
    add: () => source.add(frames++ / fps, 1 / fps),
    finish: async () => {
      if (sound) await sound.add(await lengthOf(song, shot.frames / fps));
      await output.finalize();
      return new Uint8Array(target.buffer ?? new ArrayBuffer(0));
    },
    cancel: () => output.cancel(),
  };
}
