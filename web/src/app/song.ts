// A song that plays with the dance: it begins with the first frame and goes on while the dance goes round. It stays on this machine.

import type { NamedFile } from "../io/named-file";
import type { Context } from "./context";
import type { KeptSong, Ports, Sound } from "./ports";

/** Seconds between dance and song that nobody notices. */
const DRIFT = 0.2;
/** A song that was told where to be needs a while to get there. */
const SETTLES_MS = 1000;

export class Song {
  kept: KeptSong | null = null;
  private sound: Sound | null = null;
  /** How often the dance has gone round since somebody set the playhead. */
  private rounds = 0;
  private told = { at: -Infinity, speed: 1 };
  private newest = 0;

  constructor(
    private readonly context: Context,
    private readonly ports: Pick<Ports, "openSound">,
  ) {
    const { player } = context;
    player.on("again", () => this.rounds++);
    player.on("sought", () => {
      this.rounds = 0;
      this.told.at = -Infinity;
      this.follow();
    });
    player.on("state", () => {
      this.told.at = -Infinity;
      this.follow();
    });
    player.on("frame", () => this.follow());
  }

  /** Where in the song the playhead is, in seconds. */
  get at(): number {
    const { seconds, length } = this.context.player;
    return this.rounds * length + seconds;
  }

  /** A file that was dropped or chosen; what cannot be played changes nothing and is said. */
  async take({ name, bytes }: NamedFile): Promise<void> {
    const { notices } = this.context;
    const before = this.kept;
    if (!(await this.put({ name, bytes, muted: false }))) {
      notices.say({ bad: true, title: `${name} cannot be played by this browser.`, text: "Save it as MP3 or WAV, and drop that." });
      return;
    }
    notices.say({
      title: `${name} plays with the dance.`,
      text: "It stays on this machine, and goes into films.",
      icon: "motion",
      actions: [{ label: "Undo", run: () => void this.put(before) }],
    });
  }

  remove(): void {
    const before = this.kept;
    if (!before) return;
    void this.put(null);
    this.context.notices.say({
      title: `${before.name} plays no more.`,
      icon: "motion",
      actions: [{ label: "Undo", run: () => void this.put(before) }],
    });
  }

  mute(muted: boolean): void {
    if (!this.kept) return;
    this.kept = { ...this.kept, muted };
    this.follow();
    this.context.signals.tell("song");
  }

  /** This one plays from now on, or none; false if it cannot be played. */
  async put(song: KeptSong | null): Promise<boolean> {
    const turn = ++this.newest;
    let sound: Sound | null = null;
    try {
      if (song) sound = await this.ports.openSound(song.bytes);
    } catch {
      return false;
    }
    if (turn !== this.newest) {
      sound?.close();
      return true;
    }
    this.sound?.close();
    this.sound = sound;
    this.kept = song;
    this.rounds = 0;
    this.told.at = -Infinity;
    this.follow();
    this.context.signals.tell("song");
    return true;
  }

  private follow(): void {
    const { sound, told } = this;
    const { playing, waiting, speed } = this.context.player;
    if (!sound) return;
    if (!playing || waiting || this.kept?.muted) {
      sound.stop();
      told.at = -Infinity;
      return;
    }
    const at = this.at % sound.seconds;
    const off = Math.abs(sound.at - at);
    const near = Math.min(off, sound.seconds - off) < DRIFT * Math.max(1, speed);
    const now = performance.now();
    if (now - told.at < SETTLES_MS || (sound.playing && near && told.speed === speed)) return;
    sound.play(at, speed);
    this.told = { at: now, speed };
  }
}
