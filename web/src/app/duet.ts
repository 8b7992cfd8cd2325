// Whoever dances beside the one in hand: solved by an engine of its own, and shown at the same moments. Not part of the first load.

import { saidOf } from "../document/clips";
import { companionDocument, moveCompanion, setCompanion, swapDancers } from "../document/duet";
import type { Companion, Offset, ProjectDocument } from "../document/types";
import { FPS } from "../engine/types";
import { baseName } from "../io/named-file";
import type { CompanionPort, Shape } from "../stage/port";
import { beatAt, standingOf } from "../sync/beside";
import { FrameCache } from "../sync/frame-cache";
import { Workspace } from "../sync/workspace";
import { restMaps } from "../util/solid-cells";
import type { Standing } from "../util/standing";
import { stem } from "../util/words";
import type { Context } from "./context";
import type { Dragging } from "./dragging";
import { drawnModel } from "./drawn-model";
import type { JobHandle } from "./jobs";
import { type PartnerHelpers, Partners } from "./partners";
import type { Ports } from "./ports";
import type { Presenter } from "./presenter";

/** What kept frames of a companion hold at most, together. */
const MOST_BYTES = 150e6;

export interface DuetHelpers extends PartnerHelpers {
  readonly dragging: Dragging;
  readonly presenter: Presenter;
}

/** What is seen of a companion at one moment. */
export interface Seen {
  readonly shape: Shape;
  readonly standing: Standing;
  /** How far the dance in hand comes in a round, x and z. */
  readonly way: readonly [number, number];
}

export class Duet {
  /** Who may come. */
  readonly partners: Partners;
  private dance: Workspace | null = null;
  private stage: CompanionPort | null = null;
  /** The same before it is there. */
  private staging: Promise<CompanionPort> | null = null;
  /** What shows while there is no dance. */
  private rest: Shape | null = null;
  /** How many are being tried on. */
  private coming = 0;
  /** How often the dance in hand has gone round since somebody set the playhead. */
  private rounds = 0;
  private slide: { key: string; gesture: symbol; from: Offset } | null = null;

  constructor(
    private readonly context: Context,
    private readonly helpers: DuetHelpers,
    private readonly ports: Pick<Ports, "createEngine" | "files" | "readModel">,
  ) {
    const { player, signals, workspace } = context;
    this.partners = new Partners(context, helpers, ports, (...companion) => this.bring(...companion));
    player.on("again", () => {
      this.rounds++;
      this.stage?.beginAgain(...this.way);
    });
    player.on("sought", () => {
      this.rounds = 0;
      this.show();
    });
    signals.on("frame", () => this.show());
    signals.on("document", () => this.follow());
    let held = false;
    signals.on("drag", () => {
      if (held === (helpers.dragging.active !== null)) return;
      held = !held; // the hand needs all of the machine
      if (held) this.dance?.hold();
      else this.dance?.release();
    });
    signals.on("travel", () => {
      this.slide = null;
    });
    signals.on("panel", () => this.nameHandle());
    signals.on("stage", () => void this.stand());
    workspace.on("performance", () => this.show());
    this.follow();
  }

  get companion(): Companion | null {
    return this.context.document.companion ?? null;
  }

  /** As a document of its own. */
  get document(): ProjectDocument | null {
    return companionDocument(this.context.document);
  }

  /** "Cactus"; "" while there is nobody. */
  get name(): string {
    const file = this.companion?.mesh.file ?? "";
    const name = this.helpers.cast.list.find((performer) => performer.file === file)?.name ?? stem(baseName(file));
    return name.charAt(0).toUpperCase() + name.slice(1);
  }

  /** Dances beside from now on, if an engine can take it: rejects with EngineError, and everything is as it was. */
  private async bring(companion: Companion, { signal, progress }: JobHandle): Promise<void> {
    const { history, selection } = this.context;
    const candidate = companionDocument({ ...history.document, companion });
    if (!candidate) return;
    this.coming++;
    try {
      await this.open().tryOn(candidate, signal, progress);
      history.apply(setCompanion(companion));
      selection.endIntro();
    } finally {
      this.coming--;
      if (!this.companion) this.leave();
    }
  }

  remove(): void {
    const { history, notices } = this.context;
    const { name } = this;
    history.apply(setCompanion(null));
    notices.say({ title: `${name} has left the stage.`, icon: "model", actions: [history.undoAction()] });
  }

  /** The companion is in hand from now on, and the other one dances beside. */
  swap(): void {
    this.context.history.apply(swapDancers);
  }

  /** While something is held, all its values are one step. */
  move(key: string, to: (from: Offset) => Partial<Offset>, held: boolean): void {
    const { companion } = this;
    if (!companion) return;
    if (this.slide?.key !== key) this.slide = { key, gesture: Symbol(key), from: companion.offset };
    const { gesture, from } = this.slide;
    this.context.history.apply(moveCompanion(to(from)), gesture);
    if (!held) this.slide = null;
  }

  /** So many seconds after the dance began, in its so many-th round; null while nobody dances beside. */
  at(seconds: number, rounds: number): Seen | null {
    const { companion, dance, rest, document } = this;
    const hand = this.context.performance;
    if (!companion || !document || !dance) return null;
    const { performance } = dance;
    const [x, z] = companion.offset.place;
    const { way } = this;
    if (!performance || !hand) return rest && { shape: rest, standing: { x, z, yaw: companion.offset.yaw }, way };
    const { frame, round } = this.beat(seconds);
    const { speed = 1, loop = false } = saidOf(document);
    const shape = dance.cache.at(frame)?.shape ?? dance.cache.nearest(frame)?.shape ?? rest;
    const length = Math.max(1, performance.frames - Number(loop)) / FPS / speed;
    const behind = (rounds * this.context.player.length) / length;
    return shape && { shape, standing: standingOf(companion.offset, hand, performance, round - behind), way };
  }

  /** The same once its frame is that of the present dance. */
  async freshAt(seconds: number, rounds: number, signal: AbortSignal): Promise<Seen | null> {
    const { dance } = this;
    if (!dance) return null;
    await dance.sync();
    const { frame } = this.beat(seconds);
    if (dance.performance && !dance.cache.isFresh(frame)) {
      dance.focus(frame);
      await dance.sync();
    }
    signal.throwIfAborted();
    return this.at(seconds, rounds);
  }

  /** Its own dance, for a file. */
  get workspace(): Workspace | null {
    return this.dance;
  }

  private get way(): readonly [number, number] {
    const { travel } = this.context.performance ?? {};
    return travel ? [(travel.at(-3) ?? 0) - travel[0], (travel.at(-1) ?? 0) - travel[2]] : [0, 0];
  }

  private beat(seconds: number): { frame: number; round: number } {
    const { document, dance, companion } = this;
    const { speed = 1, loop = false } = document ? saidOf(document) : {};
    return beatAt((seconds - (companion?.offset.seconds ?? 0)) * FPS * speed, dance?.performance?.frames ?? 1, loop);
  }

  private follow(): void {
    if (!this.companion) return this.leave();
    void this.open().sync();
    const { place } = this.companion.offset;
    this.stage?.setPlace(...place);
    this.nameHandle();
    this.show();
  }

  private open(): Workspace {
    if (this.dance) return this.dance;
    const { context, ports } = this;
    let last = context.document;
    const present = (): ProjectDocument => (last = this.document ?? last);
    const dance = new Workspace(present, ports.createEngine, context.workspace.library, new FrameCache(MOST_BYTES));
    this.dance = dance;
    dance.on("mesh", () => void this.stand());
    dance.on("performance", () => this.show());
    dance.on("frame", () => this.show());
    dance.on("failed", (error) => context.notices.say({ bad: true, title: `${this.name} cannot dance so.`, text: error.message }));
    return dance;
  }

  /** The stage is left; the engine stays for whoever is being tried on. */
  private leave(): void {
    if (this.coming === 0) return this.close();
    this.clear();
  }

  close(): void {
    this.dance?.close();
    this.dance = null;
    this.clear();
  }

  private clear(): void {
    if (this.stage) this.stage.dispose();
    else void this.staging?.then((stage) => stage.dispose());
    this.stage = this.staging = this.rest = null;
  }

  /** Puts the model on the stage. */
  private async stand(): Promise<void> {
    const { dance, companion } = this;
    const { stage: whole } = this.helpers.presenter;
    const source = dance?.model && this.helpers.sources.of(dance.model);
    if (!dance || !source || !companion || !whole) return;
    const solid = dance.report?.solid ?? null;
    const drawn = drawnModel(source.model, companion.mesh, solid);
    this.rest = solid ? restMaps(solid) : drawn.rest;
    const staging = (this.staging ??= whole.companion());
    const stage = await staging;
    if (this.staging !== staging) return;
    if (!this.stage) stage.on("move", ({ x, z, held }) => this.drag(x, z, held));
    this.stage = stage;
    stage.setPlace(...companion.offset.place);
    this.nameHandle();
    await stage.setModel(drawn);
    this.show();
  }

  private drag(x: number, z: number, held: boolean): void {
    if (!held && this.slide?.key !== "place") return; // it was taken back meanwhile
    this.move("place", ({ place }) => ({ place: [centimetres(place[0] + x), centimetres(place[1] + z)] }), held);
  }

  private show(): void {
    const { stage, dance, rounds } = this;
    if (!stage || !dance) return;
    const { player } = this.context;
    const elapsed = rounds * player.length + player.seconds;
    if (dance.performance) dance.focus(this.beat(elapsed).frame);
    const seen = this.at(elapsed, rounds);
    if (seen) stage.setShape(seen.shape, seen.standing);
  }

  private nameHandle(): void {
    const shown = this.context.selection.panel === "model" && this.companion !== null;
    this.stage?.setHandle(shown ? `${this.name}: drag it over the floor, or use the arrow keys` : null);
  }
}

const centimetres = (metres: number): number => Math.round(100 * metres) / 100;
