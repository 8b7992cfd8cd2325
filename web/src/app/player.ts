import { FPS } from "../engine/types";
import { Emitter } from "../util/emitter";
import { seconds } from "../util/words";
import type { ClockPort } from "./ports";

export interface PlayerEvents {
  /** The frame to show changed. */
  frame: number;
  /** Somebody set the playhead. */
  sought: void;
  /** The end was reached and the beginning comes next. */
  again: void;
  /** Playing, waiting, loop, speed or the length changed. */
  state: void;
}

const SPEEDS = [0.25, 0.5, 1, 2] as const;

/** The playhead: which frame is now. Knows nothing of what a frame shows. */
export class Player extends Emitter<PlayerEvents> {
  frames = 0;
  playing = false;
  loop = true;
  /** Of watching. */
  speed = 1;
  /** Of the dance itself. */
  pace = 1;
  /** The last frame is the first again. */
  closed = false;
  /** Playing, but the time stands still: a hand is about to take something that moves. */
  waiting = false;
  private time = 0;
  private last = 0;
  private callOff = (): void => {};

  constructor(private readonly clock: ClockPort) {
    super();
  }

  get frame(): number {
    return this.frames === 0 ? 0 : Math.min(this.frames - 1, Math.floor(this.time * FPS + 1e-6));
  }

  /** Of the dance at its own speed, at the playhead. */
  get seconds(): number {
    return this.frame / FPS / this.pace;
  }

  /** Seconds of one round. */
  get length(): number {
    return (this.frames - Number(this.closed)) / FPS / this.pace;
  }

  /** "1.4 s" at the playhead. */
  get clockWords(): string {
    return seconds(this.seconds);
  }

  setFrames(frames: number): void {
    if (frames === this.frames) return;
    this.frames = frames;
    if (this.time * FPS >= frames) this.time = 0;
    this.emit("state", undefined);
    this.emit("frame", this.frame);
  }

  play(): void {
    if (this.playing || this.frames === 0) return;
    if (!this.loop && this.frame === this.frames - 1) this.time = 0;
    this.playing = true;
    this.last = performance.now();
    this.askForTick();
    this.emit("state", undefined);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.callOff();
    this.emit("state", undefined);
  }

  wait(waiting: boolean): void {
    if (waiting === this.waiting) return;
    this.waiting = waiting;
    this.emit("state", undefined);
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  setLoop(loop: boolean): void {
    this.loop = loop;
    this.emit("state", undefined);
  }

  /** The next speed, around the end. */
  nextSpeed(): void {
    const at = SPEEDS.findIndex((speed) => speed === this.speed);
    this.speed = SPEEDS[(at + 1) % SPEEDS.length] ?? 1;
    this.emit("state", undefined);
  }

  /** Goes to a frame; playing goes on from there. */
  seek(frame: number): void {
    if (this.frames === 0) return;
    const before = this.frame;
    this.time = Math.max(0, Math.min(this.frames - 1, Math.round(frame))) / FPS;
    if (this.frame !== before) this.emit("frame", this.frame);
    this.emit("sought", undefined);
  }

  /** Pauses and moves by whole frames, around the ends when looping. */
  step(by: number): void {
    this.pause();
    const to = this.frame + by;
    this.seek(this.loop ? (to + this.frames) % this.frames : to);
  }

  private askForTick(): void {
    this.callOff = this.clock.nextFrame(this.tick);
  }

  private readonly tick = (now: number): void => {
    if (!this.playing) return;
    const before = this.frame;
    // A tab that slept must not jump through the whole dance; a frame's time may lie before the click that began it.
    if (!this.waiting) this.time += (Math.min(100, Math.max(0, now - this.last)) / 1000) * this.speed * this.pace;
    this.last = now;
    const length = (this.frames - Number(this.closed)) / FPS;
    if (this.time >= length) {
      if (this.loop) {
        this.time %= length;
        this.emit("again", undefined);
      } else {
        this.time = (this.frames - 1) / FPS;
        this.pause();
      }
    }
    if (this.frame !== before) this.emit("frame", this.frame);
    if (this.playing) this.askForTick();
  };
}
