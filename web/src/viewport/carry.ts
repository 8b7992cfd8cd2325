// Nodes that carry a model on the graphics card. Each vertex lies in an element of eight nodes; a node moves space by x -> B x + b,
// and a vertex by the mean of its eight maps, weighted with smoothstep hats over the element. Normals turn by the cofactors of that
// map's gradient. The formulas are those of mesh/solid.h.

import {
  BufferAttribute,
  type BufferGeometry,
  DataTexture,
  FloatType,
  type Material,
  MeshDepthMaterial,
  NearestFilter,
  RGBAFormat,
  type WebGLProgramParametersWithUniforms,
} from "three";
import type { SolidCells } from "../util/solid-cells";

/** Texels in a row of a texture. */
const WIDTH = 512;
/** A node's three rows of (B | b). */
const NODE_TEXELS = 3;
/** An element's low corner and size, and its eight nodes. */
const ELEMENT_TEXELS = 3;

/** The elements of a solid: they stay as they are, and every carry of the same model reads them. */
export function elementTexture({ cell, nodes, elements }: SolidCells): DataTexture {
  const count = elements.length / 8;
  const texture = floats(ELEMENT_TEXELS * count);
  const out = texture.image.data as Float32Array;
  for (let e = 0; e < count; e++) {
    const low = 3 * elements[8 * e]!;
    out.set(nodes.subarray(low, low + 3), 12 * e);
    out[12 * e + 3] = cell;
    out.set(elements.subarray(8 * e, 8 * e + 8), 12 * e + 4);
  }
  return texture;
}

/** Says by which element each vertex is carried, -1 for none. */
export function setElements(geometry: BufferGeometry, elementOf: Float32Array): void {
  geometry.setAttribute("element", new BufferAttribute(elementOf, 1));
}

export class Carry {
  private readonly nodes: DataTexture;
  private readonly patched = new WeakSet<Material>();

  constructor(
    private readonly elements: DataTexture,
    nodes: number,
  ) {
    this.nodes = floats(NODE_TEXELS * nodes);
  }

  /** N x 12; read when it is drawn next. */
  write(maps: Float32Array): void {
    (this.nodes.image.data as Float32Array).set(maps);
    this.nodes.needsUpdate = true;
  }

  /** Lets a material draw what is carried; it belongs to this carry from then on. */
  patch(material: Material): void {
    if (this.patched.has(material)) return;
    this.patched.add(material);
    const before = material.onBeforeCompile.bind(material);
    material.onBeforeCompile = (shader, renderer) => {
      before(shader, renderer);
      this.insert(shader);
    };
    const key = material.customProgramCacheKey.bind(material);
    material.customProgramCacheKey = () => `${key()} carried`;
    material.needsUpdate = true;
  }

  /** What throws the shadow of something carried. */
  depthMaterial(): MeshDepthMaterial {
    const material = new MeshDepthMaterial();
    this.patch(material);
    return material;
  }

  dispose(): void {
    this.nodes.dispose();
  }

  private insert(shader: WebGLProgramParametersWithUniforms): void {
    shader.uniforms["carryNodes"] = { value: this.nodes };
    shader.uniforms["carryElements"] = { value: this.elements };
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", `${CARRY}\nvoid main() {\n  carry();`)
      .replace("#include <beginnormal_vertex>", "#include <beginnormal_vertex>\n  objectNormal = carriedNormal(objectNormal);")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\n  transformed = carriedPosition;");
  }
}

function floats(texels: number): DataTexture {
  const height = Math.max(1, Math.ceil(texels / WIDTH));
  const texture = new DataTexture(new Float32Array(4 * WIDTH * height), WIDTH, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

const CARRY = `
attribute float element;
uniform highp sampler2D carryNodes, carryElements;
vec3 carriedPosition;
mat3 carriedGradient; // columns

vec4 carryTexel(highp sampler2D from, int at) {
  return texelFetch(from, ivec2(at % ${WIDTH}, at / ${WIDTH}), 0);
}

void carry() {
  carriedPosition = position;
  carriedGradient = mat3(1.0);
  if (element < 0.0) return;
  int first = ${ELEMENT_TEXELS} * int(element + 0.5);
  vec4 corner = carryTexel(carryElements, first);
  vec4 low = carryTexel(carryElements, first + 1);
  vec4 high = carryTexel(carryElements, first + 2);
  vec3 t = clamp((position - corner.xyz) / corner.w, 0.0, 1.0);
  vec3 hat = t * t * (3.0 - 2.0 * t);
  vec3 slope = 6.0 * t * (1.0 - t) / corner.w;
  vec4 rest = vec4(position, 1.0);
  vec3 middle; // slopes sum to 0, so places may count from one of them
  carriedPosition = vec3(0.0);
  carriedGradient = mat3(0.0);
  for (int k = 0; k < 8; k++) {
    bvec3 far = bvec3((k & 1) != 0, (k & 2) != 0, (k & 4) != 0);
    vec3 h = mix(1.0 - hat, hat, vec3(far));
    vec3 d = mix(-slope, slope, vec3(far));
    int node = ${NODE_TEXELS} * int((k < 4 ? low[k] : high[k - 4]) + 0.5);
    vec4 x = carryTexel(carryNodes, node);
    vec4 y = carryTexel(carryNodes, node + 1);
    vec4 z = carryTexel(carryNodes, node + 2);
    vec3 moved = vec3(dot(x, rest), dot(y, rest), dot(z, rest));
    if (k == 0) middle = moved;
    float weight = h.x * h.y * h.z;
    carriedPosition += weight * moved;
    carriedGradient += weight * transpose(mat3(x.xyz, y.xyz, z.xyz))
                     + outerProduct(moved - middle, vec3(d.x * h.y * h.z, h.x * d.y * h.z, h.x * h.y * d.z));
  }
}

vec3 carriedNormal(vec3 normal) {
  return mat3(cross(carriedGradient[1], carriedGradient[2]), cross(carriedGradient[2], carriedGradient[0]),
              cross(carriedGradient[0], carriedGradient[1])) * normal;
}
`;
