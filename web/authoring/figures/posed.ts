// A dance as a GLB holds it, posed on the processor: whichever way the file moves its vertices (morph targets, a skin, nodes), the
// same numbers are measured and drawn.

import { AnimationMixer, BufferAttribute, BufferGeometry, Group, type Material, Matrix3, Matrix4, Mesh, SkinnedMesh, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

interface Part {
  source: Mesh;
  drawn: Mesh;
  /** Vertices before this part's. */
  first: number;
  count: number;
}

export class PosedDance {
  readonly group = new Group();
  /** F x 3 over all parts' vertices. */
  readonly faces: Uint32Array;
  readonly vertices: number;
  /** Seconds of the kept frames. */
  readonly times: readonly number[];
  private readonly parts: Part[] = [];

  static async load(url: string): Promise<PosedDance> {
    const { scene, animations } = await new GLTFLoader().loadAsync(url);
    const mixer = new AnimationMixer(scene);
    for (const clip of animations) mixer.clipAction(clip).play();
    const times = [...new Set(animations.flatMap((clip) => clip.tracks.flatMap((track) => [...track.times])))].sort((a, b) => a - b);
    return new PosedDance(scene as Group, mixer, times);
  }

  private constructor(
    private readonly scene: Group,
    private readonly mixer: AnimationMixer,
    times: readonly number[],
  ) {
    this.times = times;
    const faces: number[][] = [];
    let first = 0;
    scene.updateMatrixWorld(true);
    scene.traverse((node) => {
      if (!(node instanceof Mesh)) return;
      const geometry = node.geometry as BufferGeometry;
      const { count } = geometry.attributes.position;
      const index = geometry.index ? [...geometry.index.array] : Array.from({ length: count }, (_, i) => i);
      faces.push(index.map((i) => i + first));
      this.parts.push({ source: node, drawn: drawnCopy(node), first, count });
      first += count;
    });
    this.faces = Uint32Array.from(faces.flat());
    this.vertices = first;
    for (const { drawn } of this.parts) this.group.add(drawn);
  }

  /** V x 3 world at a time; null is the file's rest. Normals go to what is drawn. */
  at(time: number | null): Float32Array {
    if (time !== null) this.mixer.setTime(time);
    this.scene.updateMatrixWorld(true);
    const out = new Float32Array(3 * this.vertices);
    for (const part of this.parts) {
      pose(part, "position", out.subarray(3 * part.first, 3 * (part.first + part.count)));
      const normal = part.drawn.geometry.attributes.normal;
      if (normal) pose(part, "normal", normal.array as Float32Array);
    }
    return out;
  }

  /** Draws places that `at` has just given, moved by an offset. */
  show(places: Float32Array, offset: Vector3): void {
    this.group.position.copy(offset);
    for (const { drawn, first, count } of this.parts) {
      const { position, normal } = drawn.geometry.attributes;
      (position.array as Float32Array).set(places.subarray(3 * first, 3 * (first + count)));
      position.needsUpdate = true;
      if (normal) normal.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const { source, drawn } of this.parts) {
      source.geometry.dispose();
      drawn.geometry.dispose();
      for (const material of [drawn.material].flat()) disposeMaterial(material);
    }
  }
}

function disposeMaterial(material: Material): void {
  for (const value of Object.values(material)) {
    if (value && typeof value === "object" && "isTexture" in value) (value as unknown as { dispose(): void }).dispose();
  }
  material.dispose();
}

function drawnCopy(source: Mesh): Mesh {
  const from = source.geometry as BufferGeometry;
  const geometry = new BufferGeometry();
  const { count } = from.attributes.position;
  geometry.setIndex(from.index);
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
  if (from.attributes.normal) geometry.setAttribute("normal", new BufferAttribute(new Float32Array(3 * count), 3));
  for (const name of ["uv", "uv1", "color"]) if (from.attributes[name]) geometry.setAttribute(name, from.attributes[name]);
  const mesh = new Mesh(geometry, source.material);
  mesh.frustumCulled = false;
  return mesh;
}

/** One attribute of a part in the world: morph targets, then bones, then the node. */
function pose({ source, count }: Part, name: "position" | "normal", out: Float32Array): void {
  const geometry = source.geometry as BufferGeometry;
  const base = geometry.attributes[name];
  for (let i = 0; i < count; i++) {
    out[3 * i] = base.getX(i);
    out[3 * i + 1] = base.getY(i);
    out[3 * i + 2] = base.getZ(i);
  }
  (source.morphTargetInfluences ?? []).forEach((weight, k) => {
    const target = geometry.morphAttributes[name]?.[k];
    if (weight === 0 || !target) return;
    for (let i = 0; i < count; i++) {
      out[3 * i] += weight * target.getX(i);
      out[3 * i + 1] += weight * target.getY(i);
      out[3 * i + 2] += weight * target.getZ(i);
    }
  });
  const direction = name === "normal";
  if (source instanceof SkinnedMesh) skin(source, out, direction);
  transform(source.matrixWorld, out, direction);
}

function skin(mesh: SkinnedMesh, out: Float32Array, direction: boolean): void {
  const { skinIndex, skinWeight } = mesh.geometry.attributes;
  const bones = mesh.skeleton.bones.map((bone, k) =>
    new Matrix4()
      .copy(mesh.bindMatrixInverse)
      .multiply(bone.matrixWorld)
      .multiply(mesh.skeleton.boneInverses[k])
      .multiply(mesh.bindMatrix)
      .toArray(),
  );
  const one = direction ? 0 : 1;
  const sum = [0, 0, 0];
  for (let i = 0; i < skinIndex.count; i++) {
    const [x, y, z] = [out[3 * i], out[3 * i + 1], out[3 * i + 2]];
    sum.fill(0);
    let total = 0;
    for (let k = 0; k < 4; k++) {
      const weight = skinWeight.getComponent(i, k);
      if (weight === 0) continue;
      const m = bones[skinIndex.getComponent(i, k)];
      for (let r = 0; r < 3; r++) sum[r] += weight * (m[r] * x + m[4 + r] * y + m[8 + r] * z + one * m[12 + r]);
      total += weight;
    }
    for (let r = 0; r < 3; r++) out[3 * i + r] = sum[r] / (total || 1);
  }
}

function transform(matrix: Matrix4, out: Float32Array, direction: boolean): void {
  const turned = new Matrix3().getNormalMatrix(matrix);
  const v = new Vector3();
  for (let i = 0; i < out.length; i += 3) {
    v.set(out[i], out[i + 1], out[i + 2]);
    if (direction) v.applyMatrix3(turned).normalize();
    else v.applyMatrix4(matrix);
    v.toArray(out, i);
  }
}
