// One deformable copy of a model on the graphics card: the model and its thumbnails each own one. A geometry for each instance, all of
// them windows on the same arrays.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import type { Drawn } from "../gltf/drawn";
import { type NormalBinding, writeNormals } from "../gltf/surface-normals";

export class Shape {
  /** By instance. */
  readonly geometries: readonly BufferGeometry[];
  private readonly positions: Float32Array;
  private readonly normals: Float32Array;
  private readonly moving: BufferAttribute[] = [];

  constructor(
    private readonly drawn: Drawn,
    private readonly binding: NormalBinding,
  ) {
    this.positions = new Float32Array(drawn.positions);
    this.normals = new Float32Array(drawn.normals);
    this.geometries = drawn.instances.map(({ first, count, from, to, flat }) => {
      const geometry = new BufferGeometry();
      const window = (values: Float32Array): BufferAttribute => {
        const attribute = new BufferAttribute(values.subarray(3 * first, 3 * (first + count)), 3).setUsage(DynamicDrawUsage);
        this.moving.push(attribute);
        return attribute;
      };
      geometry.setAttribute("position", window(this.positions));
      if (!flat) geometry.setAttribute("normal", window(this.normals));
      geometry.setIndex(
        new BufferAttribute(
          Uint32Array.from(drawn.index.subarray(from, to), (r) => r - first),
          1,
        ),
      );
      return geometry;
    });
  }

  /** Takes V x 3; does not allocate. */
  write(vertices: Float32Array): void {
    const { toVertex } = this.drawn;
    const out = this.positions;
    for (let r = 0; r < toVertex.length; r++) {
      const v = 3 * toVertex[r]!;
      out[3 * r] = vertices[v]!;
      out[3 * r + 1] = vertices[v + 1]!;
      out[3 * r + 2] = vertices[v + 2]!;
    }
    writeNormals(this.binding, vertices, this.normals);
    for (const attribute of this.moving) attribute.needsUpdate = true;
  }

  dispose(): void {
    for (const geometry of this.geometries) geometry.dispose();
  }
}
