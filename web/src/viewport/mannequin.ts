// The human: white clay capsules, a fuller torso, an egg for a head, no face.

import {
  type Color,
  CustomBlending,
  CylinderGeometry,
  GreaterDepth,
  Group,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  NotEqualStencilFunc,
  OneFactor,
  Quaternion,
  ReplaceStencilOp,
  SphereGeometry,
  Vector3,
  ZeroFactor,
} from "three";
import { type BodyPlan, buildBodyPlan, highestLeaf } from "./body-plan";
import type { ContactShadow } from "./contact-shadow";
import { TorsoSkin } from "./torso-skin";
import type { DrawnHuman } from "../stage/port";

const UP = new Vector3(0, 1, 0);
const HEAD = { width: 0.1, height: 0.135, depth: 0.11 };

export class Mannequin {
  readonly group = new Group();
  readonly plan: BodyPlan;
  /** J x 3 world, what is drawn now. */
  pose: Float32Array | null = null;
  private readonly material = new MeshStandardMaterial({
    color: "#ffffff",
    emissive: "#dfe7ec",
    emissiveIntensity: 0.12,
    roughness: 0.75,
    metalness: 0,
    stencilWrite: true,
    stencilRef: 1,
    stencilZPass: ReplaceStencilOp,
  });
  /** Shows through the model where both stand on one spot; each pixel once, before the solid parts cover what is in front. */
  private readonly seenThrough = new MeshBasicMaterial({
    blending: CustomBlending, // kept among the opaque, so that the order holds
    blendSrcAlpha: ZeroFactor,
    blendDstAlpha: OneFactor,
    opacity: 0.6,
    fog: false,
    toneMapped: false,
    depthFunc: GreaterDepth,
    depthWrite: false,
    stencilWrite: true,
    stencilRef: 2,
    stencilFunc: NotEqualStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
  private readonly through = new Group();
  private readonly rods: InstancedMesh;
  private readonly balls: InstancedMesh;
  /** Joints with a ball, both ends of each capsule, and its radius. */
  private readonly ends = new Map<number, number>();
  private readonly head = new Mesh(eggGeometry(), this.material);
  private headThrough: Mesh | null = null;
  private readonly torso: TorsoSkin | null;
  private headJoint: number;
  private readonly matrix = new Matrix4();
  private readonly turn = new Quaternion();
  private readonly a = new Vector3();
  private readonly b = new Vector3();
  private readonly c = new Vector3();

  constructor(private readonly human: DrawnHuman) {
    this.plan = buildBodyPlan(human);
    this.headJoint = this.plan.head;
    const { bones, torso } = this.plan;
    this.rods = new InstancedMesh(new CylinderGeometry(1, 1, 1, 18, 1, true), this.material, bones.length);
    for (const { from, to, radius } of bones) {
      for (const joint of [from, to]) this.ends.set(joint, Math.max(radius, this.ends.get(joint) ?? 0));
    }
    this.balls = new InstancedMesh(new SphereGeometry(1, 18, 12), this.material, this.ends.size);
    this.torso = torso ? new TorsoSkin(torso, this.material) : null;
    const parts = [this.rods, this.balls, this.head, ...(this.torso ? [this.torso.mesh] : [])];
    for (const part of parts) {
      part.castShadow = part.receiveShadow = true;
      part.frustumCulled = false;
      part.renderOrder = 2;
      this.group.add(part);
      const shade = part instanceof InstancedMesh ? sharedInstances(part, this.seenThrough) : new Mesh(part.geometry, this.seenThrough);
      shade.frustumCulled = false;
      shade.renderOrder = 1;
      if (part === this.head) this.headThrough = shade;
      this.through.add(shade);
    }
    this.through.visible = false;
    this.group.add(this.through);
    this.group.visible = false;
  }

  setSeenThrough(on: boolean, colour: Color): void {
    this.through.visible = on;
    this.seenThrough.color.copy(colour);
  }

  /** Blue pencil: not real yet. Null: white clay. */
  setPencil(colour: Color | null): void {
    if (colour) {
      this.material.color.copy(colour);
      this.material.emissive.copy(colour);
    } else {
      this.material.color.set("#ffffff");
      this.material.emissive.set("#dfe7ec");
    }
    this.material.emissiveIntensity = colour ? 0.5 : 0.12;
  }

  setPose(pose: Float32Array): void {
    this.pose = pose;
    if (this.headJoint < 0) this.headJoint = highestLeaf(this.human, this.plan.joints, pose);
    this.group.visible = true;
    this.plan.bones.forEach((bone, i) => {
      const a = this.joint(bone.from, this.a);
      const b = this.joint(bone.to, this.b);
      const axis = this.c.subVectors(b, a);
      const length = axis.length();
      this.turn.setFromUnitVectors(UP, length > 1e-6 ? axis.divideScalar(length) : UP);
      this.matrix.compose(a.add(b).multiplyScalar(0.5), this.turn, b.set(bone.radius, Math.max(length, 1e-6), bone.radius));
      this.rods.setMatrixAt(i, this.matrix);
    });
    let ball = 0;
    for (const [joint, radius] of this.ends) {
      this.matrix.makeScale(radius, radius, radius).setPosition(this.joint(joint, this.a));
      this.balls.setMatrixAt(ball++, this.matrix);
    }
    this.rods.instanceMatrix.needsUpdate = true;
    this.balls.instanceMatrix.needsUpdate = true;
    this.placeHead();
    this.torso?.update(pose);
  }

  /** Darkens the ground under capsules that nearly touch it. */
  darken(shadow: ContactShadow): void {
    const { pose } = this;
    if (!pose) return;
    shadow.begin(pose[0]!, pose[2]!);
    for (const { from, to, radius } of this.plan.bones) {
      for (let t = 0; t <= 1; t += 0.25) {
        this.a.fromArray(pose, 3 * from).lerp(this.b.fromArray(pose, 3 * to), t);
        shadow.add(this.a.x, this.a.y - radius, this.a.z, radius);
      }
    }
    shadow.end();
  }

  /** How high the pose reaches, metres. */
  top(): number {
    const skull = this.head.visible ? this.head.position.y + HEAD.height : 0;
    return this.plan.joints.reduce((most, j) => Math.max(most, this.pose?.[3 * j + 1] ?? 0), skull);
  }

  /** Where a joint is seen: the head's in the middle of the egg. */
  seen(index: number, out: Vector3): Vector3 {
    return index === this.headJoint && this.head.visible ? out.copy(this.head.position) : this.joint(index, out);
  }

  joint(index: number, out: Vector3): Vector3 {
    return this.pose ? out.fromArray(this.pose, 3 * index) : out.set(0, 0, 0);
  }

  dispose(): void {
    for (const mesh of [this.rods, this.balls, this.head]) mesh.geometry.dispose();
    this.rods.dispose();
    this.balls.dispose();
    this.torso?.dispose();
    this.material.dispose();
    this.seenThrough.dispose();
  }

  /** Along head and end if the file has an end, else along neck and head. A short bone ends inside the skull, a long one on top of it. */
  private placeHead(): void {
    const { headTop } = this.plan;
    const from = headTop >= 0 ? this.headJoint : (this.human.parents[this.headJoint] ?? -1);
    const to = headTop >= 0 ? headTop : this.headJoint;
    this.head.visible = from >= 0 && to >= 0;
    if (!this.head.visible) return;
    const top = this.joint(to, this.a);
    const axis = this.c.subVectors(top, this.joint(from, this.b));
    const length = axis.length();
    if (length > 1e-6) axis.divideScalar(length);
    else axis.copy(UP);
    this.head.position.copy(top).addScaledVector(axis, length > 0.15 ? -0.9 * HEAD.height : 0.03);
    this.faceForward(axis);
  }

  /** The egg's depth runs across the shoulders' normal where there are shoulders. */
  private faceForward(axis: Vector3): void {
    const across = this.b.set(1, 0, 0);
    if (this.plan.torso) {
      across.copy(this.joint(this.plan.torso.leftShoulder, this.b)).sub(this.joint(this.plan.torso.rightShoulder, this.a));
    }
    across.addScaledVector(axis, -across.dot(axis)).normalize();
    this.matrix.makeBasis(across, axis, this.a.crossVectors(across, axis));
    this.head.quaternion.setFromRotationMatrix(this.matrix);
    this.headThrough?.position.copy(this.head.position);
    this.headThrough?.quaternion.copy(this.head.quaternion);
  }
}

/** The same instances in another material; the matrices are shared, not copied. */
function sharedInstances(mesh: InstancedMesh, material: Material): InstancedMesh {
  const copy = new InstancedMesh(mesh.geometry, material, mesh.count);
  copy.instanceMatrix = mesh.instanceMatrix;
  return copy;
}

/** An egg, blunt end up. */
function eggGeometry(): SphereGeometry {
  const egg = new SphereGeometry(1, 32, 24);
  const position = egg.getAttribute("position");
  for (let i = 0; i < position.count; i++) {
    const y = position.getY(i);
    const taper = 1 + 0.14 * y - 0.06 * y * y;
    position.setXYZ(i, HEAD.width * taper * position.getX(i), HEAD.height * y, HEAD.depth * taper * position.getZ(i));
  }
  egg.computeVertexNormals();
  return egg;
}
