// A tree of three.js objects as parts: where they stand, in the pose that they have.

import {
  type BufferAttribute,
  type BufferGeometry,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  type Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Vector3,
} from "three";

import type { NamedJoint } from "../../sync/named-body";
import type { BuiltPart } from "../gltf/build";

type Attribute = BufferAttribute | InterleavedBufferAttribute;

export interface SceneParts {
  readonly parts: BuiltPart[];
  readonly joints: NamedJoint[];
  readonly skinned: boolean;
  readonly morphed: boolean;
  /** Lines and points, which are left out. */
  readonly others: number;
}

/** `materialOf` numbers a material; null for what is clay. What is hidden is left out, unless all is. */
export function sceneParts(scene: Object3D, materialOf: (material: Material) => number | null): SceneParts {
  scene.updateMatrixWorld(true);
  const { joints, ofBone } = jointsOf(scene);
  const found = { parts: [] as BuiltPart[], skinned: false, morphed: false, others: 0 };
  const take = (object: Object3D): void => {
    if (isMesh(object)) {
      for (const matrix of placesOf(object)) found.parts.push(...meshParts(object, matrix, moversOf(object, ofBone), materialOf));
      found.skinned ||= isSkinned(object);
      found.morphed ||= (object.morphTargetInfluences ?? []).length > 0;
    } else if ("isLine" in object || "isPoints" in object) found.others++;
  };
  scene.traverseVisible(take);
  if (found.parts.length === 0) scene.traverse(take);
  return { ...found, joints };
}

function isMesh(object: Object3D): object is Mesh {
  return "isMesh" in object && (object as Mesh).geometry.getAttribute("position") !== undefined;
}

function isSkinned(mesh: Mesh): mesh is SkinnedMesh {
  const { geometry } = mesh;
  return "isSkinnedMesh" in mesh && !!geometry.getAttribute("skinIndex") && !!geometry.getAttribute("skinWeight");
}

/** Where a mesh stands: many times for an instanced one. */
function placesOf(mesh: Mesh): Matrix4[] {
  if (!("isInstancedMesh" in mesh)) return [mesh.matrixWorld];
  const instanced = mesh as InstancedMesh;
  return Array.from({ length: instanced.count }, (_, i) => {
    const own = new Matrix4();
    instanced.getMatrixAt(i, own);
    return own.premultiply(mesh.matrixWorld);
  });
}

function meshParts(mesh: Mesh, matrix: Matrix4, joints: Int32Array | null, materialOf: (material: Material) => number | null): BuiltPart[] {
  const { geometry } = mesh;
  const { positions, normals } = posed(mesh, matrix);
  const uvs = ["uv", "uv1", "uv2", "uv3"].flatMap((key) => {
    const attribute = geometry.getAttribute(key) as Attribute | undefined;
    return attribute ? [flipped(attribute)] : [];
  });
  const shared = { positions, normals, joints, colors: colorsOf(geometry), uvs, ...(mesh.name && { name: mesh.name }) };
  const mirrored = matrix.determinant() < 0;
  return rangesOf(mesh).flatMap(({ material, start, count }) => {
    const index = trianglesOf(geometry, start, count, mirrored);
    const own = material && materialOf(material);
    return index.length === 0 ? [] : [{ ...shared, index, ...(own !== null && own !== undefined && { material: own }) }];
  });
}

interface Range {
  readonly material: Material | undefined;
  readonly start: number;
  readonly count: number;
}

function rangesOf({ geometry, material }: Mesh): Range[] {
  const all = geometry.index?.count ?? geometry.getAttribute("position").count;
  if (!Array.isArray(material)) return [{ material, start: 0, count: all }];
  if (geometry.groups.length === 0) return [{ material: material[0], start: 0, count: all }];
  // Groups of one material together: some writers make one for each face.
  const ranges: Range[] = [];
  for (const group of geometry.groups) {
    const last = ranges.at(-1);
    const own = material[group.materialIndex ?? 0];
    if (last && last.material === own && last.start + last.count === group.start) {
      ranges[ranges.length - 1] = { ...last, count: last.count + group.count };
    } else ranges.push({ material: own, start: group.start, count: group.count });
  }
  return ranges;
}

function trianglesOf(geometry: BufferGeometry, start: number, count: number, mirrored: boolean): Uint32Array {
  const { index } = geometry;
  const all = index?.count ?? geometry.getAttribute("position").count;
  const triangles = Math.max(0, Math.floor((Math.min(start + count, all) - start) / 3));
  const out = new Uint32Array(3 * triangles);
  for (let k = 0; k < out.length; k++) out[k] = index ? index.getX(start + k) : start + k;
  if (mirrored) for (let k = 0; k < out.length; k += 3) [out[k + 1], out[k + 2]] = [out[k + 2], out[k + 1]];
  return out;
}

/** In the world, in doubles: shape keys, then the skeleton, then where the mesh stands. */
function posed(mesh: Mesh, matrix: Matrix4): { positions: Float64Array; normals: Float32Array | null } {
  const position = mesh.geometry.getAttribute("position") as Attribute;
  const normal = mesh.geometry.getAttribute("normal") as Attribute | undefined;
  const positions = new Float64Array(3 * position.count);
  const normals = normal?.count === position.count ? new Float32Array(3 * position.count) : null;
  const turn = new Matrix3().getNormalMatrix(matrix);
  const bent = isSkinned(mesh) ? mesh : null;
  const [p, n, q] = [new Vector3(), new Vector3(), new Vector3()];
  for (let v = 0; v < position.count; v++) {
    mesh.getVertexPosition(v, p);
    if (normals && normal) {
      n.fromBufferAttribute(normal, v);
      // What the bones do to a direction: the same as to its end less its beginning.
      if (bent) n.copy(bent.applyBoneTransform(v, q.fromBufferAttribute(position, v).add(n))).sub(startOf(bent, v, q, position));
      n.applyMatrix3(turn)
        .normalize()
        .toArray(normals, 3 * v);
    }
    p.applyMatrix4(matrix).toArray(positions, 3 * v);
  }
  return { positions, normals: normals?.some((x) => x !== 0) && normals.every(Number.isFinite) ? normals : null };
}

function startOf(mesh: SkinnedMesh, v: number, out: Vector3, position: Attribute): Vector3 {
  return mesh.applyBoneTransform(v, out.fromBufferAttribute(position, v)) as Vector3;
}

/** v down, as in glTF. */
function flipped(uv: Attribute): Float32Array {
  const out = new Float32Array(2 * uv.count);
  for (let v = 0; v < uv.count; v++) {
    out[2 * v] = uv.getX(v);
    out[2 * v + 1] = 1 - uv.getY(v);
  }
  return out;
}

/** Null without, and where all are black: nobody paints a body black by its corners, but writers leave them empty. */
function colorsOf(geometry: BufferGeometry): Float32Array | null {
  const color = geometry.getAttribute("color") as Attribute | undefined;
  if (!color) return null;
  const out = new Float32Array(3 * color.count);
  for (let v = 0; v < color.count; v++) {
    out[3 * v] = unit(color.getX(v));
    out[3 * v + 1] = unit(color.getY(v));
    out[3 * v + 2] = unit(color.getZ(v));
  }
  return out.some((c) => c > 0) ? out : null;
}

function unit(c: number): number {
  return c >= 0 ? Math.min(c, 1) : 0;
}

/** N: the joint that moves a vertex most; null where there are none. */
function moversOf(mesh: Mesh, ofBone: ReadonlyMap<Object3D, number>): Int32Array | null {
  if (ofBone.size === 0) return null;
  let above: Object3D | null = mesh;
  while (above && !ofBone.has(above)) above = above.parent;
  const out = new Int32Array(mesh.geometry.getAttribute("position").count).fill(above ? (ofBone.get(above) ?? -1) : -1);
  if (!isSkinned(mesh)) return out;
  const [joints, weights] = [mesh.geometry.getAttribute("skinIndex"), mesh.geometry.getAttribute("skinWeight")];
  for (let v = 0; v < out.length; v++) {
    let [best, most] = [-1, 0];
    for (let k = 0; k < 4; k++) {
      const weight = weights.getComponent(v, k);
      if (weight > most) [best, most] = [joints.getComponent(v, k), weight];
    }
    out[v] = ofBone.get(mesh.skeleton.bones[best]) ?? -1;
  }
  return out;
}

function jointsOf(scene: Object3D): { joints: NamedJoint[]; ofBone: ReadonlyMap<Object3D, number> } {
  const joints: NamedJoint[] = [];
  const ofBone = new Map<Object3D, number>();
  const visit = (object: Object3D, parent: number | null): void => {
    let own = parent;
    if ("isBone" in object) {
      const { x, y, z } = new Vector3().setFromMatrixPosition(object.matrixWorld);
      own = joints.push({ name: object.name, parent, position: [x, y, z] }) - 1;
      ofBone.set(object, own);
    }
    for (const child of object.children) visit(child, own);
  };
  visit(scene, null);
  return { joints, ofBone };
}
