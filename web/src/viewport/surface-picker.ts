// Rays against the model as it stands now. The tree is built at the first ray and refitted only when a ray needs it.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, type Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import type { DrawnModel, Shape } from "../stage/port";
import type { Body } from "./body";
import { around, type StandIn, standInFor } from "./stand-in";

/** Answers a picker once the model's stand-in is there. */
export async function makePicker(model: DrawnModel, body: Body): Promise<SurfacePicker> {
  return new SurfacePicker(model, body, await standInFor(model.rest, model.faces, model.solid, () => new Promise((go) => setTimeout(go))));
}

export class SurfacePicker {
  private readonly geometry = new BufferGeometry();
  private readonly positions: Float32Array;
  private tree: MeshBVH | null = null;
  private shape: Shape;
  private stale = true;
  private readonly ray = new Ray();

  constructor(
    private readonly model: DrawnModel,
    private readonly body: Body,
    private readonly standIn: StandIn,
  ) {
    this.shape = body.rest;
    this.positions = new Float32Array(3 * standIn.vertices.length);
    this.geometry.setAttribute("position", new BufferAttribute(this.positions, 3));
    this.geometry.setIndex(new BufferAttribute(standIn.faces, 1));
  }

  /** Read at the next ray. */
  setShape(shape: Shape): void {
    this.shape = shape;
    this.stale = true;
  }

  /** The vertex nearest to where a ray meets the model first, or -1. */
  vertexAt(origin: Vector3, direction: Vector3): number {
    const hit = this.cast(origin, direction, Infinity);
    if (!hit?.face) return -1;
    const { vertices, coarse } = this.standIn;
    const corners = [hit.face.a, hit.face.b, hit.face.c].map((corner) => vertices[corner]!);
    const near = coarse && this.model.solid ? around(this.model.solid, corners) : corners;
    const places = new Float32Array(3 * near.length);
    this.body.places(this.shape, near, places);
    let best = -1;
    let least = Infinity;
    for (let i = 0; i < near.length; i++) {
      const away = Math.hypot(places[3 * i]! - hit.point.x, places[3 * i + 1]! - hit.point.y, places[3 * i + 2]! - hit.point.z);
      if (away < least) {
        least = away;
        best = near[i]!;
      }
    }
    return best;
  }

  /** Whether the surface hides a point from an eye; the last 3 cm before the point do not count, it lies on the surface itself. */
  hides(eye: Vector3, direction: Vector3, distance: number): boolean {
    return this.cast(eye, direction, distance - 0.03) !== null;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private cast(origin: Vector3, direction: Vector3, far: number) {
    if (this.geometry.index!.count === 0) return null;
    if (this.stale) this.body.places(this.shape, this.standIn.vertices, this.positions);
    if (!this.tree) this.tree = new MeshBVH(this.geometry, { indirect: true });
    else if (this.stale) this.tree.refit();
    this.stale = false;
    this.ray.set(origin, direction);
    return this.tree.raycastFirst(this.ray, DoubleSide, 0, far);
  }
}
