import type { ProjectDocument } from "../document/types";
import type { PanelName } from "./panels";
import type { Signals } from "./signals";

/** The timeline's row of flights, which is selected as points are. */
export const FLIGHTS = "flights";

/** What the person looks at: the selected point, the open panel, the layout of the stage, the intro and the help. */
export class Selection {
  /** A point's id, or FLIGHTS. */
  point: string | null = null;
  panel: PanelName | null = null;
  layout: "side" | "overlay" = "side";
  /** The view goes around by itself. */
  turning = false;
  intro = false;
  help = false;

  constructor(private readonly signals: Signals) {}

  select(point: string | null): void {
    if (point === this.point) return;
    this.point = point;
    this.signals.tell("selection");
  }

  /** A point that is gone is selected no more. */
  follow({ points }: ProjectDocument): void {
    if (this.point !== FLIGHTS && !points.some(({ id }) => id === this.point)) this.point = null;
  }

  setPanel(panel: PanelName | null): void {
    this.panel = panel;
    this.signals.tell("panel");
  }

  /** Opens a panel, or closes it if it is the one that is open. */
  togglePanel(panel: PanelName): void {
    this.setPanel(this.panel === panel ? null : panel);
  }

  setLayout(layout: "side" | "overlay"): void {
    this.layout = layout;
    this.signals.tell("layout");
  }

  setTurning(turning: boolean): void {
    this.turning = turning;
    this.signals.tell("layout");
  }

  setHelp(help: boolean): void {
    if (help === this.help) return;
    this.help = help;
    this.signals.tell("help");
  }

  beginIntro(): void {
    this.intro = true;
    this.signals.tell("intro");
  }

  /** The first line has been understood. */
  endIntro(): void {
    if (!this.intro) return;
    this.intro = false;
    this.signals.tell("intro");
  }
}
