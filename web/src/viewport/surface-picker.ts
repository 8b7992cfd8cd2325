// Rays against the model as it stands now. The tree is built at the first ray and refitted only when a ray needs it.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, type Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";

export class SurfacePicker {
  private readonly geometry = new BufferGeometry();
  private readonly positions: Float32Array;
  private tree: MeshBVH | null = null;
  private pending: Float32Array | null;
  private readonly ray = new Ray();

  constructor(rest: Float32Array, faces: Uint32Array) {
    this.positions = new Float32Array(rest);
    this.pending = null;
    this.geometry.setAttribute("position", new BufferAttribute(this.positions, 3));
    this.geometry.setIndex(new BufferAttribute(faces, 1));
  }

  /** V x 3; read at the next ray. */
  setVertices(vertices: Float32Array): void {
    this.pending = vertices;
  }

  /** The nearest corner of the first triangle hit, or -1. */
  vertexAt(origin: Vector3, direction: Vector3): number {
    const hit = this.cast(origin, direction, Infinity);
    if (!hit?.face) return -1;
    let best = -1;
    let least = Infinity;
    for (const v of [hit.face.a, hit.face.b, hit.face.c]) {
      const p = this.positions;
      const away = Math.hypot(p[3 * v]! - hit.point.x, p[3 * v + 1]! - hit.point.y, p[3 * v + 2]! - hit.point.z);
      if (away < least) {
        least = away;
        best = v;
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
    if (this.pending) this.positions.set(this.pending);
    if (!this.tree) this.tree = new MeshBVH(this.geometry, { indirect: true });
    else if (this.pending) this.tree.refit();
    this.pending = null;
    this.ray.set(origin, direction);
    return this.tree.raycastFirst(this.ray, DoubleSide, 0, far);
  }
}
