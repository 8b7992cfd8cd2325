// Who stands on the stage: the model, its ghost and the human, each drawn from the newest positions it was given.

import type { Vector3 } from "three";
import type { Body } from "./body";
import { Mannequin } from "./mannequin";
import { clay, ModelFigure } from "./model-figure";
import { HUMAN_WIDTH, type Scenery } from "./scenery";
import type { SurfacePicker } from "./surface-picker";
import type { Theme } from "./theme";
import type { DrawnHuman, DrawnModel, Shape } from "../stage/port";
import { VertexBody } from "./vertex-body";

export class Figures {
  model: ModelFigure | null = null;
  picker: SurfacePicker | null = null;
  mannequin: Mannequin | null = null;
  /** World. */
  private ghost: Shape | null = null;
  private asking = false;
  private human: DrawnHuman | null = null;
  private nextShape: Shape | null = null;
  private nextPose: Float32Array | null = null;
  private viewSize: [number, number] = [1, 1];
  private rays: typeof import("./surface-picker") | null = null;
  /** Since the first model that a solid carries. */
  private carrying: typeof import("./carried-body") | null = null;
  /** The newest model, until it stands here. */
  private awaited: DrawnModel | null = null;
  /** On its way from the beginning: the first model waits for it. */
  private readonly looks = import("./look");

  constructor(
    private readonly scenery: Scenery,
    private theme: Theme,
  ) {}

  /** Answers true once the model has its look, false if another one has come before. */
  async setModel(model: DrawnModel | null): Promise<boolean> {
    this.clear();
    this.awaited = model;
    if (!model) return true;
    if (model.solid) this.carrying ??= await import("./carried-body");
    if (this.awaited !== model) return false;
    const figure = this.place(model);
    const look = await this.looks.then(({ loadLook }) => loadLook(model.document, model.instances, this.scenery.renderer)).catch(clay);
    if (this.model !== figure) look?.dispose();
    else {
      figure.dress(look);
      await this.scenery.compile(figure.bodies);
      figure.show();
    }
    return this.model === figure;
  }

  private clear(): void {
    const { model: lane } = this.scenery;
    if (this.model) lane.group.remove(this.model.group);
    this.model?.dispose();
    this.model = null;
    void this.makePicker();
    this.nextShape = this.ghost = null;
    lane.shadow.mesh.visible = false;
    this.scenery.setWidth(lane, 0);
  }

  private place(model: DrawnModel): ModelFigure {
    const { model: lane } = this.scenery;
    this.model = new ModelFigure(model, this.bodyOf(model));
    void this.makePicker();
    this.nextShape ??= this.model.body.rest;
    lane.group.add(this.model.group);
    lane.shadow.mesh.visible = true;
    this.scenery.setWidth(lane, this.model.width);
    return this.model;
  }

  private bodyOf(model: DrawnModel): Body {
    return model.solid && this.carrying ? new this.carrying.CarriedBody(model, model.solid) : new VertexBody(model);
  }

  setHuman(human: DrawnHuman | null): void {
    const { human: lane } = this.scenery;
    if (this.mannequin) lane.group.remove(this.mannequin.group);
    this.mannequin?.dispose();
    this.human = human;
    this.mannequin = human && new Mannequin(human);
    this.nextPose = null;
    if (this.mannequin) lane.group.add(this.mannequin.group);
    lane.shadow.mesh.visible = false; // until there is a pose
    this.scenery.setWidth(lane, human ? HUMAN_WIDTH : 0);
    this.dressHuman();
  }

  /** Rays can be cast from now on; answers once they can. */
  async loadRays(): Promise<void> {
    this.rays = await import("./surface-picker");
    await this.makePicker();
  }

  setShape(shape: Shape): void {
    this.nextShape = shape;
  }

  setPose(pose: Float32Array): void {
    this.nextPose = pose;
  }

  setGhost(shape: Shape | null): void {
    this.ghost = shape && this.model?.body.takes(shape) ? shape : null;
    this.model?.setGhost(this.ghost, this.theme);
    this.model?.setViewSize(...this.viewSize);
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.model?.setTheme(theme);
    this.dressHuman();
  }

  setViewSize(width: number, height: number): void {
    this.viewSize = [width, height];
    this.model?.setViewSize(width, height);
  }

  setAsking(asking: boolean): void {
    this.asking = asking;
    this.dressHuman();
  }

  /** Where both stand on one spot, the human shows through the model; who asks is in blue pencil. */
  dressHuman(): void {
    this.mannequin?.setSeenThrough(this.scenery.overlay, this.theme.stage);
    this.mannequin?.setPencil(this.asking ? this.theme.pencilSoft : null);
  }

  /** Draws what arrived since the last frame and says what it was. */
  take(): { surface: boolean; pose: boolean } {
    const { model, mannequin, nextShape, nextPose, scenery } = this;
    const surface = model !== null && nextShape !== null && model.body.takes(nextShape);
    const pose = mannequin !== null && nextPose !== null;
    if (surface) {
      model.setShape(nextShape);
      this.picker?.setShape(nextShape);
      standOn(scenery.model, model.body.outline(nextShape));
    }
    if (pose) {
      mannequin.setPose(nextPose);
      scenery.human.traveller.ground.set(nextPose[0]!, nextPose[2]!);
      scenery.human.top = mannequin.top();
      scenery.human.shadow.mesh.visible = true;
      mannequin.darken(scenery.human.shadow);
    }
    if (model) this.nextShape = null;
    this.nextPose = null;
    return { surface, pose };
  }

  /** Model world. */
  vertex(vertex: number, out: Vector3): Vector3 {
    return this.model ? out.fromArray(this.model.vertex(vertex)) : out.set(0, 0, 0);
  }

  /** Model world; null where no ghost shows. */
  ghostVertex(vertex: number, out: Vector3): Vector3 | null {
    return this.model && this.ghost && out.fromArray(this.model.vertex(vertex, this.ghost));
  }

  /** Scene. */
  joint(joint: number, out: Vector3): Vector3 {
    if (!this.mannequin?.pose) return out.set(0, 0, 1e4); // behind the camera: not shown
    return this.mannequin.seen(joint, out).add(this.scenery.human.offset);
  }

  jointLabel(joint: number): string {
    return this.human?.joints[joint]?.label ?? "Joint";
  }

  private async makePicker(): Promise<void> {
    const { model, rays } = this;
    this.picker?.dispose();
    this.picker = null;
    if (!model || !rays) return;
    const picker = await rays.makePicker(model.model, model.body);
    if (this.model !== model) return;
    picker.setShape(model.shape);
    this.picker = picker;
  }

  dispose(): void {
    this.model?.dispose();
    this.picker?.dispose();
    this.mannequin?.dispose();
  }
}

/** Finds where a model is and darkens the ground under its lowest places. */
function standOn(lane: Scenery["model"], vertices: Float32Array): void {
  const {
    shadow,
    traveller: { ground },
  } = lane;
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
