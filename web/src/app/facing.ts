import { facingFor } from "../document/stage-transform";
import type { Axis, MeshRef } from "../document/types";

const TURNS: Readonly<Record<string, readonly Axis[]>> = {
  x: ["+y", "+z", "-y", "-z"],
  y: ["+z", "+x", "-z", "-x"],
  z: ["-y", "+x", "+y", "-x"],
};

/** A quarter turn further about the up axis. */
export function nextFacing(facing: Axis, up: Axis): Axis {
  const ring = TURNS[up.charAt(1)] ?? [];
  return ring[(ring.indexOf(facingFor(facing, up)) + 1) % ring.length] ?? facing;
}

/** Another axis up; the facing that this leaves. */
export function withUp(mesh: MeshRef, up: Axis): MeshRef {
  return { ...mesh, up, facing: facingFor(mesh.facing, up) };
}
