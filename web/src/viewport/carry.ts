// A model on the GPU that nodes carry along. Each vertex lies in a cell of eight nodes; node i moves space by the affine map
// x -> A_i x + b_i, and a vertex by the mean of its eight maps, weighted with smoothstep hats over the cell (mesh/detail/carry.h
// has the same formulas). Normals turn by the cofactor of the map's gradient, tangents by the gradient.
// Letters: N nodes, E elements, V vertices.

import {
  BufferAttribute,
  type BufferGeometry,
  DataTexture,
  FloatType,
  type Material,
  NearestFilter,
  RGBAFormat,
  type Texture,
  type WebGLProgramParametersWithUniforms,
} from "three";
import type { SolidCells } from "../engine/types";

/** Texels in a row of a texture. */
const WIDTH = 1024;

const NODE_TEXELS = 3; // rows of (A | b)
const CELL_TEXELS = 3; // low corner and size, eight nodes

export class Carry {
  private readonly nodes: DataTexture;
  private readonly cells: DataTexture;

  constructor({ nodeCount, cell, corners, elements }: SolidCells) {
    this.nodes = texture(NODE_TEXELS * nodeCount);
    const count = elements.length / 8;
    this.cells = texture(CELL_TEXELS * count);
    const out = this.cells.image.data as Float32Array;
    for (let e = 0; e < count; e++) {
      out.set(corners.subarray(3 * e, 3 * e + 3), 12 * e);
      out[12 * e + 3] = cell;
      for (let k = 0; k < 8; k++) out[12 * e + 4 + k] = elements[8 * e + k] ?? 0;
    }
  }

  /** N x 12, rows of (A | b); read when it is drawn next. */
  write(transforms: Float32Array): void {
    (this.nodes.image.data as Float32Array).set(transforms);
    this.nodes.needsUpdate = true;
  }

  /** Says by which element each vertex of a geometry is carried; its positions and normals are those at rest, on the stage. */
  static dress(geometry: BufferGeometry, elementOf: Float32Array): void {
    geometry.setAttribute("carrier", new BufferAttribute(elementOf, 1));
  }

  /** Lets a material draw what is carried. Once for each material; a material has one carry. */
  patch(material: Material): void {
    const before = material.onBeforeCompile.bind(material);
    material.onBeforeCompile = (shader, renderer) => {
      before(shader, renderer);
      this.insert(shader);
    };
    const key = material.customProgramCacheKey.bind(material);
    material.customProgramCacheKey = () => `${key()} carried`;
    material.needsUpdate = true;
  }

  dispose(): void {
    this.nodes.dispose();
    this.cells.dispose();
  }

  private insert(shader: WebGLProgramParametersWithUniforms): void {
    shader.uniforms.carryNodes = { value: this.nodes satisfies Texture };
    shader.uniforms.carryCells = { value: this.cells satisfies Texture };
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", `${FUNCTION}\nvoid main() {\n  carryVertex();`)
      .replace(
        "#include <beginnormal_vertex>",
        `#include <beginnormal_vertex>
  objectNormal = carriedCofactor * objectNormal;
  #ifdef USE_TANGENT
    objectTangent = carriedGradient * objectTangent;
  #endif`,
      )
      .replace("#include <begin_vertex>", "#include <begin_vertex>\n  transformed = carriedPosition;");
  }
}

function texture(texels: number): DataTexture {
  const height = Math.max(1, Math.ceil(texels / WIDTH));
  const made = new DataTexture(new Float32Array(4 * WIDTH * height), WIDTH, height, RGBAFormat, FloatType);
  made.minFilter = made.magFilter = NearestFilter;
  made.needsUpdate = true;
  return made;
}

const FUNCTION = `
attribute float carrier;
uniform highp sampler2D carryNodes;
uniform highp sampler2D carryCells;
vec3 carriedPosition;
mat3 carriedGradient;
mat3 carriedCofactor;

vec4 carryTexel(highp sampler2D from, int at) {
  return texelFetch(from, ivec2(at % ${WIDTH}, at / ${WIDTH}), 0);
}

void carryVertex() {
  carriedPosition = position;
  carriedGradient = carriedCofactor = mat3(1.0);
  if (carrier < 0.0) return; // what nothing carries stays
  int cell = ${CELL_TEXELS} * int(carrier + 0.5);
  vec4 corner = carryTexel(carryCells, cell);
  vec4 low = carryTexel(carryCells, cell + 1);
  vec4 high = carryTexel(carryCells, cell + 2);
  vec3 t = clamp((position - corner.xyz) / corner.w, 0.0, 1.0);
  vec3 hat = t * t * (3.0 - 2.0 * t);
  vec3 slope = 6.0 * t * (1.0 - t) / corner.w;
  vec4 rest = vec4(position, 1.0);
  carriedPosition = vec3(0.0);
  carriedGradient = mat3(0.0);
  for (int k = 0; k < 8; k++) {
    bvec3 up = bvec3((k & 1) != 0, (k & 2) != 0, (k & 4) != 0);
    vec3 h = mix(1.0 - hat, hat, vec3(up));
    vec3 d = mix(-slope, slope, vec3(up));
    float weight = h.x * h.y * h.z;
    vec3 gradient = vec3(d.x * h.y * h.z, h.x * d.y * h.z, h.x * h.y * d.z);
    int node = ${NODE_TEXELS} * int((k < 4 ? low[k] : high[k - 4]) + 0.5);
    vec4 x = carryTexel(carryNodes, node), y = carryTexel(carryNodes, node + 1), z = carryTexel(carryNodes, node + 2);
    vec3 moved = vec3(dot(x, rest), dot(y, rest), dot(z, rest));
    carriedPosition += weight * moved;
    carriedGradient += weight * transpose(mat3(x.xyz, y.xyz, z.xyz)) + outerProduct(moved, gradient);
  }
  carriedCofactor = mat3(cross(carriedGradient[1], carriedGradient[2]), cross(carriedGradient[2], carriedGradient[0]),
                         cross(carriedGradient[0], carriedGradient[1]));
}
`;
