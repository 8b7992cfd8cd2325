// A model whose vertices the nodes of a solid carry: they lie on the graphics card once, and a shape is a few thousand maps.

import { BufferAttribute, BufferGeometry, type Material, type Mesh } from "three";
import type { DrawnModel, Shape } from "../stage/port";
import { carryVertices, restMaps, type SolidCells } from "../util/solid-cells";
import type { Body, GhostBody } from "./body";
import { Carry, elementTexture, setElements } from "./carry";
import { instanceIndex } from "./instance-index";
import { smoothNormals } from "./smooth-normals";

export class CarriedBody implements Body {
  readonly geometries: readonly BufferGeometry[];
  readonly rest: Shape;
  private readonly elements: ReturnType<typeof elementTexture>;
  private readonly carry: Carry;
  private readonly shadows: Material[] = [];
  /** Some of each element's vertices. */
  private readonly outermost: Uint32Array;
  private readonly outlined: Float32Array;

  constructor(
    private readonly model: DrawnModel,
    private readonly solid: SolidCells,
  ) {
    const { rest, normals, toVertex } = model;
    this.rest = restMaps(solid);
    this.elements = elementTexture(solid);
    this.carry = new Carry(this.elements, solid.nodes.length / 3);
    this.carry.write(this.rest);
    this.outermost = outermostOf(solid, rest);
    this.outlined = new Float32Array(3 * this.outermost.length);
    const positions = new Float32Array(3 * toVertex.length);
    const elements = new Float32Array(toVertex.length);
    for (let r = 0; r < toVertex.length; r++) {
      const v = toVertex[r]!;
      elements[r] = solid.elementOf[v]!;
      positions[3 * r] = rest[3 * v]!;
      positions[3 * r + 1] = rest[3 * v + 1]!;
      positions[3 * r + 2] = rest[3 * v + 2]!;
    }
    this.geometries = model.instances.map((instance) => {
      const { first, count, flat } = instance;
      const geometry = new BufferGeometry();
      const window = (values: Float32Array): BufferAttribute => new BufferAttribute(values.subarray(3 * first, 3 * (first + count)), 3);
      geometry.setAttribute("position", window(positions));
      if (!flat) geometry.setAttribute("normal", window(normals));
      setElements(geometry, elements.subarray(first, first + count));
      return geometry.setIndex(instanceIndex(model, instance));
    });
  }

  takes(shape: Shape): boolean {
    return shape.length === this.rest.length;
  }

  write(maps: Shape): void {
    this.carry.write(maps);
  }

  dress(mesh: Mesh): void {
    this.carry.patch(mesh.material as Material);
    mesh.customDepthMaterial = this.carry.depthMaterial();
    this.shadows.push(mesh.customDepthMaterial);
  }

  places(maps: Shape, vertices: ArrayLike<number>, out: Float32Array): void {
    carryVertices(this.solid, this.model.rest, maps, vertices, out);
  }

  outline(maps: Shape): Float32Array {
    this.places(maps, this.outermost, this.outlined);
    return this.outlined;
  }

  ghost(): GhostBody {
    const { rest, faces } = this.model;
    const carry = new Carry(this.elements, this.solid.nodes.length / 3);
    const geometry = new BufferGeometry().setIndex(new BufferAttribute(faces, 1));
    geometry.setAttribute("position", new BufferAttribute(rest, 3));
    geometry.setAttribute("normal", new BufferAttribute(smoothNormals(rest, faces), 3));
    setElements(geometry, Float32Array.from(this.solid.elementOf));
    return {
      geometry,
      write: (maps) => carry.write(maps),
      dress: (material) => carry.patch(material),
      dispose: () => {
        carry.dispose();
        geometry.dispose();
      },
    };
  }

  dispose(): void {
    this.carry.dispose();
    this.elements.dispose();
    for (const material of this.shadows) material.dispose();
    for (const geometry of this.geometries) geometry.dispose();
  }
}

/** The lowest and the highest vertex of each element. */
function outermostOf({ elements, elementOf }: SolidCells, rest: Float32Array): Uint32Array {
  const lowest = new Int32Array(elements.length / 8).fill(-1);
  const highest = new Int32Array(lowest);
  for (let v = 0; v < elementOf.length; v++) {
    const e = elementOf[v]!;
    if (e < 0) continue;
    const y = rest[3 * v + 1]!;
    if (lowest[e]! < 0 || y < rest[3 * lowest[e]! + 1]!) lowest[e] = v;
    if (highest[e]! < 0 || y > rest[3 * highest[e]! + 1]!) highest[e] = v;
  }
  return Uint32Array.from(new Set([...lowest, ...highest].filter((v) => v >= 0)));
}
