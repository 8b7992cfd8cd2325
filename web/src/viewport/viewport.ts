// The stage as one object: keeps figures, marks, camera and hand together and draws only when something changed.

import { Vector3 } from "three";
import { CameraRig, type Projected } from "./camera-rig";
import { DotHand } from "./dot-hand";
import { dotColour, type DotHit, type DotMark, DotOverlay } from "./dot-overlay";
import { Emitter } from "../sync/emitter";
import type { Point } from "./arc";
import { jointLabel } from "./joint-names";
import { Mannequin } from "./mannequin";
import { ModelFigure } from "./model-figure";
import { overlayStyle } from "./overlay-style";
import { type PairLine, PairLines } from "./pair-lines";
import { Pointer } from "./pointer";
import { HUMAN_WIDTH, Stage } from "./stage";
import { SurfacePicker } from "./surface-picker";
import { QualityGovernor } from "./quality";
import { readTheme, type Theme } from "./theme";
import { Thumbnails } from "./thumbnail";
import type { Dot, DrawnHuman, DrawnModel, Insets, ViewMode, ViewportApi, ViewportEvents } from "./types";

const DOT_REACH = { mouse: 14, touch: 24 };
const JOINT_REACH = { mouse: 22, touch: 32 };
/** Milliseconds between two looks at which dots the mesh hides. */
const OCCLUSION_PAUSE = 120;

export class Viewport implements ViewportApi {
  private readonly root = document.createElement("div");
  private readonly events = new Emitter<ViewportEvents>();
  private readonly stage: Stage;
  private readonly rig: CameraRig;
  private readonly overlay = new DotOverlay();
  private readonly lines = new PairLines();
  private readonly hand: DotHand;
  private readonly pointer: Pointer;
  private readonly thumbnails: Thumbnails;
  private readonly observer: ResizeObserver;
  private readonly abort = new AbortController();
  private readonly governor: QualityGovernor;
  private theme: Theme;
  private figure: ModelFigure | null = null;
  private picker: SurfacePicker | null = null;
  private mannequin: Mannequin | null = null;
  private human: DrawnHuman | null = null;
  private nextVertices: Float32Array | null = null;
  private nextPose: Float32Array | null = null;
  private ghost: Float32Array | null = null;
  private dots: readonly Dot[] = [];
  private selected: string | null = null;
  private mode: ViewMode = "pose";
  private live: { id: string } | { joint: number } | null = null;
  private insets: Insets = { left: 0, top: 0, right: 0, bottom: 0 };
  private size = { width: 1, height: 1 };
  private hovered: Point | null = null;
  private pressed: DotHit | null = null;
  private note = "";
  private frame = 0;
  private before = 0;
  private pictureStale = true;
  private occlusionStale = true;
  private occlusionTime = 0;
  private occlusionTimer = 0;
  private lost = false;
  private readonly world = new Vector3();
  private readonly direction = new Vector3();
  private readonly spot: Projected = { x: 0, y: 0, depth: 0 };

  constructor(host: HTMLElement) {
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const shadow = this.root.attachShadow({ mode: "open" });
    shadow.adoptedStyleSheets = [overlayStyle()];
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    shadow.append(canvas, this.lines.element, this.overlay.element);
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.append(this.root);

    this.stage = new Stage(canvas, still);
    this.governor = new QualityGovernor(this.stage.rendererName());
    this.stage.setQuality(this.governor.quality);
    this.rig = new CameraRig(this.root, still, () => this.invalidate());
    this.hand = new DotHand(this.events, this.rig, this.stage.model.offset);
    this.thumbnails = new Thumbnails(this.stage.renderer);
    this.theme = readTheme(shadow);
    this.refreshTheme();
    this.pointer = new Pointer(this.root, {
      press: (at, touch) => this.press(at, touch),
      dragStart: () => this.startDrag(),
      drag: (dx, dy, shift) => {
        this.hand.drag(dx, dy, shift);
        this.touchOverlay();
      },
      dragEnd: (cancelled) => this.endDrag(cancelled),
      click: (at, touch) => this.click(at, touch),
      hover: (at) => this.hover(at),
      setPanning: (on) => this.rig.setPanning(on),
      setCamera: (enabled) => {
        this.rig.controls.enabled = enabled;
        if (enabled) this.pressed = null;
      },
    });
    this.listenToMarks();
    this.listenToContext(canvas);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
    this.fit();
  }

  on<K extends keyof ViewportEvents>(name: K, listener: (detail: ViewportEvents[K]) => void): () => void {
    return this.events.on(name, listener);
  }

  setModel(model: DrawnModel | null): void {
    const { model: lane } = this.stage;
    if (this.figure) lane.group.remove(this.figure.group);
    this.figure?.dispose();
    this.picker?.dispose();
    this.hand.letGo(true);
    this.figure = model && new ModelFigure(model);
    this.picker = this.figure && model && new SurfacePicker(this.figure.rest, model.faces);
    this.thumbnails.setModel(this.figure);
    this.nextVertices = this.figure?.rest ?? null;
    this.ghost = null;
    if (this.figure) lane.group.add(this.figure.group);
    lane.shadow.mesh.visible = this.figure !== null;
    this.stage.setWidth(lane, this.figure ? modelWidth(this.figure.rest) : 0);
    this.figure?.setViewSize(this.size.width, this.size.height);
    this.invalidate();
  }

  setVertices(positions: Float32Array): void {
    this.nextVertices = positions;
    this.invalidate();
  }

  setHuman(human: DrawnHuman | null): void {
    const { human: lane } = this.stage;
    if (this.mannequin) lane.group.remove(this.mannequin.group);
    this.mannequin?.dispose();
    this.human = human;
    this.mannequin = human && new Mannequin(human);
    this.nextPose = null;
    if (this.mannequin) lane.group.add(this.mannequin.group);
    this.dressHuman();
    lane.shadow.mesh.visible = false; // until there is a pose
    this.stage.setWidth(lane, human ? HUMAN_WIDTH : 0);
    this.setDots(this.dots, this.selected);
  }

  setHumanPose(positions: Float32Array): void {
    this.nextPose = positions;
    this.invalidate();
  }

  setDots(dots: readonly Dot[], selected: string | null): void {
    this.dots = dots;
    this.selected = selected;
    this.overlay.setDots(dots, selected, (joint) => jointLabel(this.human?.names[joint] ?? "joint"));
    this.occlusionStale = true;
    this.touchOverlay();
  }

  /** Two rings around a dot, for a first visit; null stops them. */
  pulse(id: string | null): void {
    this.overlay.pulse(id);
  }

  setMode(mode: ViewMode): void {
    this.mode = mode;
    this.touchOverlay();
  }

  setGhost(positions: Float32Array | null): void {
    this.ghost = positions;
    this.figure?.setGhost(positions, this.theme);
    this.figure?.setViewSize(this.size.width, this.size.height);
    this.invalidate();
  }

  setLivePair(from: { id: string } | { joint: number } | null): void {
    this.live = from;
    this.touchOverlay();
  }

  /** A second line on the tag of the dot in the hand, such as the volume; "" for none. */
  setNote(words: string): void {
    this.note = words;
    this.touchOverlay();
  }

  setInsets(insets: Insets): void {
    this.insets = { ...insets };
    this.overlay.insets = this.insets;
    this.rig.setView({ ...this.size, insets: this.insets });
    this.invalidate();
  }

  setLayout(layout: "side" | "overlay"): void {
    this.stage.setOverlay(layout === "overlay");
    this.dressHuman();
    this.rig.setContent(this.stage.content);
    this.invalidate();
  }

  fit(): void {
    this.rig.fit();
    this.invalidate();
  }

  thumbnail(positions: Float32Array, size: number): string {
    if (this.lost) return "";
    const url = this.thumbnails.draw(positions, size);
    // The canvas now shows the little picture: draw the stage again before this task ends.
    if (!this.pictureStale) queueMicrotask(() => this.pictureStale && this.draw());
    this.pictureStale = true;
    return url;
  }

  refreshTheme(): void {
    this.theme = readTheme(this.root.shadowRoot ?? this.root);
    this.stage.setTheme(this.theme);
    this.figure?.setTheme(this.theme);
    this.dressHuman();
    this.thumbnails.setDark(this.theme.dark);
    this.invalidate();
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.occlusionTimer);
    this.lost = true; // nothing draws any more
    this.abort.abort();
    this.observer.disconnect();
    this.pointer.dispose();
    this.rig.dispose();
    this.thumbnails.dispose();
    this.figure?.dispose();
    this.picker?.dispose();
    this.mannequin?.dispose();
    this.stage.dispose();
    this.root.remove();
  }

  private dressHuman(): void {
    this.mannequin?.setSeenThrough(this.stage.overlay, this.theme.stage);
  }

  // Drawing

  private invalidate(): void {
    this.pictureStale = true;
    this.touchOverlay();
  }

  /** The marks changed, not the picture under them. */
  private touchOverlay(): void {
    if (this.frame) return;
    const asked = performance.now();
    this.frame = requestAnimationFrame((now) => {
      this.frame = 0;
      if (this.pictureStale && this.governor.note(performance.now() - asked)) this.applyQuality();
      this.tick(now);
    });
  }

  private applyQuality(): void {
    this.stage.setQuality(this.governor.quality);
    this.stage.resize(this.size.width, this.size.height, this.pixelRatio());
  }

  private pixelRatio(): number {
    return Math.min(window.devicePixelRatio || 1, this.governor.quality.maxPixelRatio);
  }

  private tick(now: number): void {
    const seconds = Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    this.takeShapes();
    const following = this.stage.follow(seconds, this.hand.holding);
    const moving = this.rig.update(seconds);
    if (following || moving) {
      this.occlusionStale = true;
      this.invalidate();
    }
    this.updateMarks(now);
    if (this.pictureStale || following || moving) this.draw();
  }

  private draw(): void {
    if (this.lost) return;
    this.stage.render(this.rig.camera, this.rig.controls.distance);
    this.pictureStale = false;
  }

  private takeShapes(): void {
    const { nextVertices, nextPose, stage } = this;
    if (nextVertices && this.figure && nextVertices.length >= this.figure.rest.length) {
      this.figure.setVertices(nextVertices);
      this.picker?.setVertices(nextVertices);
      this.hand.settle();
      standOn(stage.model, nextVertices);
    }
    if (nextPose && this.mannequin) {
      this.mannequin.setPose(nextPose);
      stage.human.ground.set(nextPose[0]!, nextPose[2]!);
      stage.human.top = this.mannequin.top();
      stage.human.shadow.mesh.visible = true;
      this.mannequin.darken(stage.human.shadow);
    }
    this.nextVertices = this.nextPose = null;
    if (!nextVertices && !nextPose) return;
    this.occlusionStale = true;
    stage.arrange();
    if (!this.hand.holding) this.rig.setContent(stage.content); // nothing moves under the hand
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width < 1 || height < 1) return;
    this.size = { width, height };
    this.stage.resize(width, height, this.pixelRatio());
    this.rig.setView({ width, height, insets: this.insets });
    this.figure?.setViewSize(width, height);
    // A resized canvas is blank: draw in the same frame, or it flickers.
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.pictureStale = true;
    this.tick(performance.now());
  }

  // Marks

  private updateMarks(now: number): void {
    for (const mark of this.overlay.marks) this.rig.project(this.markPosition(mark, this.world), mark.at);
    this.lookForHidden(now);
    if (this.hovered) this.overlay.setHover(this.overlay.nearest(this.hovered.x, this.hovered.y, DOT_REACH.mouse)); // dots move under it
    this.overlay.place();
    this.lines.setLines(this.pairLines());
    this.updateTag();
  }

  /** Scene position. */
  private markPosition(mark: DotMark, out: Vector3): Vector3 {
    if (mark.on === "human") return this.jointPosition(mark.dot.joint, out);
    return this.dotPosition(mark.dot, out).add(this.stage.model.offset);
  }

  /** Model world: on the surface, or where the hand asks it to be. */
  private dotPosition(dot: Dot, out: Vector3): Vector3 {
    if (dot.id === this.hand.id) return out.copy(this.hand.target);
    return this.figure ? out.fromArray(this.figure.vertices, 3 * dot.vertex) : out.set(0, 0, 0);
  }

  private jointPosition(joint: number, out: Vector3): Vector3 {
    if (!this.mannequin?.pose) return out.set(0, 0, 1e4); // behind the camera: not shown
    return this.mannequin.seen(joint, out).add(this.stage.human.offset);
  }

  /** Rays cost a refit of the tree, so while things move they are cast a few times a second. */
  private lookForHidden(now: number): void {
    if (!this.occlusionStale || !this.picker) return;
    if (now - this.occlusionTime < OCCLUSION_PAUSE) {
      this.occlusionTimer ||= window.setTimeout(() => {
        this.occlusionTimer = 0;
        this.touchOverlay();
      }, OCCLUSION_PAUSE);
      return;
    }
    this.occlusionTime = now;
    this.occlusionStale = false;
    const eye = this.rig.camera.position.clone().sub(this.stage.model.offset);
    for (const mark of this.overlay.marks) {
      if (mark.on === "human") continue;
      const distance = this.direction.subVectors(this.dotPosition(mark.dot, this.world), eye).length();
      mark.behind = mark.id !== this.hand.id && this.picker.hides(eye, this.direction.divideScalar(distance), distance);
    }
  }

  private pairLines(): PairLine[] {
    const hovered = this.overlay.hoveredPair();
    const lines: PairLine[] = [];
    for (const dot of this.dots) {
      if (this.mode !== "points" && dot.id !== hovered) continue;
      const from = this.overlay.find(dot.id, "human");
      const to = this.overlay.find(dot.id, "model");
      if (!from || !to || from.button.hidden || to.button.hidden) continue;
      lines.push({ from: from.at, to: to.at, colour: dotColour(dot.number), kind: dot.guess ? "guess" : "pair" });
    }
    if (this.live && this.hovered) {
      const mark = "id" in this.live ? this.overlay.find(this.live.id, "model") : null;
      const from = "joint" in this.live ? this.rig.project(this.jointPosition(this.live.joint, this.world), { x: 0, y: 0, depth: 0 }) : mark?.at;
      if (from) lines.push({ from, to: this.hovered, colour: mark ? dotColour(mark.dot.number) : "var(--pencil, #166e94)", kind: "live" });
    }
    return lines;
  }

  private updateTag(): void {
    const mark = this.overlay.named();
    const { hand } = this;
    if (hand.holding && mark) {
      const start = this.rig.project(this.holdStart(mark.dot, this.world), this.spot);
      this.lines.setLead(start, mark.at);
      this.lines.setProbe(start);
      this.overlay.showTag(this.holdWords(mark.dot), mark.at, 26);
      return;
    }
    this.lines.setLead(null, null);
    const candidate = mark || this.mode !== "points" || !this.hovered ? null : this.candidate(this.hovered);
    this.lines.setProbe(candidate?.at ?? null);
    if (mark) this.overlay.showTag(mark.dot.name, mark.at, mark.on === "model" ? 24 : 18);
    else this.overlay.showTag(candidate?.words ?? null, candidate?.at ?? null, 14);
  }

  /** Scene position that the lead starts from: on the ghost if one shows, else where the hand took the dot. */
  private holdStart(dot: Dot, out: Vector3): Vector3 {
    if (this.ghost) out.fromArray(this.ghost, 3 * dot.vertex);
    else out.copy(this.hand.origin);
    return out.add(this.stage.model.offset);
  }

  /** "Top: 27 cm up, 31 cm right", as the camera sees it. */
  private holdWords(dot: Dot): string {
    const start = this.holdStart(dot, this.world).sub(this.stage.model.offset);
    const move = this.direction.subVectors(this.hand.target, start);
    const matrix = this.rig.camera.matrixWorld;
    const part = (value: number, plus: string, minus: string): string | null => {
      const cm = Math.round(100 * Math.abs(value));
      return cm > 0 ? `${cm} cm ${value > 0 ? plus : minus}` : null;
    };
    const right = move.dot(this.world.setFromMatrixColumn(matrix, 0));
    const back = move.dot(this.world.setFromMatrixColumn(matrix, 2).setY(0).normalize());
    const words = [part(move.y, "up", "down"), part(right, "right", "left"), part(back, "out", "in")].filter(Boolean).slice(0, 2);
    return [words.length ? `${dot.name}: ${words.join(", ")}` : dot.name, this.note].filter(Boolean).join("\n");
  }

  /** What a click would pick while points are made: a joint, else a vertex. */
  private candidate(at: Point): { at: Projected; words: string | null } | null {
    const joint = this.jointAt(at, JOINT_REACH.mouse);
    if (joint >= 0) {
      const place = this.rig.project(this.jointPosition(joint, this.world), { ...this.spot });
      return { at: place, words: jointLabel(this.human?.names[joint] ?? "") };
    }
    const vertex = this.vertexAt(at);
    if (vertex < 0 || !this.figure) return null;
    this.world.fromArray(this.figure.vertices, 3 * vertex).add(this.stage.model.offset);
    return { at: this.rig.project(this.world, { ...this.spot }), words: null };
  }

  // Input

  private press(at: Point, touch: boolean): boolean {
    this.pressed = this.overlay.nearest(at.x, at.y, touch ? DOT_REACH.touch : DOT_REACH.mouse);
    if (!this.live) this.hovered = null; // until it is up again
    this.overlay.setHover(null);
    const mark = this.pressed && this.overlay.find(this.pressed.id, this.pressed.on);
    if (mark) this.overlay.press(mark);
    const drags = mark !== null && mark.on === "model" && this.mode === "pose";
    this.root.style.cursor = drags ? "grabbing" : "";
    return drags;
  }

  private startDrag(): void {
    const mark = this.pressed && this.overlay.find(this.pressed.id, "model");
    if (!mark) return;
    this.hand.grab(mark.id, this.dotPosition(mark.dot, this.world));
    this.overlay.setHeld(mark.id);
  }

  private endDrag(cancelled: boolean): void {
    this.hand.letGo(cancelled);
    this.overlay.setHeld(null);
    this.note = "";
    this.root.style.cursor = "";
    this.invalidate();
  }

  private click(at: Point, touch: boolean): void {
    const hit = this.overlay.nearest(at.x, at.y, touch ? DOT_REACH.touch : DOT_REACH.mouse);
    if (hit) return this.events.emit("dot-pick", hit);
    if (this.mode === "points") {
      const joint = this.jointAt(at, touch ? JOINT_REACH.touch : JOINT_REACH.mouse);
      if (joint >= 0) return this.events.emit("joint-pick", { joint });
      const vertex = this.vertexAt(at);
      if (vertex >= 0) return this.events.emit("surface-pick", { vertex });
    }
    this.events.emit("empty-pick", {});
  }

  private hover(at: Point | null): void {
    this.hovered = at;
    const hit = at && this.overlay.nearest(at.x, at.y, DOT_REACH.mouse);
    const changed = this.overlay.setHover(hit);
    this.root.style.cursor = !hit ? "" : hit.on === "model" && this.mode === "pose" ? "grab" : "pointer";
    if (changed || this.live || this.mode === "points") this.touchOverlay();
  }

  private jointAt(at: Point, reach: number): number {
    let best = -1;
    let least = reach;
    for (const joint of this.mannequin?.plan.joints ?? []) {
      const { x, y, depth } = this.rig.project(this.jointPosition(joint, this.world), this.spot);
      const away = Math.hypot(x - at.x, y - at.y);
      if (depth > 0 && away < least) {
        best = joint;
        least = away;
      }
    }
    return best;
  }

  private vertexAt(at: Point): number {
    if (!this.picker) return -1;
    const { camera } = this.rig;
    this.world.set((2 * at.x) / this.size.width - 1, 1 - (2 * at.y) / this.size.height, 0.5).unproject(camera);
    const direction = this.direction.subVectors(this.world, camera.position).normalize();
    return this.picker.vertexAt(this.world.copy(camera.position).sub(this.stage.model.offset), direction);
  }

  private listenToMarks(): void {
    const { element } = this.overlay;
    const { signal } = this.abort;
    const owner = (event: Event): DotMark | null => this.overlay.owner(event.target);
    element.addEventListener("keydown", (event) => {
      const mark = owner(event);
      if (!mark || mark.on !== "model" || this.mode !== "pose") return;
      if (!this.hand.keyDown(event, mark.id, this.dotPosition(mark.dot, this.world).clone())) return;
      event.preventDefault();
      event.stopPropagation();
      this.overlay.setHeld(this.hand.holding ? mark.id : null);
      this.touchOverlay();
    }, { signal });
    const end = (stop: () => void): void => {
      stop();
      if (!this.hand.holding) this.overlay.setHeld(null);
      this.touchOverlay();
    };
    element.addEventListener("keyup", (event) => end(() => this.hand.keyUp(event.key)), { signal });
    element.addEventListener("focusout", () => end(() => this.hand.endKeys()), { signal });
    element.addEventListener("focusin", () => this.touchOverlay(), { signal });
    // Enter, Space and assistive technology; a pointer's click comes through the pointer.
    element.addEventListener("click", (event) => {
      const mark = owner(event);
      if (mark && event.detail === 0) this.events.emit("dot-pick", { id: mark.id, on: mark.on });
    }, { signal });
  }

  private listenToContext(canvas: HTMLCanvasElement): void {
    const { signal } = this.abort;
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.lost = true;
      this.events.emit("context-lost", {});
    }, { signal });
    canvas.addEventListener("webglcontextrestored", () => {
      this.lost = false;
      this.stage.arrange();
      this.invalidate();
      this.events.emit("context-restored", {});
    }, { signal });
  }
}

/** Wide enough for the model to turn a little. */
function modelWidth(rest: Float32Array): number {
  const extent = (axis: number): number => {
    let low = Infinity;
    let high = -Infinity;
    for (let i = axis; i < rest.length; i += 3) {
      low = Math.min(low, rest[i]!);
      high = Math.max(high, rest[i]!);
    }
    return Math.max(0, high - low);
  };
  return Math.max(0.6, extent(0), 0.8 * extent(2));
}

/** Finds where a model is and darkens the ground under its lowest vertices. */
function standOn(lane: Stage["model"], vertices: Float32Array): void {
  const { ground, shadow } = lane;
  const count = vertices.length / 3;
  let x = 0;
  let z = 0;
  lane.top = 0;
  for (let v = 0; v < vertices.length; v += 3) {
    x += vertices[v]!;
    lane.top = Math.max(lane.top, vertices[v + 1]!);
    z += vertices[v + 2]!;
  }
  ground.set(x / count, z / count);
  shadow.begin(ground.x, ground.y);
  for (let v = 0; v < vertices.length; v += 3) shadow.add(vertices[v]!, vertices[v + 1]!, vertices[v + 2]!, 0);
  shadow.end();
}
