// Somebody who dances beside the model: drawn in the model's lane, on the same ground and in the same light. Not part of the first load.

import { Group, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import type { CompanionEvents, CompanionPort, DrawnModel, Shape } from "../stage/port";
import type { Standing } from "../util/standing";
import { FPS } from "../util/constants";
import { Emitter } from "../util/emitter";
import type { CameraRig } from "./camera-rig";
import { ContactShadow } from "./contact-shadow";
import { FloorHandle } from "./floor-handle";
import { clay, ModelFigure } from "./model-figure";
import type { Scenery } from "./scenery";
import { VertexBody } from "./vertex-body";

/** Of a slip what is left a frame later. */
const SLIPS = Math.exp(-1 / FPS / 0.25);

/** What of the stage a companion needs. */
export interface CompanionStage {
  readonly scenery: Scenery;
  readonly rig: CameraRig;
  /** Draws at the next animation frame. */
  invalidate(): void;
}

export class StageCompanion extends Emitter<CompanionEvents> implements CompanionPort {
  /** From its own world to the model's. */
  private readonly group = new Group();
  private readonly shadow = new ContactShadow();
  private readonly ring = new Mesh(
    new RingGeometry(0.3, 0.33, 48).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ transparent: true, opacity: 0.7, depthWrite: false, toneMapped: false, fog: false }),
  );
  private readonly handle: FloorHandle;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private figure: ModelFigure | null = null;
  /** Of its width. */
  private half = 0;
  private awaited: DrawnModel | null = null;
  private readonly feet = new Vector3();
  private place = { x: 0, z: 0 };
  /** Where its middle is, in the model's world. */
  private readonly ground = new Vector3();
  /** How far from its place it is still drawn since the model began anew. */
  private readonly slip = new Vector3();
  private again: Vector3 | null = null;

  constructor(private readonly stage: CompanionStage) {
    super();
    const { scenery, rig } = stage;
    scenery.model.group.add(this.group, this.shadow.mesh, this.ring);
    this.shadow.mesh.visible = this.ring.visible = false;
    this.ring.renderOrder = -7;
    this.ring.onBeforeRender = () => this.handle.put(this.ring.getWorldPosition(this.feet));
    this.handle = new FloorHandle(scenery.renderer.domElement, rig, (move) => {
      if (!move.held) this.frame();
      this.emit("move", move);
    });
    this.dark.addEventListener("change", this.paint);
    this.paint();
  }

  async setModel(model: DrawnModel): Promise<void> {
    const { scenery } = this.stage;
    this.awaited = model;
    const body = model.solid ? new (await import("./carried-body")).CarriedBody(model, model.solid) : new VertexBody(model);
    const figure = new ModelFigure(model, body);
    const { loadLook } = await import("./look");
    const look = await loadLook(model.document, model.instances, scenery.renderer).catch(clay);
    figure.dress(look);
    if (this.awaited === model) await scenery.compile(figure.bodies);
    if (this.awaited !== model) return figure.dispose();
    this.clear();
    this.figure = figure;
    this.half = figure.width / 2;
    figure.show();
    this.group.add(figure.group);
    this.frame();
    this.stage.invalidate();
  }

  setShape(shape: Shape, standing: Standing): void {
    const { figure, group, shadow, ring, ground } = this;
    const { scenery, rig } = this.stage;
    if (!figure?.body.takes(shape)) return;
    figure.setShape(shape);
    group.position.set(standing.x, 0, standing.z);
    group.rotation.y = standing.yaw;
    const outline = this.stand(figure.body.outline(shape));
    shadow.begin(ground.x, ground.z);
    for (let v = 0; v < outline.length; v += 3) shadow.add(outline[v]!, outline[v + 1]!, outline[v + 2]!, 0);
    shadow.end();
    shadow.mesh.visible = true;
    ring.position.set(ground.x + this.slip.x, 0.002, ground.z + this.slip.z);
    this.keepInSight(ground);
    scenery.arrange();
    if (!this.handle.held) rig.setContent(scenery.content);
    this.stage.invalidate();
  }

  beginAgain(x: number, z: number): void {
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.again = this.ground.clone().add(this.slip).sub({ x, y: 0, z });
  }

  setPlace(x: number, z: number): void {
    this.place = { x, z };
    if (!this.handle.held) this.frame();
    this.stage.invalidate();
  }

  setHandle(words: string | null): void {
    this.handle.name(words);
    this.ring.visible = words !== null;
    this.stage.invalidate();
  }

  /** In films and pictures there is no handle. */
  hideHandle(hide: boolean): void {
    this.ring.visible = !hide && this.handle.named;
  }

  dispose(): void {
    this.awaited = null;
    this.clear();
    const { scenery } = this.stage;
    scenery.model.group.remove(this.group, this.shadow.mesh, this.ring);
    this.shadow.dispose();
    this.ring.geometry.dispose();
    this.ring.material.dispose();
    this.handle.dispose();
    this.dark.removeEventListener("change", this.paint);
    Object.assign(scenery.beside, { width: 0, middle: 0, apart: 0, depth: 0, top: 0 });
    scenery.arrange();
    this.stage.rig.setContent(scenery.content);
    this.stage.invalidate();
  }

  /** Places of the shape in the model's world, where the group is put; finds its middle and its top. */
  private stand(places: Float32Array): Float32Array {
    const { group, ground, slip } = this;
    const { beside } = this.stage.scenery;
    const out = places.slice();
    const at = new Vector3();
    group.updateMatrix();
    ground.setScalar(0);
    beside.top = 0;
    for (let v = 0; v < out.length; v += 3) {
      at.fromArray(out, v).applyMatrix4(group.matrix).toArray(out, v);
      ground.addScaledVector(at, 3 / out.length);
      beside.top = Math.max(beside.top, at.y);
    }
    if (this.again) slip.subVectors(this.again, ground).setY(0);
    else slip.multiplyScalar(SLIPS);
    this.again = null;
    group.position.add(slip);
    for (let v = 0; v < out.length; v += 3) {
      out[v]! += slip.x;
      out[v + 2]! += slip.z;
    }
    return out;
  }

  private clear(): void {
    this.figure?.group.removeFromParent();
    this.figure?.dispose();
    this.figure = null;
  }

  /** Makes room for both where they begin. */
  private frame(): void {
    const { scenery, rig } = this.stage;
    const { model, beside } = scenery;
    if (!this.figure) return;
    const left = Math.min(-model.width / 2, this.place.x - this.half);
    const right = Math.max(model.width / 2, this.place.x + this.half);
    Object.assign(beside, { width: right - left - model.width, middle: (left + right) / 2 });
    scenery.arrange();
    rig.setContent(scenery.content);
  }

  /** Both stay in the picture, wherever they have come to: what stands at the one side is made room for at the other one too. */
  private keepInSight(ground: Vector3): void {
    const { model, beside } = this.stage.scenery;
    const from = model.traveller.ground;
    beside.apart = 2 * Math.abs(ground.x - from.x - this.place.x);
    beside.depth = 2 * Math.abs(ground.z - from.y);
  }

  private readonly paint = (): void => {
    this.shadow.setDark(this.dark.matches);
    this.ring.material.color.set(this.dark.matches ? "#ffd233" : "#17212b");
    this.stage.invalidate();
  };
}
