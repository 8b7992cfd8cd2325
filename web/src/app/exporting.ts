// What a dance is taken away as: a model of which size and likeness are seen before it is saved, or a film. Not part of the first load.

import { saidOf } from "../document/clips";
import { companionDocument } from "../document/duet";
import type { ProjectDocument } from "../document/types";
import type { Frame } from "../engine/types";
import type { DanceBeside } from "../io/export-duet";
import { everyFor, exportDance, keptOf, lengthsOf, sayReplaced, sayHolding } from "../io/export-dance";
import { PACES, paced } from "../io/pace";
import type { Likeness, Profile } from "../io/profile";
import { PROFILES } from "../io/profiles";
import type { Clip } from "../io/write-glb";
import { pairingFault } from "../sync/pairing";
import { bytes as sizeOf, count } from "../util/words";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Cast } from "./cast";
import type { Context } from "./context";
import type { Duet } from "./duet";
import { errorText } from "./error-words";
import { Filming } from "./filming";
import { Linking } from "./linking";
import type { MotionEntry, Motions } from "./motions";
import type { Ports } from "./ports";
import type { Presenter } from "./presenter";
import type { Song } from "./song";
import type { Sources } from "./sources";

export { PACES, PROFILES, sayHolding };

export interface ExportHelpers {
  readonly sources: Sources;
  readonly motions: Motions;
  readonly builtins: Builtins;
  readonly presenter: Presenter;
  readonly cast: Cast;
  readonly song: Song | null;
  readonly duet: Duet | null;
}

/** What is taken away. */
export type Souvenir = "model" | "film" | "link";

export interface ExportWish {
  /** Frames per second. */
  readonly fps: number;
  readonly profile: Profile;
  /** All motions, or the one that plays. */
  readonly all: boolean;
  readonly inPlace: boolean;
}

export interface MadeFile {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly likeness: Likeness | null;
  readonly clips: number;
  readonly frames: number;
  /** What to know before it is saved. */
  readonly notes: readonly string[];
}

export type ExportState =
  | { readonly kind: "closed" | "stopped" }
  | { readonly kind: "making"; readonly step: string /** 0..1 of all. */; readonly done: number }
  | { readonly kind: "made"; readonly file: MadeFile }
  | { readonly kind: "failed"; readonly why: string };

/** Baking and fitting take about as long. */
const FITTING = 0.5;

export class Exporting {
  wish: ExportWish = { profile: PROFILES[0], all: false, inPlace: false, fps: 30 };
  state: ExportState = { kind: "closed" };
  what: Souvenir = "model";
  readonly film: Filming;
  readonly link: Linking;
  private work = new AbortController();
  /** Frames of this document's dances, by motion; another wish may want them again. */
  private danced: { document: ProjectDocument | null; frames: Map<string, Frame[] | null> } = { document: null, frames: new Map() };

  constructor(
    private readonly context: Context,
    private readonly helpers: ExportHelpers,
    private readonly ports: Pick<Ports, "files" | "buildSkin" | "buildMorphs">,
  ) {
    this.film = new Filming(context, helpers.presenter, ports, helpers);
    this.link = new Linking(context, helpers);
  }

  get motions(): readonly MotionEntry[] {
    return this.helpers.motions.list;
  }

  show(): void {
    this.what = "model";
    this.wish = { ...this.wish, all: false, inPlace: this.context.document.settings.inPlace };
    this.make();
  }

  /** One thing is made at a time. */
  choose(what: Souvenir): void {
    if (what === this.what) return;
    this.what = what;
    this.film.close();
    if (what === "model" && this.state.kind === "stopped") return this.make();
    if (what !== "model" && this.state.kind === "making") this.work.abort();
    this.tell(this.state.kind === "making" ? { kind: "stopped" } : this.state);
    if (what === "film") this.film.show();
  }

  want(change: Partial<ExportWish>): void {
    this.wish = { ...this.wish, ...change };
    this.make();
  }

  stop(): void {
    this.work.abort();
    this.tell({ kind: "stopped" });
  }

  close(): void {
    if (this.state.kind === "closed") return;
    this.work.abort();
    this.film.close();
    this.danced = { document: null, frames: new Map() };
    this.tell({ kind: "closed" });
  }

  /** The made file is downloaded. */
  save(): void {
    if (this.state.kind !== "made") return;
    const { name, bytes } = this.state.file;
    const { worksIn } = this.wish.profile;
    this.ports.files.download(name, bytes.slice(), "model/gltf-binary");
    this.close();
    this.context.notices.say({ title: `${name} is ${sizeOf(bytes.length)}.`, text: `It opens in ${worksIn}.`, icon: "save" });
  }

  make(): void {
    this.work.abort();
    const work = new AbortController();
    this.work = work;
    const tell = (state: ExportState): void => {
      if (!work.signal.aborted) this.tell(state);
    };
    tell({ kind: "making", step: "Begin", done: 0 });
    this.file(work.signal, (step, done) => tell({ kind: "making", step, done })).then(
      (file) => tell({ kind: "made", file }),
      (error: unknown) => tell(isAbort(error) ? { kind: "stopped" } : { kind: "failed", why: errorText(error) }),
    );
  }

  private tell(state: ExportState): void {
    this.state = state;
    this.context.signals.tell("export");
  }

  private async file(signal: AbortSignal, progress: (step: string, done: number) => void): Promise<MadeFile> {
    const { context, wish } = this;
    const { document } = context;
    const model = context.model && this.helpers.sources.of(context.model)?.model;
    if (!model) throw new Error("There is no model yet.");
    const { name, mesh, points } = document;
    const entries = this.motions.filter((entry) => wish.all || this.helpers.motions.isPlaying(entry));
    const dances = await this.dances(document, entries, signal, (n, done) =>
      progress(
        entries.length > 1 ? `${entries[n].name}: ${n + 1} of ${entries.length}` : "Play through",
        ((n + done) / entries.length) * FITTING,
      ),
    );
    const clips: Clip[] = [];
    const left: string[] = [];
    dances.forEach((frames, n) => {
      const { speed = 1 } = saidOf({ ...document, motion: entries[n] });
      if (frames) clips.push({ name: entries.length > 1 ? entries[n].name : name, frames: paced(frames, wish.fps, speed) });
      else left.push(entries[n].name);
    });
    const lengths = lengthsOf(clips);
    const every = everyFor(lengths, wish.profile);
    const onProgress = (done: number): void => progress("Fit and write", FITTING + (1 - FITTING) * done);
    onProgress(0);
    const tools = { buildSkin: this.ports.buildSkin, buildMorphs: this.ports.buildMorphs, signal, onProgress };
    const hand = { name, model, mesh, points, clips, fps: wish.fps };
    const [only] = clips.length === 1 ? dances : [];
    const beside = only && (await this.danceBeside(document, signal));
    const { bytes, likeness } = beside
      ? await (await import("../io/export-duet")).exportDuet(hand, only, beside, every, tools, wish.profile)
      : await exportDance(hand, every, tools, wish.profile);
    signal.throwIfAborted();
    const replaced = sayReplaced(model);
    const { duet } = this.helpers;
    const notes = [
      ...(duet?.companion && !beside ? [`${duet.name} dances to one motion, so it is not in this file.`] : []),
      ...(replaced ? [replaced] : []),
      ...(left.length > 0 ? [`${left.join(", ")}: none of the joints that the points follow, so left out.`] : []),
      ...(every > 1
        ? [`Every ${every}. frame is kept, because viewers take at most ${count(wish.profile.mostKept ?? 0, "morph target")}.`]
        : []),
    ];
    return { name: `${name}.glb`, bytes, likeness, clips: clips.length, frames: keptOf(lengths, every), notes };
  }

  /** Of each motion its frames; null where it has none of the joints that the points follow. */
  private async dances(
    document: ProjectDocument,
    entries: readonly MotionEntry[],
    signal: AbortSignal,
    progress: (n: number, done: number) => void,
  ): Promise<readonly (Frame[] | null)[]> {
    if (this.danced.document !== document) this.danced = { document, frames: new Map() };
    const { frames } = this.danced;
    const { workspace } = this.context;
    const { inPlace } = this.wish;
    const key = ({ files }: MotionEntry): string => `${inPlace} ${files.join("\n")}`;
    const missing = entries.filter((entry) => !frames.has(key(entry)));
    await Promise.all(missing.map((entry) => this.load(entry)));
    const documents = missing.map(({ files }) => ({ ...document, settings: { ...document.settings, inPlace }, motion: { files } }));
    const alone = entries.length === 1;
    await workspace.eachDance(
      documents,
      (of, motion) => alone || pairingFault(of, motion) === null,
      (n, made) => frames.set(key(missing[n]), made),
      (n) => ({ signal, onProgress: (done) => progress(entries.indexOf(missing[n]), done) }),
    );
    signal.throwIfAborted();
    return entries.map((entry) => frames.get(key(entry)) ?? null);
  }

  /** Whoever dances beside; null: nobody does. */
  private async danceBeside(document: ProjectDocument, signal: AbortSignal): Promise<DanceBeside | null> {
    const { duet, sources } = this.helpers;
    const workspace = duet?.workspace;
    const [other, companion] = [companionDocument(document), document.companion];
    if (!duet || !workspace || !other || !companion) return null;
    const known = workspace.library.model(other.mesh.file);
    const source = known && sources.of(known);
    if (!source) throw new Error(`${duet.name} is not there yet.`);
    const inPlace = this.wish.inPlace === document.settings.inPlace ? other.settings.inPlace : this.wish.inPlace;
    let frames: Frame[] = [];
    await workspace.eachDance(
      [{ ...other, settings: { ...other.settings, inPlace } }],
      () => true,
      (_, made) => (frames = made ?? []),
      () => ({ signal }),
    );
    signal.throwIfAborted();
    return { document: other, offset: companion.offset, model: source.model, name: duet.name, frames };
  }

  private async load({ files, builtin }: MotionEntry): Promise<void> {
    const { builtins, sources } = this.helpers;
    const name = files.at(-1) ?? "";
    if (builtin && !this.context.workspace.library.motion(files)) sources.addMotion(files, { name, text: await builtins.motionText(name) });
  }
}
