// The mannequin's trunk: a rounded skin from hips to shoulders, bent along the spine; rings across it, wider at both ends than
// at the waist.

import { type BufferAttribute, DynamicDrawUsage, Mesh, type MeshStandardMaterial, PlaneGeometry, Vector3 } from "three";
import type { Torso } from "./body-plan";

const RINGS = 14;
const SIDES = 24;

export class TorsoSkin {
  readonly mesh: Mesh<PlaneGeometry, MeshStandardMaterial>;
  private readonly position: BufferAttribute;
  private readonly points = {
    leftHip: new Vector3(),
    rightHip: new Vector3(),
    leftShoulder: new Vector3(),
    rightShoulder: new Vector3(),
    middle: new Vector3(),
    pelvis: new Vector3(),
    chest: new Vector3(),
    centre: new Vector3(),
    along: new Vector3(),
    across: new Vector3(),
    out: new Vector3(),
  };

  constructor(
    private readonly torso: Torso,
    material: MeshStandardMaterial,
  ) {
    const geometry = new PlaneGeometry(1, 1, SIDES, RINGS - 1); // only its grid of triangles
    this.position = geometry.getAttribute("position") as BufferAttribute;
    this.position.setUsage(DynamicDrawUsage);
    this.mesh = new Mesh(geometry, material);
  }

  update(pose: Float32Array): void {
    const { leftHip, rightHip, leftShoulder, rightShoulder, middle, pelvis, chest, centre, along, across, out } = this.points;
    leftHip.fromArray(pose, 3 * this.torso.leftHip);
    rightHip.fromArray(pose, 3 * this.torso.rightHip);
    leftShoulder.fromArray(pose, 3 * this.torso.leftShoulder);
    rightShoulder.fromArray(pose, 3 * this.torso.rightShoulder);
    middle.fromArray(pose, 3 * this.torso.middle);
    const hips = 0.5 * leftHip.distanceTo(rightHip) + 0.055;
    const shoulders = 0.5 * leftShoulder.distanceTo(rightShoulder) - 0.005;
    pelvis.addVectors(leftHip, rightHip).multiplyScalar(0.5);
    chest.addVectors(leftShoulder, rightShoulder).multiplyScalar(0.5);
    const bend = middle.multiplyScalar(2).addScaledVector(pelvis, -0.5).addScaledVector(chest, -0.5);
    pelvis.addScaledVector(along.subVectors(bend, pelvis).normalize(), -0.075);
    chest.addScaledVector(along.subVectors(chest, bend).normalize(), 0.045);
    const hipLine = leftHip.sub(rightHip).normalize();
    const shoulderLine = leftShoulder.sub(rightShoulder).normalize();

    for (let ring = 0; ring < RINGS; ring++) {
      const angle = (Math.PI * ring) / (RINGS - 1);
      const t = 0.5 - 0.5 * Math.cos(angle); // rings crowd where the ends close
      const s = 1 - t;
      centre
        .set(0, 0, 0)
        .addScaledVector(pelvis, s * s)
        .addScaledVector(bend, 2 * s * t)
        .addScaledVector(chest, t * t);
      along.copy(bend).sub(pelvis).multiplyScalar(s).addScaledVector(chest, t).addScaledVector(bend, -t).normalize();
      across.copy(hipLine).multiplyScalar(s).addScaledVector(shoulderLine, t);
      across.addScaledVector(along, -across.dot(along)).normalize();
      out.crossVectors(across, along);
      const close = Math.pow(Math.max(0, Math.sin(angle)), 0.35);
      const waist = 1 - 0.42 * Math.sin(Math.PI * t) * (1 - 0.35 * t);
      const width = close * (s * hips + t * shoulders) * Math.max(waist, 0.72);
      const depth = close * (0.098 * s + 0.1 * t) * (1 - 0.12 * Math.sin(Math.PI * t));
      for (let side = 0; side <= SIDES; side++) {
        const turn = (-2 * Math.PI * side) / SIDES; // so that faces look outwards
        const x = width * Math.cos(turn);
        const z = depth * Math.sin(turn);
        this.position.setXYZ(
          (RINGS - 1 - ring) * (SIDES + 1) + side,
          centre.x + x * across.x + z * out.x,
          centre.y + x * across.y + z * out.y,
          centre.z + x * across.z + z * out.z,
        );
      }
    }
    this.position.needsUpdate = true;
    this.mesh.geometry.computeVertexNormals();
    this.closeSeam();
  }

  /** The first and the last column are the same line. */
  private closeSeam(): void {
    const normal = this.mesh.geometry.getAttribute("normal");
    const { along: a, across: b } = this.points;
    for (let ring = 0; ring < RINGS; ring++) {
      const first = ring * (SIDES + 1);
      a.fromBufferAttribute(normal, first)
        .add(b.fromBufferAttribute(normal, first + SIDES))
        .normalize();
      normal.setXYZ(first, a.x, a.y, a.z);
      normal.setXYZ(first + SIDES, a.x, a.y, a.z);
    }
  }

  dispose(): void {
    this.mesh.geometry.dispose();
  }
}
