import * as commands from "../document/commands";
import type { Gesture } from "../document/store";
import type { Settings } from "../document/types";
import type { Context } from "./context";

/** The project's name and sliders. */
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
}
