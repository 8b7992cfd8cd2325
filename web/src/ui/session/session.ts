// What the page is doing now: the document and its engine, the playhead, the hand, and what is said about it. The elements draw
// it and call it; it knows no element.

import * as commands from "../../document/commands";
import { DocumentStore } from "../../document/store";
import type { Command, Gesture } from "../../document/store";
import type { Axis, Example, ProjectDocument, Settings, Vec3 } from "../../document/types";
import { createBrowserEngine } from "../../engine/browser";
import type { MeshReport, Motion, Performance } from "../../engine/types";
import { Emitter } from "../../sync/emitter";
import { exampleControls, jointsOfPose, pointsOfControls } from "../../sync/prepare";
import type { SolverModel } from "../../sync/prepare";
import { Workspace } from "../../sync/workspace";
import type { Insets } from "../../viewport/types";
import { Viewport } from "../../viewport/viewport";
import { stem } from "../words";
import { Builtins } from "./builtins";
import { Dragging } from "./dragging";
import type { Drag } from "./dragging";
import { nextFacing, withUp } from "./facing";
import { Jobs } from "./jobs";
import { Meter } from "./meter";
import { Notices } from "./notices";
import { Opening } from "./opening";
import { Pairing } from "./pairing";
import { pickFiles } from "../pick-files";
import type { FileKind } from "../pick-files";
import { Player } from "./player";
import { Saving } from "./saving";
import { Show } from "./show";
import { Sources } from "./sources";
import { Thumbnails } from "./thumbnails";
import type { Verb } from "./verbs";

export interface SessionEvents {
  document: void;
  /** The frame to show. */
  frame: void;
  play: void;
  /** Mesh, motion or dance changed, or solving began or ended. */
  solve: void;
  selection: void;
  verb: void;
  layout: void;
  notices: void;
  jobs: void;
  thumbs: void;
  hello: void;
  help: void;
  meter: void;
  /** The hand took, moved or let go of a dot. */
  drag: void;
  pairing: void;
  /** Saved, or not any more. */
  files: void;
}

export interface MotionEntry {
  files: readonly string[];
  builtin: boolean;
}

const POSED = "You made a pose.";
const EMPTY = commands.newDocument("Untitled", { file: "", facing: "+z", up: "+y" }, { files: [] });

export class Session extends Emitter<SessionEvents> {
  readonly store = new DocumentStore(EMPTY);
  readonly workspace = new Workspace(() => this.store.document, createBrowserEngine);
  readonly player = new Player();
  readonly notices = new Notices();
  readonly jobs = new Jobs();
  readonly meter = new Meter(() => this.emit("meter", undefined));
  readonly thumbnails = new Thumbnails(this);
  readonly pairing = new Pairing(this);
  readonly builtins = new Builtins();
  private readonly dragging = new Dragging(this);
  readonly sources = new Sources(this.workspace.library);
  private readonly opening = new Opening(this, this.sources);
  private readonly saving = new Saving(this, this.sources);
  private readonly show = new Show(this);
  viewport: Viewport | null = null;
  selected: string | null = null;
  verb: Verb | null = null;
  layout: "side" | "overlay" = "side";
  hello = false;
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
    this.store.subscribe(() => this.documentChanged());
    this.player.on("frame", (frame) => {
      this.workspace.focus(frame);
      this.show.frame();
      this.emit("frame", undefined);
    });
    this.player.on("state", () => this.emit("play", undefined));
    this.notices.on("change", () => this.emit("notices", undefined));
    this.jobs.on("change", () => this.emit("jobs", undefined));
    this.listenToWorkspace();
  }

  /** Builds the stage in its host and begins with the cactus. */
  start(host: HTMLElement): void {
    this.viewport = new Viewport(host);
    this.listenToViewport(this.viewport);
    this.hello = true;
    this.emit("hello", undefined);
    void this.opening.builtin({ first: true });
  }

  close(): void {
    this.player.pause();
    this.workspace.close();
    this.viewport?.dispose();
  }

  // What is

  get document(): ProjectDocument { return this.store.document; }
  get motion(): Motion | null { return this.workspace.motion; }
  get performance(): Performance | null { return this.workspace.performance; }
  get report(): MeshReport | null { return this.workspace.report; }
  get drag(): Drag | null { return this.dragging.active; }
  get canUndo(): boolean { return this.store.canUndo; }
  get canRedo(): boolean { return this.store.canRedo; }
  get canExport(): boolean { return this.performance !== null; }
  get canPose(): boolean { return this.performance !== null; }
  get saved(): boolean { return this.document === this.savedDocument; }
  get model(): SolverModel | undefined { return this.workspace.library.model(this.document.mesh.file); }

  get modelName(): string {
    const name = stem(this.document.mesh.file);
    return name.charAt(0).toUpperCase() + name.slice(1);
  }

  /** Poses made on the motion that plays, by frame. */
  get posesHere(): readonly Example[] {
    return this.document.examples.filter((pose) => this.isHere(pose)).sort((a, b) => a.source.frame - b.source.frame);
  }

  isHere(pose: Example): boolean {
    return pose.source.motion === this.motionName;
  }

  get motionName(): string {
    return this.document.motion.files.at(-1) ?? "";
  }

  /** Built-in motions and those that were opened. */
  get motions(): readonly MotionEntry[] {
    const builtin = this.builtins.motions.map((file) => ({ files: [file], builtin: true }));
    const known = new Set(builtin.map((entry) => entry.files.join("\n")));
    const opened = this.workspace.library.motionFiles.filter((files) => !known.has(files.join("\n")));
    return [...builtin, ...opened.map((files) => ({ files, builtin: false }))];
  }

  /** C x 3 body-local: where a pose puts the points. */
  targetsOf(pose: Example): Float32Array | null {
    return this.model ? exampleControls(this.model, this.document, pose) : null;
  }

  // Changing the document

  apply(command: Command, gesture?: Gesture): void {
    this.touched = true;
    this.store.apply(command, gesture);
  }

  undo(): void {
    this.dragging.cancel();
    this.notices.dismissTitle(POSED);
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

  // Points

  /** A new point at a vertex of the model; answers its id. */
  addPoint(vertex: number): string | null {
    const { model } = this;
    if (!model || vertex < 0) return null;
    const [x, y, z] = model.positions.subarray(3 * vertex, 3 * vertex + 3);
    const position: Vec3 = [x, y, z];
    const taken = this.document.points.find((point) => point.position.every((value, k) => value === position[k]));
    if (taken) return taken.id;
    const id = commands.freeId(this.document.points, "p");
    this.apply(commands.addPoint({ id, name: `Point ${this.document.points.length + 1}`, position, joint: null }));
    this.select(id);
    return id;
  }

  renamePoint(id: string, name: string): void {
    if (name.trim() !== "") this.apply(commands.renamePoint(id, name.trim()));
    else this.emit("document", undefined);
  }

  pair(id: string, joint: string | null): void {
    this.apply(commands.pairPoint(id, joint));
  }

  deletePoint(id: string): void {
    const name = this.document.points.find((point) => point.id === id)?.name ?? "A point";
    this.apply(commands.removePoint(id));
    if (this.selected === id) this.select(null);
    if (this.pairing.waiting === id) this.pairing.setWaiting(null);
    this.notices.say({ title: `${name} is gone.`, text: "Poses forgot it too.", icon: "points", actions: [this.undoAction()] });
  }

  deleteSelected(): boolean {
    if (this.selected === null || this.drag) return false;
    this.deletePoint(this.selected);
    return true;
  }

  // Poses

  /** Makes what the hand holds an example at its frame; one that is there already changes. */
  keepPose(drag: Pick<Drag, "frame" | "targets" | "wasPlaying">): void {
    const { motion, model, document } = this;
    if (!motion || !model) return;
    const size = 3 * motion.joints.length;
    const joints = jointsOfPose(motion.joints, motion.local.subarray(drag.frame * size, (drag.frame + 1) * size));
    const points = pointsOfControls(model, document, drag.targets);
    const old = this.posesHere.find((pose) => pose.source.frame === drag.frame);
    this.show.pin(drag.frame);
    this.resume ||= drag.wasPlaying;
    if (old) this.apply(replaceExample({ ...old, joints, points }));
    else {
      const source = { motion: this.motionName, frame: drag.frame };
      this.apply(commands.addExample({ id: commands.freeId(document.examples, "e"), source, joints, points }));
    }
    this.notices.dismissTitle(POSED);
    const text = old ? `It took the place of the one at frame ${drag.frame}. The whole dance followed.` : "The whole dance followed.";
    this.notices.say({ title: POSED, text, icon: "poses", actions: [this.undoAction()] });
  }

  /** The present shape as a pose at this frame, or what the hand holds. */
  addPose(): void {
    const { performance, player } = this;
    if (this.drag) return this.dragging.drop();
    if (!performance) return;
    this.goodbye();
    this.keepPose({ frame: player.frame, targets: this.controlsAt(player.frame), wasPlaying: player.playing });
  }

  /** Moves a pose to this frame, with the human and the shape that are there. */
  updatePose(id: string): void {
    const pose = this.document.examples.find((example) => example.id === id);
    const { motion, model, player } = this;
    if (!pose || !motion || !model || !this.performance) return;
    const size = 3 * motion.joints.length;
    const joints = jointsOfPose(motion.joints, motion.local.subarray(player.frame * size, (player.frame + 1) * size));
    const points = pointsOfControls(model, this.document, this.controlsAt(player.frame));
    this.apply(replaceExample({ ...pose, source: { motion: this.motionName, frame: player.frame }, joints, points }));
  }

  deletePose(id: string): void {
    const pose = this.document.examples.find((example) => example.id === id);
    if (!pose) return;
    this.apply(commands.removeExample(id));
    this.notices.say({ title: `The pose at frame ${pose.source.frame} is gone.`, text: "The dance goes on without it.", icon: "poses", actions: [this.undoAction()] });
  }

  goToPose(id: string): void {
    const pose = this.document.examples.find((example) => example.id === id);
    if (!pose || !this.isHere(pose)) return;
    this.player.pause();
    this.player.seek(pose.source.frame);
  }

  /** The next pose before (-1) or after (1) the playhead, around the ends. */
  toPose(direction: 1 | -1): void {
    const poses = this.posesHere;
    const now = this.player.frame;
    const ahead = direction > 0 ? poses.find((p) => p.source.frame > now) ?? poses[0] : poses.findLast((p) => p.source.frame < now) ?? poses.at(-1);
    if (ahead) this.goToPose(ahead.id);
  }

  private controlsAt(frame: number): Float32Array {
    const size = 3 * this.document.points.length;
    return this.performance?.controls.slice(frame * size, (frame + 1) * size) ?? new Float32Array(size);
  }

  undoAction() {
    const before = this.document;
    return { label: "Undo", run: () => { if (this.document === before) this.undo(); } };
  }

  // Files

  pickFiles(kind: FileKind = "any"): void {
    void pickFiles(kind).then((files) => { if (files.length > 0) return this.openFiles(files); });
  }

  openFiles(files: readonly File[]): Promise<void> { return this.opening.files(files); }
  openBuiltin(): void { void this.opening.builtin({ first: false }); }
  useMotion(entry: MotionEntry): void { void this.opening.useMotion(entry); }
  save(): Promise<void> { return this.saving.save(); }
  exportModel(): void { void this.saving.exportModel(); }

  markSaved(): void {
    this.savedDocument = this.document;
    this.emit("files", undefined);
  }

  get otherDance(): string {
    return `Try a ${stem(this.otherMotion())}`;
  }

  tryOtherDance(): void {
    this.useMotion({ files: [this.otherMotion()], builtin: true });
  }

  private otherMotion(): string {
    return this.builtins.motions.find((file) => file !== this.motionName) ?? this.motionName;
  }

  // The page

  select(id: string | null): void {
    if (id === this.selected) return;
    this.selected = id;
    this.show.dots();
    this.emit("selection", undefined);
  }

  setVerb(verb: Verb | null): void {
    this.verb = verb;
    this.viewport?.setMode(verb === "points" ? "points" : "pose");
    if (verb === "points" && this.model && this.document.points.length === 0) this.pairing.start();
    else if (verb !== "points") this.pairing.stop();
    this.emit("verb", undefined);
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

  setInsets(insets: Insets): void { this.viewport?.setInsets(insets); }
  fit(): void { this.viewport?.fit(); }

  /** The first line has been understood. */
  goodbye(): void {
    if (!this.hello) return;
    this.hello = false;
    this.viewport?.pulse(null);
    this.emit("hello", undefined);
  }

  escape(): boolean {
    if (this.drag) this.dragging.cancel();
    else if (this.help) this.setHelp(false);
    else if (this.pairing.waiting || this.pairing.adding) this.pairing.stop();
    else if (this.verb) this.setVerb(null);
    else if (this.selected) this.select(null);
    else return false;
    return true;
  }

  /** Arrow keys on a point of the list move it by 1 cm, with Shift by 2 mm. */
  nudgeKey(id: string, event: KeyboardEvent): void {
    const by = event.shiftKey ? 0.002 : 0.01;
    const way: Record<string, readonly [number, number, number]> = {
      ArrowLeft: [-by, 0, 0], ArrowRight: [by, 0, 0], ArrowUp: [0, by, 0], ArrowDown: [0, -by, 0],
    };
    const delta = way[event.key];
    if (!delta) return;
    event.preventDefault();
    this.dragging.nudge(id, delta);
  }

  showFrame(): void { this.show.frame(); }

  private documentChanged(): void {
    if (this.selected && !this.document.points.some((point) => point.id === this.selected)) this.selected = null;
    this.show.dots();
    this.emit("document", undefined);
    this.emit("files", undefined);
    void this.workspace.sync();
  }

  private listenToWorkspace(): void {
    const { workspace } = this;
    const solved = (): void => this.emit("solve", undefined);
    workspace.on("mesh", () => { this.show.model(); solved(); });
    workspace.on("motion", () => { this.show.human(); solved(); });
    workspace.on("performance", (performance) => {
      if (performance) this.meter.add(performance.milliseconds);
      this.show.performance();
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
    workspace.on("recovered", () => this.notices.say({ title: "The solver had to be started again.", text: "Everything you made is still here." }));
  }

  private listenToViewport(viewport: Viewport): void {
    viewport.on("dot-grab", ({ id }) => this.dragging.grab(id));
    viewport.on("dot-move", ({ position }) => this.dragging.move(position));
    viewport.on("dot-drop", () => this.dragging.drop());
    viewport.on("dot-cancel", () => this.dragging.cancel());
    viewport.on("dot-pick", ({ id, on }) => this.pairing.dot(id, on));
    viewport.on("surface-pick", ({ vertex }) => this.pairing.surface(vertex));
    viewport.on("joint-pick", ({ joint }) => this.pairing.joint(joint));
    viewport.on("empty-pick", () => this.select(null));
    viewport.on("context-lost", () => this.notices.say({ title: "Graphics were reset by the browser.", text: "Your work is here. The picture comes back by itself." }));
    viewport.on("context-restored", () => {
      this.notices.dismissTitle("Graphics were reset by the browser.");
      this.show.everything();
    });
  }
}

function replaceExample(example: Example): Command {
  return (document) => ({ ...document, examples: document.examples.map((old) => (old.id === example.id ? example : old)) });
}
