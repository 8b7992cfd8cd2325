// The stage as one object: keeps figures, marks, camera and hand together and draws only when something changed.

import { Emitter } from "../util/emitter";
import { Annotations } from "./annotations";
import { CameraRig } from "./camera-rig";
import { PointHand } from "./point-hand";
import { Figures } from "./figures";
import { Interaction } from "./interaction";
import { overlayStyle } from "./overlay-style";
import { QualityGovernor } from "./quality";
import { Stage } from "./stage";
import { readTheme, type Theme } from "./theme";
import { Thumbnails } from "./thumbnail";
import type { PointMark, DrawnHuman, DrawnModel, Insets, ViewMode, ViewportApi, ViewportEvents } from "./types";

export class Viewport implements ViewportApi {
  private readonly root = document.createElement("div");
  private readonly shadow = this.root.attachShadow({ mode: "open" });
  private readonly events = new Emitter<ViewportEvents>();
  private readonly stage: Stage;
  private readonly rig: CameraRig;
  private readonly figures: Figures;
  private readonly hand: PointHand;
  private readonly marks: Annotations;
  private readonly interaction: Interaction;
  private readonly thumbnails: Thumbnails;
  private readonly governor: QualityGovernor;
  private readonly observer: ResizeObserver;
  private readonly abort = new AbortController();
  private points: readonly PointMark[] = [];
  private selected: string | null = null;
  private movedAt = -Infinity;
  private insets: Insets = { left: 0, top: 0, right: 0, bottom: 0 };
  private size = { width: 1, height: 1 };
  private frame = 0;
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
    this.stage = new Stage(canvas, still);
    this.governor = new QualityGovernor(this.stage.rendererName());
    this.stage.setQuality(this.governor.quality);
    this.rig = new CameraRig(this.root, still, () => this.invalidate());
    this.hand = new PointHand(this.events, this.rig, this.stage.model.offset);
    this.figures = new Figures(this.stage, theme);
    this.marks = new Annotations(this.stage, this.rig, this.figures, this.hand, () => this.refreshMarks());
    this.thumbnails = new Thumbnails(this.stage.renderer);
    this.shadow.adoptedStyleSheets = [overlayStyle()];
    this.shadow.append(canvas, this.marks.lines.element, this.marks.overlay.element);
    this.paint(theme);

    this.interaction = new Interaction(
      this.root,
      this.rig,
      this.hand,
      this.marks,
      this.events,
      () => this.refreshMarks(),
      () => performance.now() - this.movedAt < 1200,
    );
    this.listenToContext(canvas);
    this.listenForHand();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
    this.fit();
  }

  on<K extends keyof ViewportEvents>(name: K, listener: (detail: ViewportEvents[K]) => void): () => void {
    return this.events.on(name, listener);
  }

  setModel(model: DrawnModel | null): void {
    this.hand.letGo(true);
    this.figures.setModel(model);
    this.thumbnails.setModel(this.figures.model);
    this.invalidate();
  }

  setVertices(positions: Float32Array): void {
    this.figures.setVertices(positions);
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
    this.marks.setPoints(points, selected);
    this.refreshMarks();
  }

  pulse(id: string | null): void {
    this.marks.overlay.pulse(id);
  }

  /** The clip began again: the figures go on from where they are, on ground that goes on under them. */
  beginAgain(): void {
    this.stage.beginAgain();
  }

  setMode(mode: ViewMode): void {
    this.marks.mode = mode;
    this.refreshMarks();
  }

  setGhost(positions: Float32Array | null): void {
    this.figures.setGhost(positions);
    this.invalidate();
  }

  setAsking(asking: boolean): void {
    this.figures.setAsking(asking);
    this.invalidate();
  }

  setLivePair(from: { id: string } | { joint: number } | null): void {
    this.marks.live = from;
    this.refreshMarks();
  }

  setNote(words: string): void {
    this.marks.note = words;
    this.refreshMarks();
  }

  setInsets(insets: Insets): void {
    this.insets = { ...insets };
    this.marks.overlay.insets = this.insets;
    this.rig.setView({ ...this.size, insets: this.insets });
    this.invalidate();
  }

  setLayout(layout: "side" | "overlay"): void {
    this.stage.setOverlay(layout === "overlay");
    this.figures.dressHuman();
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
    // The canvas now shows the little picture. A slow machine may present it before the next tick: draw the stage again at once.
    const stale = this.pictureStale;
    this.draw();
    this.pictureStale = stale;
    return url;
  }

  refreshTheme(): void {
    this.paint(readTheme(this.shadow));
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.lost = true; // nothing draws any more
    this.abort.abort();
    this.observer.disconnect();
    this.interaction.dispose();
    this.rig.dispose();
    this.marks.dispose();
    this.thumbnails.dispose();
    this.figures.dispose();
    this.stage.dispose();
    this.root.remove();
  }

  // Drawing

  private invalidate(): void {
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
        this.stage.setQuality(this.governor.quality);
        this.stage.resize(this.size.width, this.size.height, this.pixelRatio());
      }
      this.tick(now);
    });
  }

  private tick(now: number): void {
    const seconds = Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    this.takeShapes();
    const following = this.stage.follow(seconds, this.hand.holding);
    const turning = this.rig.update(seconds);
    if (following || turning) {
      this.marks.occlusionStale = true;
      this.invalidate();
    }
    this.marks.update(now);
    if (this.pictureStale) this.draw();
    if (following || turning) this.invalidate();
  }

  private draw(): void {
    if (this.lost) return;
    this.stage.render(this.rig.camera, this.rig.controls.distance);
    this.pictureStale = false;
  }

  private takeShapes(): void {
    const { surface, pose } = this.figures.take();
    if (!surface && !pose) return;
    if (surface) this.hand.settle();
    this.marks.occlusionStale = true;
    this.stage.arrange();
    if (!this.hand.holding) this.rig.setContent(this.stage.content); // nothing moves under the hand
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width < 1 || height < 1) return;
    this.size = { width, height };
    this.stage.resize(width, height, this.pixelRatio());
    this.rig.setView({ width, height, insets: this.insets });
    this.figures.setViewSize(width, height);
    this.marks.setSize(width, height);
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
    this.stage.setTheme(theme);
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
            this.marks.occlusionStale = true;
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
        this.stage.arrange();
        this.invalidate();
        this.events.emit("context-restored", {});
      },
      { signal },
    );
  }
}
