// One deformable surface on the GPU: the model, its ghost and its thumbnails each own one over the same topology.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import { type Topology, writeNormals } from "./normals";

export class Shape {
  readonly geometry = new BufferGeometry();
  private readonly positions: BufferAttribute;
  private readonly normals: BufferAttribute;

  constructor(private readonly topology: Topology) {
    const count = topology.vertex.length;
    this.positions = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.normals = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.geometry.setAttribute("position", this.positions);
    this.geometry.setAttribute("normal", this.normals);
    this.geometry.setIndex(new BufferAttribute(topology.index, 1));
  }

  /** Takes V x 3; does not allocate. */
  write(vertices: Float32Array): void {
    const { vertex } = this.topology;
    const out = this.positions.array;
    for (let i = 0; i < vertex.length; i++) {
      const v = 3 * vertex[i]!;
      out[3 * i] = vertices[v]!;
      out[3 * i + 1] = vertices[v + 1]!;
      out[3 * i + 2] = vertices[v + 2]!;
    }
    writeNormals(this.topology, vertices, this.normals.array as Float32Array);
    this.positions.needsUpdate = true;
    this.normals.needsUpdate = true;
  }

  dispose(): void {
    this.geometry.dispose();
  }
}
