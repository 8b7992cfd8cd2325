// A model whose vertices are told. A geometry for each instance, all of them windows on the same arrays.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import { bindNormals, type NormalBinding, writeNormals } from "../gltf/surface-normals";
import type { DrawnModel, Shape } from "../stage/port";
import type { Body, GhostBody } from "./body";
import { instanceIndex } from "./instance-index";
import { smoothNormals } from "./smooth-normals";

export class VertexBody implements Body {
  readonly geometries: readonly BufferGeometry[];
  readonly rest: Shape;
  private readonly positions: Float32Array;
  private readonly normals: Float32Array;
  private readonly moving: BufferAttribute[] = [];
  private readonly binding: NormalBinding;

  constructor(private readonly model: DrawnModel) {
    this.rest = model.rest;
    this.binding = bindNormals(model.rest, model);
    this.positions = new Float32Array(model.positions);
    this.normals = new Float32Array(model.normals);
    this.geometries = model.instances.map((instance) => {
      const geometry = new BufferGeometry();
      const { first, count } = instance;
      const window = (values: Float32Array): BufferAttribute => {
        const attribute = new BufferAttribute(values.subarray(3 * first, 3 * (first + count)), 3).setUsage(DynamicDrawUsage);
        this.moving.push(attribute);
        return attribute;
      };
      geometry.setAttribute("position", window(this.positions));
      if (!instance.flat) geometry.setAttribute("normal", window(this.normals));
      return geometry.setIndex(instanceIndex(model, instance));
    });
  }

  takes(shape: Shape): boolean {
    return shape.length === this.rest.length;
  }

  /** Does not allocate. */
  write(vertices: Shape): void {
    const { toVertex } = this.model;
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

  dress(): void {}

  places(shape: Shape, vertices: ArrayLike<number>, out: Float32Array): void {
    for (let i = 0; i < vertices.length; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = shape[3 * vertices[i]! + k]!;
  }

  outline(shape: Shape): Float32Array {
    return shape;
  }

  ghost(): GhostBody {
    const geometry = new BufferGeometry().setIndex(new BufferAttribute(this.model.faces, 1));
    return {
      geometry,
      write: (shape) => {
        geometry.setAttribute("position", new BufferAttribute(shape, 3));
        geometry.setAttribute("normal", new BufferAttribute(smoothNormals(shape, this.model.faces), 3));
      },
      dress: () => {},
      dispose: () => geometry.dispose(),
    };
  }

  dispose(): void {
    for (const geometry of this.geometries) geometry.dispose();
  }
}
