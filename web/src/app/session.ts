// What the page is doing now: the document and its engine, the playhead, the hand, and what is said about it. The elements draw
// it and call it; it knows no element.

import * as commands from "../document/commands";
import { DocumentStore } from "../document/store";
import type { Command, Gesture } from "../document/store";
import type { Axis, ProjectDocument, Settings } from "../document/types";
import { createBrowserEngine } from "../engine/browser";
import type { MeshReport, Motion, Performance } from "../engine/types";
import { Emitter } from "../util/emitter";
import type { SolverModel } from "../sync/prepare";
import { Workspace } from "../sync/workspace";
import type { Insets } from "../viewport/types";
import { Viewport } from "../viewport/viewport";
import { pickFiles } from "../ui/pick-files";
import type { FileKind } from "../ui/pick-files";
import { Builtins } from "./builtins";
import { Cast } from "./cast";
import type { Performer } from "./cast";
import { Dragging } from "./dragging";
import type { Drag } from "./dragging";
import { nextFacing, withUp } from "./facing";
import { FLIGHTS, Contacts } from "./contacts";
import { Guesses } from "./guesses";
import { Jobs } from "./jobs";
import { Meter } from "./meter";
import { Motions } from "./motions";
import type { MotionEntry } from "./motions";
import { Notices } from "./notices";
import type { NoticeAction } from "./notices";
import { Opening } from "./opening";
import { Pairing } from "./pairing";
import { Pins } from "./pins";
import { Points } from "./points";
import { Poses } from "./poses";
import { Player } from "./player";
import { Saving } from "./saving";
import { Show } from "./show";
import { Sources } from "./sources";
import { Coverage } from "./coverage";
import { Thumbnails } from "./thumbnails";
import type { PanelName } from "./panels";

export interface SessionEvents {
  document: void;
  /** The frame to show. */
  frame: void;
  play: void;
  /** Mesh, motion or dance changed, or solving began or ended. */
  solve: void;
  selection: void;
  panel: void;
  layout: void;
  notices: void;
  jobs: void;
  /** A character or a motion was chosen, or has arrived. */
  coming: void;
  thumbs: void;
  intro: void;
  help: void;
  meter: void;
  /** The hand took, moved or let go of a dot. */
  drag: void;
  pairing: void;
  pins: void;
  /** A pose is asked for, or not any more. */
  coverage: void;
  /** Saved, or not any more. */
  files: void;
  /** The stage was built. */
  stage: void;
}

const EMPTY = commands.newDocument("Untitled", { file: "", facing: "+z", up: "+y" }, { files: [] });

export class Session extends Emitter<SessionEvents> {
  readonly store = new DocumentStore(EMPTY);
  readonly workspace = new Workspace(() => this.store.document, createBrowserEngine);
  readonly player = new Player();
  readonly notices = new Notices();
  readonly jobs = new Jobs();
  readonly meter = new Meter(() => this.emit("meter", undefined));
  readonly thumbnails = new Thumbnails(this);
  readonly points = new Points(this);
  readonly pairing = new Pairing(this);
  readonly guesses = new Guesses(this);
  readonly poses = new Poses(this);
  readonly pins = new Pins(this);
  readonly contacts = new Contacts(this);
  readonly coverage = new Coverage(this);
  readonly builtins = new Builtins();
  readonly cast = new Cast(this);
  readonly motions = new Motions(this);
  readonly dragging = new Dragging(this);
  readonly sources = new Sources(this.workspace.library);
  private readonly opening = new Opening(this, this.sources);
  private readonly saving = new Saving(this, this.sources);
  private readonly show = new Show(this);
  viewport: Viewport | null = null;
  selected: string | null = null;
  panel: PanelName | null = null;
  layout: "side" | "overlay" = "side";
  intro = false;
  help = false;
  solving = false;
  /** The person has changed something since the page opened. */
  touched = false;
  /** Go on playing once the frame at the playhead has been solved. The page opens moving, unless that is unwelcome. */
  resume = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  private savedDocument: ProjectDocument | null = null;
  private slide: { key: string; gesture: Gesture } | null = null;

  constructor() {
    super();
    this.store.subscribe((document, previous) => {
      this.cast.remember(previous, document);
      this.documentChanged();
    });
    this.player.on("frame", (frame) => {
      this.workspace.focus(frame);
      this.show.frame();
      this.emit("frame", undefined);
    });
    this.player.on("again", () => this.viewport?.beginAgain());
    this.player.on("state", () => this.emit("play", undefined));
    this.notices.on("change", () => this.emit("notices", undefined));
    this.jobs.on("change", () => this.emit("jobs", undefined));
    this.listenToWorkspace();
  }

  /**
   * Begins with the cactus. The stage is built while the engine bakes: its shaders keep the page busy, and the engine would
   * wait for its orders behind them.
   */
  start(host: HTMLElement): void {
    this.intro = true;
    this.emit("intro", undefined);
    const build = (): void => {
      if (this.viewport) return;
      try {
        this.build(new Viewport(host));
      } catch (error) {
        const why = error instanceof Error ? error.message : String(error);
        this.notices.say({
          bad: true,
          title: "This browser shows no 3D graphics.",
          text: `Turn on hardware acceleration or try another browser. (${why})`,
        });
      }
    };
    this.workspace.on("performance", () => setTimeout(build)); // after the engine has been told to bake
    void this.opening.first().then((done) => {
      if (!done) build();
    });
  }

  private build(viewport: Viewport): void {
    this.viewport = viewport;
    this.listenToViewport(viewport);
    this.show.everything();
    if (this.intro) viewport.pulse(this.document.points[0]?.id ?? null);
    this.emit("stage", undefined);
  }

  close(): void {
    this.player.pause();
    this.workspace.close();
    this.viewport?.dispose();
  }

  // What is

  get document(): ProjectDocument {
    return this.store.document;
  }
  get motion(): Motion | null {
    return this.workspace.motion;
  }
  get report(): MeshReport | null {
    return this.workspace.report;
  }
  /** The file of what was chosen and is not there yet. */
  get coming(): string | null {
    return this.opening.coming;
  }
  get drag(): Drag | null {
    return this.dragging.active;
  }

  /** The dance, unless points came or went since it was solved. */
  get performance(): Performance | null {
    const { performance } = this.workspace;
    return performance && performance.controls.length === 3 * performance.frames * this.document.points.length ? performance : null;
  }

  get canUndo(): boolean {
    return this.store.canUndo;
  }
  get canRedo(): boolean {
    return this.store.canRedo;
  }
  get canExport(): boolean {
    return this.performance !== null;
  }
  get canPose(): boolean {
    return this.performance !== null;
  }
  get saved(): boolean {
    return this.document === this.savedDocument;
  }
  get model(): SolverModel | undefined {
    return this.workspace.library.model(this.document.mesh.file);
  }

  get modelName(): string {
    const name = this.cast.present?.name ?? "";
    return name.charAt(0).toUpperCase() + name.slice(1);
  }

  get motionName(): string {
    return this.document.motion.files.at(-1) ?? "";
  }

  // Changing the document

  apply(command: Command, gesture?: Gesture): void {
    this.touched = true;
    this.store.apply(command, gesture);
  }

  undo(): void {
    this.dragging.cancel();
    this.notices.retract(this.document);
    this.store.undo();
  }

  redo(): void {
    this.dragging.cancel();
    this.store.redo();
  }

  rename(name: string): void {
    this.apply(commands.renameProject(name));
  }

  /** While a slider is held, all its values are one step. */
  setSetting<K extends keyof Settings>(key: K, value: Settings[K], held: boolean): void {
    if (held && this.slide?.key !== key) this.slide = { key, gesture: Symbol(key) };
    const gesture = this.slide?.key === key ? this.slide.gesture : undefined;
    this.apply(commands.setSettings({ [key]: value }), gesture);
    if (!held) this.slide = null;
  }

  turnModel(): void {
    const { facing, up } = this.document.mesh;
    this.apply(commands.turnMesh(nextFacing(facing, up), up));
  }

  setUp(up: Axis): void {
    const mesh = withUp(this.document.mesh, up);
    this.apply(commands.turnMesh(mesh.facing, mesh.up));
  }

  /** Undoes what a notice speaks of. The notice keeps it only as long as nothing else has been done. */
  undoAction(): NoticeAction {
    return { label: "Undo", run: () => this.undo(), of: this.document };
  }

  // Files

  pickFiles(kind: FileKind = "any"): void {
    void pickFiles(kind).then((files) => {
      if (files.length > 0) return this.openFiles(files);
    });
  }

  openFiles(files: readonly File[]): Promise<void> {
    return this.opening.files(files);
  }
  usePerformer(performer: Performer): void {
    void this.opening.usePerformer(performer);
  }
  useMotion(entry: MotionEntry): void {
    void this.opening.useMotion(entry);
  }
  save(): Promise<void> {
    return this.saving.save();
  }
  exportModel(): void {
    void this.saving.exportModel();
  }

  markSaved(): void {
    this.savedDocument = this.document;
    this.emit("files", undefined);
  }

  /** Plays or pauses; whoever does so wants no more surprises. */
  togglePlay(): void {
    this.resume = false;
    this.player.toggle();
  }

  /** What the hand holds, or else the present shape, becomes a pose. */
  keepShape(): void {
    if (this.drag) this.dragging.drop();
    else this.poses.add();
  }

  /** Keeps the hand's shape on the stage until the new dance has one for this frame, and then plays on if it did. */
  holdShape(frame: number, playOn: boolean): void {
    this.show.pin(frame);
    this.resume ||= playOn;
  }

  // The page

  select(id: string | null): void {
    if (id === this.selected) return;
    this.selected = id;
    this.show.points();
    this.emit("selection", undefined);
  }

  setPanel(panel: PanelName | null): void {
    this.panel = panel;
    this.viewport?.setMode(panel === "points" ? "points" : "pose");
    if (panel === "points" && this.model && this.document.points.length === 0) this.pairing.start();
    else if (panel !== "points") this.pairing.stop();
    if (panel === "points") void this.guesses.offer();
    this.show.points();
    this.emit("panel", undefined);
  }

  setLayout(layout: "side" | "overlay"): void {
    this.layout = layout;
    this.viewport?.setLayout(layout);
    this.emit("layout", undefined);
  }

  setHelp(help: boolean): void {
    if (help === this.help) return;
    this.help = help;
    this.emit("help", undefined);
  }

  setInsets(insets: Insets): void {
    this.viewport?.setInsets(insets);
  }
  fit(): void {
    this.viewport?.fit();
  }

  /** The first line has been understood. */
  endIntro(): void {
    if (!this.intro) return;
    this.intro = false;
    this.viewport?.pulse(null);
    this.emit("intro", undefined);
  }

  escape(): boolean {
    if (this.drag) this.dragging.cancel();
    else if (this.help) this.setHelp(false);
    else if (this.coverage.asking !== null) this.coverage.skip();
    else if (this.pins.armed) this.pins.arm(false);
    else if (this.pins.chosen) this.pins.choose(null);
    else if (this.pairing.waiting || this.pairing.adding) this.pairing.stop();
    else if (this.panel) this.setPanel(null);
    else if (this.selected) this.select(null);
    else return false;
    return true;
  }

  showFrame(): void {
    this.show.frame();
  }
  showPoints(): void {
    this.show.points();
  }

  private documentChanged(): void {
    if (this.selected && this.selected !== FLIGHTS && !this.document.points.some((point) => point.id === this.selected))
      this.selected = null;
    this.notices.outdate(this.document);
    this.coverage.follow();
    this.show.points();
    this.emit("document", undefined);
    this.emit("files", undefined);
    void this.workspace.sync();
  }

  private listenToWorkspace(): void {
    const { workspace } = this;
    const solved = (): void => this.emit("solve", undefined);
    workspace.on("mesh", () => {
      this.show.model();
      solved();
    });
    workspace.on("motion", () => {
      this.show.human();
      solved();
    });
    workspace.on("performance", (performance) => {
      if (performance) this.meter.add(performance.milliseconds);
      this.show.performance();
      this.pins.check();
      solved();
    });
    workspace.on("frame", (frame) => {
      if (frame !== this.player.frame) return;
      this.show.frame();
      if (this.resume) {
        this.resume = false;
        this.player.play();
      }
    });
    workspace.on("busy", (busy) => {
      this.solving = busy;
      solved();
      if (!busy) void this.thumbnails.update();
    });
    workspace.on("failed", (error) => this.notices.say({ bad: true, title: error.message, text: "The dance is as it was before." }));
    workspace.on("recovered", () =>
      this.notices.say({ title: "The solver had to be started again.", text: "Everything you made is still here." }),
    );
  }

  private listenToViewport(viewport: Viewport): void {
    viewport.on("point-grab", ({ id }) => this.dragging.grab(id));
    viewport.on("point-move", ({ position }) => this.dragging.move(position));
    viewport.on("point-drop", () => this.dragging.drop());
    viewport.on("point-cancel", () => this.dragging.cancel());
    viewport.on("point-reach", ({ near }) => {
      this.player.waiting = near;
    });
    viewport.on("point-pick", ({ id, on }) => this.pairing.pick(id, on));
    viewport.on("surface-pick", ({ vertex }) => this.pairing.surface(vertex));
    viewport.on("joint-pick", ({ joint }) => this.pairing.joint(joint));
    viewport.on("empty-pick", () => this.select(null));
    viewport.on("context-lost", () =>
      this.notices.say({ title: "Graphics were reset by the browser.", text: "Your work is here. The picture comes back by itself." }),
    );
    viewport.on("context-restored", () => {
      this.notices.dismissTitle("Graphics were reset by the browser.");
      this.show.everything();
    });
  }
}
