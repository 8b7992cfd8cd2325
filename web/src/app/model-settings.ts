// How the model stands, and what of it is solved. Not part of the first load.

import * as commands from "../document/commands";
import type { Axis, MeshRef, Solve } from "../document/types";
import type { Context } from "./context";
import { nextFacing, withUp } from "./facing";

export type { Axis } from "../document/types";

export class ModelSettings {
  constructor(private readonly context: Context) {}

  /** A quarter turn. */
  turn(): void {
    const { facing, up } = this.context.document.mesh;
    this.stand({ facing: nextFacing(facing, up), up });
  }

  setUp(up: Axis): void {
    this.stand(withUp(this.context.document.mesh, up));
  }

  setSolve(solve: Solve): void {
    this.context.history.apply(commands.solveMesh(solve));
  }

  private stand({ facing, up }: Pick<MeshRef, "facing" | "up">): void {
    this.context.history.apply(commands.turnMesh(facing, up));
  }
}
