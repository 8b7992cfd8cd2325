// The stage as one object: keeps figures, marks, camera and hand together and draws only when something changed.

import type {
  CompanionPort,
  DrawnHuman,
  DrawnModel,
  Insets,
  PointMark,
  Shape,
  StageEvents,
  StageLook,
  StagePort,
  StageView,
} from "../stage/port";
import type { Studio } from "../stage/studio";
import { Emitter } from "../util/emitter";
import { Annotations } from "./annotations";
import { CameraRig } from "./camera-rig";
import type { StageCompanion } from "./companion";
import { PointHand } from "./point-hand";
import { Figures } from "./figures";
import { Interaction } from "./interaction";
import { overlayStyle } from "./overlay-style";
import { QualityGovernor } from "./quality";
import { Scenery } from "./scenery";
import { readTheme, type Theme } from "./theme";
import { ThumbnailPainter } from "./thumbnail-painter";

export class Viewport implements StagePort {
  private readonly root = document.createElement("div");
  private readonly shadow = this.root.attachShadow({ mode: "open" });
  private readonly events = new Emitter<StageEvents>();
  readonly scenery: Scenery;
  readonly rig: CameraRig;
  readonly figures: Figures;
  private readonly hand: PointHand;
  private readonly annotations: Annotations;
  private readonly interaction: Interaction;
  private readonly thumbnails: ThumbnailPainter;
  private readonly governor: QualityGovernor;
  private readonly observer: ResizeObserver;
  private readonly abort = new AbortController();
  private points: readonly PointMark[] = [];
  private selected: string | null = null;
  private movedAt = -Infinity;
  /** Once somebody danced beside the model. */
  beside: StageCompanion | null = null;
  private insets: Insets = { left: 0, top: 0, right: 0, bottom: 0 };
  private size = { width: 1, height: 1 };
  /** The picture that is due. */
  frame = 0;
  private before = 0;
  private pictureStale = true;
  private lost = false;

  constructor(host: HTMLElement) {
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.append(this.root);

    const theme = readTheme(this.shadow);
    this.scenery = new Scenery(canvas, still);
    this.governor = new QualityGovernor(this.scenery.rendererName());
    this.scenery.setQuality(this.governor.quality);
    this.rig = new CameraRig(this.root, still, () => this.invalidate());
    this.hand = new PointHand(this.events, this.rig, this.scenery.model.offset);
    this.figures = new Figures(this.scenery, theme);
    this.annotations = new Annotations(this.scenery, this.rig, this.figures, this.hand, () => this.refreshMarks());
    this.thumbnails = new ThumbnailPainter(this.scenery.renderer);
    this.shadow.adoptedStyleSheets = [overlayStyle()];
    this.shadow.append(canvas, this.annotations.lines.element, this.annotations.overlay.element);
    this.paint(theme);

    this.interaction = new Interaction(
      this.root,
      this.rig,
      this.hand,
      this.annotations,
      this.events,
      () => this.refreshMarks(),
      () => performance.now() - this.movedAt < 1200,
    );
    this.listenToContext(canvas);
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", () => this.paint(readTheme(this.shadow)), { signal: this.abort.signal });
    this.listenForHand();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
    this.fit();
  }

  on<K extends keyof StageEvents>(name: K, listener: (detail: StageEvents[K]) => void): () => void {
    return this.events.on(name, listener);
  }

  async setModel(model: DrawnModel | null): Promise<void> {
    this.hand.letGo(true);
    const dressed = this.figures.setModel(model);
    this.thumbnails.setModel(null);
    this.invalidate();
    if (!(await dressed) || this.lost) return;
    this.thumbnails.setModel(this.figures.model);
    this.invalidate();
  }

  setShape(shape: Shape): void {
    this.figures.setShape(shape);
    this.movedAt = performance.now();
    this.invalidate();
  }

  setHuman(human: DrawnHuman | null): void {
    this.figures.setHuman(human);
    this.setPoints(this.points, this.selected); // their names hold joints' names
    this.invalidate();
  }

  setHumanPose(positions: Float32Array): void {
    this.figures.setPose(positions);
    this.invalidate();
  }

  setPoints(points: readonly PointMark[], selected: string | null): void {
    this.points = points;
    this.selected = selected;
    this.annotations.setPoints(points, selected);
    this.refreshMarks();
  }

  /** The clip began again: the figures go on from where they are, on ground that goes on under them. */
  beginAgain(): void {
    this.scenery.beginAgain();
  }

  setLook({ mode, layout, pulse, livePair, turning, asking, ghost, note }: Partial<StageLook>): void {
    const { annotations, figures } = this;
    if (mode !== undefined) annotations.mode = mode;
    if (livePair !== undefined) annotations.live = livePair;
    if (turning !== undefined) this.rig.turning = turning;
    if (note !== undefined) annotations.note = note;
    if (pulse !== undefined) annotations.overlay.pulse(pulse);
    if (asking !== undefined) figures.setAsking(asking);
    if (ghost !== undefined) figures.setGhost(ghost);
    if (layout !== undefined) this.setLayout(layout);
    if (asking === undefined && ghost === undefined && layout === undefined) this.refreshMarks();
    else this.invalidate();
  }

  setInsets(insets: Insets): void {
    this.insets = { ...insets };
    this.annotations.overlay.insets = this.insets;
    this.rig.setView({ ...this.size, insets: this.insets });
    this.invalidate();
  }

  fit(view?: StageView): void {
    this.rig.fit(view);
    this.invalidate();
  }

  thumbnail(shape: Shape, size: number): string {
    if (this.lost) return "";
    const url = this.thumbnails.draw(shape, size);
    // The canvas now shows the little picture. A slow machine may present it before the next tick: draw the stage again at once.
    const stale = this.pictureStale;
    this.draw();
    this.pictureStale = stale;
    return url;
  }

  async companion(): Promise<CompanionPort> {
    return (this.beside = new (await import("./companion")).StageCompanion(this));
  }

  async studio(): Promise<Studio> {
    return new (await import("./studio")).StageStudio(this);
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.lost = true; // nothing draws any more
    this.abort.abort();
    this.observer.disconnect();
    this.interaction.dispose();
    this.rig.dispose();
    this.annotations.dispose();
    this.thumbnails.dispose();
    this.figures.dispose();
    this.scenery.dispose();
    this.root.remove();
  }

  // Drawing

  private setLayout(layout: StageLook["layout"]): void {
    if (this.scenery.overlay === (layout === "overlay")) return;
    this.scenery.setOverlay(layout === "overlay");
    this.figures.dressHuman();
    this.rig.setContent(this.scenery.content);
  }

  invalidate(): void {
    this.pictureStale = true;
    this.refreshMarks();
  }

  /** The marks changed, not the picture under them. */
  private refreshMarks(): void {
    if (this.frame) return;
    const asked = performance.now();
    this.frame = requestAnimationFrame((now) => {
      this.frame = 0;
      if (this.pictureStale && this.governor.note(performance.now() - asked)) {
        this.scenery.setQuality(this.governor.quality);
        this.scenery.resize(this.size.width, this.size.height, this.pixelRatio());
      }
      this.tick(now);
    });
  }

  private tick(now: number): void {
    const seconds = Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    this.takeShapes();
    const following = this.scenery.follow(seconds, this.hand.holding);
    const turning = this.rig.update(seconds);
    if (following || turning) {
      this.annotations.occlusionStale = true;
      this.invalidate();
    }
    this.annotations.update(now);
    if (this.pictureStale) this.draw();
    if (following || turning) this.invalidate();
  }

  private draw(): void {
    if (this.lost) return;
    this.scenery.render(this.rig.camera, this.rig.controls.distance);
    this.pictureStale = false;
  }

  private takeShapes(): void {
    const { surface, pose } = this.figures.take();
    if (!surface && !pose) return;
    if (surface) this.hand.settle();
    this.annotations.occlusionStale = true;
    this.scenery.arrange();
    if (!this.hand.holding) this.rig.setContent(this.scenery.content); // nothing moves under the hand
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width < 1 || height < 1) return;
    this.size = { width, height };
    this.scenery.resize(width, height, this.pixelRatio());
    this.rig.setView({ width, height, insets: this.insets });
    this.figures.setViewSize(width, height);
    this.annotations.setSize(width, height);
    // A resized canvas is blank: draw in the same frame, or it flickers.
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.pictureStale = true;
    this.tick(performance.now());
  }

  private pixelRatio(): number {
    return Math.min(window.devicePixelRatio || 1, this.governor.quality.maxPixelRatio);
  }

  private paint(theme: Theme): void {
    this.scenery.setTheme(theme);
    this.figures.setTheme(theme);
    this.thumbnails.setDark(theme.dark);
    this.invalidate();
  }

  /** Nothing asks what lies under the pointer, or what hides a dot, before there is a hand. */
  private listenForHand(): void {
    const hand = new AbortController();
    for (const name of ["pointerenter", "pointerdown", "focusin"] as const) {
      this.root.addEventListener(
        name,
        () => {
          hand.abort();
          void this.figures.loadRays().then(() => {
            this.annotations.occlusionStale = true;
            this.refreshMarks();
          });
        },
        { signal: AbortSignal.any([hand.signal, this.abort.signal]) },
      );
    }
  }

  private listenToContext(canvas: HTMLCanvasElement): void {
    const { signal } = this.abort;
    canvas.addEventListener(
      "webglcontextlost",
      (event) => {
        event.preventDefault();
        this.lost = true;
        this.events.emit("context-lost", {});
      },
      { signal },
    );
    canvas.addEventListener(
      "webglcontextrestored",
      () => {
        this.lost = false;
        this.scenery.arrange();
        this.invalidate();
        this.events.emit("context-restored", {});
      },
      { signal },
    );
  }
}
