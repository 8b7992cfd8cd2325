import * as commands from "../document/commands";
import type { Gesture } from "../document/store";
import type { Axis, MeshRef, Settings, Solve } from "../document/types";
import type { Context } from "./context";
import { nextFacing, withUp } from "./facing";

export type { Axis } from "../document/types";

/** The project's name and sliders, and how the model stands. */
export class ProjectSettings {
  private slide: { key: string; gesture: Gesture } | null = null;

  constructor(private readonly context: Context) {}

  rename(name: string): void {
    this.context.history.apply(commands.renameProject(name));
  }

  /** While a slider is held, all its values are one step. */
  set<K extends keyof Settings>(key: K, value: Settings[K], held: boolean): void {
    if (held && this.slide?.key !== key) this.slide = { key, gesture: Symbol(key) };
    const gesture = this.slide?.key === key ? this.slide.gesture : undefined;
    this.context.history.apply(commands.setSettings({ [key]: value }), gesture);
    if (!held) this.slide = null;
  }

  /** A quarter turn. */
  turnModel(): void {
    const { facing, up } = this.context.document.mesh;
    this.turn({ facing: nextFacing(facing, up), up });
  }

  setUp(up: Axis): void {
    this.turn(withUp(this.context.document.mesh, up));
  }

  setSolve(solve: Solve): void {
    this.context.history.apply(commands.solveMesh(solve));
  }

  private turn({ facing, up }: Pick<MeshRef, "facing" | "up">): void {
    this.context.history.apply(commands.turnMesh(facing, up));
  }
}
