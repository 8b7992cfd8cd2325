// Which objects of a tree are joints of the one that moves.

import { type AnimationClip, type Object3D, PropertyBinding } from "three";

export interface Joint {
  readonly object: Object3D;
  /** Index of one before it; -1 for the root. */
  readonly parent: number;
}

/** Each after its parent, one root. Bones where there are any, else what the clips move and what stands between; empty: nothing moves. */
export function jointsOfTree(tree: Object3D, clips: readonly AnimationClip[]): Joint[] {
  const moved = movedBy(tree, clips);
  if (moved.size === 0) return [];
  const bones = new Set<Object3D>();
  tree.traverse((object) => void ("isBone" in object && bones.add(object)));
  const wanted = [...bones].some((bone) => pathOf(bone).some((object) => moved.has(object))) ? bones : skeletonOf(tree, moved);
  const roots = [...wanted].filter((object) => !pathOf(object.parent).some((above) => wanted.has(above)));
  const own = (root: Object3D): number => [...wanted].filter((object) => pathOf(object).includes(root)).length;
  const largest = roots.find((root) => 2 * own(root) > wanted.size);
  const root = largest ?? sharedParent(roots) ?? tree;
  wanted.add(root);
  const joints: Joint[] = [];
  const visit = (object: Object3D, above: number): void => {
    const index = wanted.has(object) ? joints.push({ object, parent: above }) - 1 : above;
    for (const child of object.children) visit(child, index);
  };
  visit(root, -1);
  return joints;
}

/** The objects that a clip moves. */
export function movedBy(tree: Object3D, clips: readonly AnimationClip[]): Set<Object3D> {
  const moved = new Set<Object3D>();
  for (const { tracks } of clips) {
    for (const { name } of tracks) {
      const { nodeName, propertyName } = PropertyBinding.parseTrackName(name);
      if (!/^(position|quaternion|scale)$/.test(propertyName)) continue;
      const object: unknown = PropertyBinding.findNode(tree, nodeName);
      if (object && object !== tree) moved.add(object as Object3D);
    }
  }
  return moved;
}

/** What moves, and what shows nothing and hangs together with it: ends, and joints that happen to stay. */
function skeletonOf(tree: Object3D, moved: ReadonlySet<Object3D>): Set<Object3D> {
  const top = sharedParent([...moved]) ?? tree;
  const out = new Set(moved);
  top.traverse((object) => void (object.userData.shows !== true && !("isMesh" in object) && out.add(object)));
  return out;
}

/** The lowest object that all hang on, or that is one of them. */
function sharedParent(objects: readonly Object3D[]): Object3D | undefined {
  const [first, ...others] = objects;
  const paths = others.map((object) => new Set(pathOf(object)));
  return pathOf(first ?? null).find((above) => paths.every((path) => path.has(above)));
}

/** From an object up. */
function pathOf(object: Object3D | null): Object3D[] {
  const path: Object3D[] = [];
  for (let o = object; o; o = o.parent) path.push(o);
  return path;
}
