// What the tests of the app share: the real engine, readers and assets, a stage that writes down what it is told, and a clock
// that stands still until it is wound.

import { readdirSync, readFileSync } from "node:fs";
import { afterEach, expect } from "vitest";
import characters from "../../assets/characters/index.json";
import motions from "../../assets/motions/index.json";
import { Context } from "../../src/app/context";
import type { AssetsPort, ClockPort, FileKind, KeptWork, PickedFile, Ports, ShelfPort, Sound } from "../../src/app/ports";
import { Session } from "../../src/app/session";
import type { Topics } from "../../src/app/signals";
import { parseProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { EngineClient } from "../../src/engine/client";
import { channelWorker } from "../../src/engine/node";
import { readClips } from "../../src/io/clips/read-clips";
import { buildMorphsInNode, buildSkinInNode } from "../../src/engine/skin-node";
import { normalPath } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import type { CompanionEvents, CompanionPort, DrawnModel, Shape, StageEvents, StageLook, StagePort, StageView } from "../../src/stage/port";
import type { FilmShot, Moment, Studio } from "../../src/stage/studio";
import { Emitter } from "../../src/util/emitter";
import type { Standing } from "../../src/util/standing";

const ASSETS = new URL("../../assets/", import.meta.url);
const wasm = (name: string) => new Uint8Array(readFileSync(new URL(`../../src/engine/${name}`, import.meta.url))).buffer;

/** The first second of a motion: enough to dance, and soon solved. */
const FRAMES = 30;

function firstSecond(bvh: string): string {
  const lines = bvh.trimEnd().split("\n");
  const at = lines.findIndex((line) => line.startsWith("Frames:"));
  return [...lines.slice(0, at), `Frames: ${FRAMES}`, ...lines.slice(at + 1, at + 2 + FRAMES)].join("\n");
}

export const assets: AssetsPort = {
  characters: characters as unknown as AssetsPort["characters"],
  motions,
  paths: readdirSync(ASSETS, { recursive: true, encoding: "utf8" }).map((path) => path.replaceAll("\\", "/")),
  address: (path) => (assets.paths.includes(path) ? `assets/${path}` : null),
  load: async (path) => {
    const bytes = new Uint8Array(readFileSync(new URL(path, ASSETS)));
    return path.endsWith(".bvh") ? new TextEncoder().encode(firstSecond(new TextDecoder().decode(bytes))) : bytes;
  },
};

/** A clock that is wound by hand. */
export class Clock implements ClockPort {
  now = 0;
  private readonly calls = new Set<(now: number) => void>();

  nextFrame(call: (now: number) => void): () => void {
    this.calls.add(call);
    return () => this.calls.delete(call);
  }

  idle(): Promise<void> {
    return new Promise((resolve) => setImmediate(resolve));
  }

  /** The next picture is due. */
  tick(milliseconds: number): void {
    this.now += milliseconds;
    const due = [...this.calls];
    this.calls.clear();
    for (const call of due) call(this.now);
  }

  get waiting(): number {
    return this.calls.size;
  }
}

/** A stage on paper: what it was told last, and how often. */
export class PaperStage extends Emitter<StageEvents> implements StagePort {
  model: Parameters<StagePort["setModel"]>[0] = null;
  human: Parameters<StagePort["setHuman"]>[0] = null;
  shape: Shape | null = null;
  humanPose: Float32Array | null = null;
  points: Parameters<StagePort["setPoints"]>[0] = [];
  selected: string | null = null;
  look: Partial<StageLook> = {};
  insets: Parameters<StagePort["setInsets"]>[0] | null = null;
  readonly told: string[] = [];

  async setModel(model: PaperStage["model"]): Promise<void> {
    this.told.push("model");
    this.model = model;
  }
  setShape(shape: Shape): void {
    this.told.push("shape");
    this.shape = shape;
  }
  setHuman(human: PaperStage["human"]): void {
    this.told.push("human");
    this.human = human;
  }
  setHumanPose(positions: Float32Array): void {
    this.humanPose = positions;
  }
  beginAgain(): void {
    this.told.push("again");
  }
  setPoints(points: PaperStage["points"], selected: string | null): void {
    this.told.push("points");
    this.points = points;
    this.selected = selected;
  }
  setLook(look: Partial<StageLook>): void {
    this.look = { ...this.look, ...look };
  }
  setInsets(insets: PaperStage["insets"] & object): void {
    this.insets = insets;
  }
  fit(view?: StageView): void {
    this.told.push(view ? `fit ${view}` : "fit");
  }
  thumbnail(shape: Shape, size: number): string {
    return `picture of ${shape.length / 3} at ${size}, ${shape.reduce((sum, value) => sum + value, 0).toFixed(3)}`;
  }
  /** Whoever dances beside, on paper. */
  beside: PaperCompanion | null = null;
  async companion(): Promise<PaperCompanion> {
    return (this.beside = new PaperCompanion());
  }
  /** Films on paper: what was to be drawn, moment by moment. */
  readonly films: { shot: FilmShot; moments: Moment[] }[] = [];
  async studio(): Promise<Studio> {
    return {
      kinds: async () => ["mp4", "webm"],
      film: async (shot, momentAt, { signal, onProgress }) => {
        const moments: Moment[] = [];
        this.films.push({ shot, moments });
        while (moments.length < shot.frames) {
          moments.push(await momentAt(moments.length));
          signal.throwIfAborted();
          onProgress(moments.length);
          await new Promise((resolve) => setImmediate(resolve));
        }
        return new TextEncoder().encode(`${shot.kind} of ${shot.frames}`);
      },
      picture: async (shot) => new TextEncoder().encode(`png of ${shot.width} by ${shot.height}`),
    };
  }
  dispose(): void {
    this.told.push("dispose");
  }
}

export class PaperCompanion extends Emitter<CompanionEvents> implements CompanionPort {
  model: DrawnModel | null = null;
  shape: Shape | null = null;
  standing: Standing | null = null;
  place: [number, number] | null = null;
  handle: string | null = null;
  disposed = false;

  async setModel(model: DrawnModel): Promise<void> {
    this.model = model;
  }
  setShape(shape: Shape, standing: Standing): void {
    this.shape = shape;
    this.standing = standing;
  }
  beginAgain(): void {}
  setPlace(x: number, z: number): void {
    this.place = [x, z];
  }
  setHandle(words: string | null): void {
    this.handle = words;
  }
  dispose(): void {
    this.disposed = true;
  }
}

/** A shelf whose projects are copies, as in a browser. Pages that share it are tabs. */
export class TestShelf {
  readonly kept = new Map<string, KeptWork>();
  readonly claims = new Map<string, object>();
  /** Why nothing more can be kept. */
  full: Error | null = null;

  tab(): ShelfPort {
    const { kept, claims } = this;
    const tab = {};
    const release = (): void => {
      for (const [id, by] of claims) if (by === tab) claims.delete(id);
    };
    const claim = async (id: string): Promise<boolean> => {
      release();
      if (claims.has(id)) return false;
      claims.set(id, tab);
      return true;
    };
    return {
      claim,
      begin: async () => {
        const id = `project ${kept.size + claims.size + 1}`;
        await claim(id);
        return id;
      },
      list: async () => [...kept.values()].sort((a, b) => b.changed - a.changed),
      load: async (id) => structuredClone(kept.get(id) ?? null),
      put: async (work) => {
        if (this.full) throw this.full;
        kept.set(work.id, structuredClone(work));
      },
      remove: async (id) => void kept.delete(id),
      release,
    };
  }
}

/** A song on paper: what it was told, and where it is. */
export class PaperSound implements Sound {
  playing = false;
  at = 0;
  speed = 1;
  closed = false;
  constructor(readonly seconds: number) {}
  play(at: number, speed: number): void {
    Object.assign(this, { playing: true, at, speed });
  }
  stop(): void {
    this.playing = false;
  }
  close(): void {
    this.stop();
    this.closed = true;
  }
}

export interface TestPorts extends Ports {
  /** Every song that was opened. Their first byte is how long they last; 0 cannot be played. */
  readonly sounds: PaperSound[];
  readonly clock: Clock;
  readonly shelf: TestShelf;
  /** What was offered as a download. */
  readonly downloads: { name: string; bytes: Uint8Array; type: string }[];
  /** What the person chooses when asked. */
  chosen: readonly PickedFile[];
  readonly asked: FileKind[];
}

export function testPorts(shelf = new TestShelf()): TestPorts {
  const ports: TestPorts = {
    assets,
    clock: new Clock(),
    shelf,
    address: { link: "", forget: () => Object.assign(ports.address, { link: "" }) },
    memory: { project: null, opening: null, kept: shelf.kept.size > 0 },
    openShelf: async () => shelf.tab(),
    downloads: [],
    chosen: [],
    asked: [],
    files: {
      pick: async (kind) => {
        ports.asked.push(kind);
        return ports.chosen;
      },
      download: (name, bytes, type) => ports.downloads.push({ name, bytes, type }),
    },
    sounds: [],
    openSound: async ([seconds]) => {
      if (!seconds) throw new Error("It cannot be decoded.");
      const sound = new PaperSound(seconds);
      ports.sounds.push(sound);
      return sound;
    },
    createEngine: () => new EngineClient(channelWorker(), wasm("rigless.wasm"), async () => wasm("shape-analysis.wasm")),
    buildSkin: buildSkinInNode,
    buildMorphs: buildMorphsInNode,
    readModel: async (files, { signal } = {}) => {
      const model = await readModel(files);
      signal?.throwIfAborted();
      return model;
    },
    readClips,
    calm: true,
  };
  return ports;
}

export const file = (name: string, content: string | Uint8Array): PickedFile => ({
  name,
  arrayBuffer: async () => (typeof content === "string" ? new TextEncoder().encode(content) : content.slice()).buffer as ArrayBuffer,
});

const closing: (() => void)[] = [];
afterEach(() => {
  for (const close of closing.splice(0)) close();
});

/** The cactus and the first second of its dance as a document, its model and motion known to the context's library. */
async function cactus({ workspace }: Context): Promise<ProjectDocument> {
  const [character] = assets.characters;
  const path = normalPath(`characters/${character.project}`);
  const { document } = parseProject(new TextDecoder().decode(await assets.load(path)), "project.json");
  const bytes = await assets.load(path.replace(/[^/]*$/, document.mesh.file));
  const name = document.mesh.file;
  const mesh = workspace.library.addModel(name, await readModel([{ name, bytes }]));
  const text = new TextDecoder().decode(await assets.load("motions/hop.bvh"));
  const files = workspace.library.addMotion(["hop.bvh"], { name: "hop.bvh", text });
  return { ...document, mesh: { ...document.mesh, file: mesh }, motion: { files } };
}

/** A context with nothing in it yet. */
export function emptyContext(): { context: Context; clock: Clock; ports: TestPorts } {
  const ports = testPorts();
  const context = new Context(ports);
  closing.push(() => context.workspace.close());
  return { context, clock: ports.clock, ports };
}

/** Solves and bakes the present document. */
export async function danced({ workspace }: Context): Promise<void> {
  do await workspace.sync();
  while (workspace.cache.staleCount > 0);
}

/** A context in which the cactus has danced; the playhead knows how long. */
export async function dancingContext(): Promise<{ context: Context; clock: Clock; ports: TestPorts }> {
  const made = emptyContext();
  const { context } = made;
  context.history.replace(await cactus(context));
  await danced(context);
  context.player.setFrames(context.performance?.frames ?? 0);
  return made;
}

/** The whole app: the cactus has danced, and there is a stage. */
export async function dancingSession(ports = testPorts()): Promise<{ session: Session; stage: PaperStage; ports: TestPorts }> {
  const session = new Session(ports);
  closing.push(() => session.close());
  const stage = new PaperStage();
  await session.start(() => stage);
  await danced(session.context);
  await expect.poll(() => stage.shape).not.toBeNull();
  return { session, stage, ports };
}

/** Writes down which topics are told from now on. */
export function listen({ signals }: Context, ...topics: (keyof Topics)[]): (keyof Topics)[] {
  const told: (keyof Topics)[] = [];
  for (const topic of topics) signals.on(topic, () => told.push(topic));
  return told;
}

/** The titles of what was said and not dismissed. */
export const said = ({ notices }: Context): string[] => notices.all.map(({ title }) => title);
