// What the page is doing now, put together: each part gets what it needs, and none of them knows the session. The elements
// draw it and call it; it knows no element.

import type { ProjectDocument } from "../document/types";
import type { Performance } from "../engine/types";
import type { StagePort } from "../stage/port";
import { createActions } from "./actions";
import { Builtins } from "./builtins";
import { Cast } from "./cast";
import { Contacts } from "./contacts";
import { Context } from "./context";
import { Coverage } from "./coverage";
import { Dragging } from "./dragging";
import type { Duet } from "./duet";
import { Guesses } from "./guesses";
import type { History } from "./history";
import { Jobs } from "./jobs";
import type { Keeping } from "./keeping";
import type { MotionEditing } from "./motion-editing";
import { Motions } from "./motions";
import { Opening } from "./opening";
import { Pairing } from "./pairing";
import { Pins } from "./pins";
import { Playback } from "./playback";
import type { Player } from "./player";
import { Points } from "./points";
import type { Ports } from "./ports";
import { Poses } from "./poses";
import { Presenter } from "./presenter";
import { ProjectSettings } from "./project-settings";
import { Saving } from "./saving";
import { Sources } from "./sources";
import type { Selection } from "./selection";
import type { Song } from "./song";
import type { Signals } from "./signals";
import { listenToStage } from "./stage-input";
import { Thumbnails } from "./thumbnails";

export class Session {
  readonly context = new Context(this.ports);
  readonly jobs = new Jobs();
  readonly builtins = new Builtins(this.ports.assets);
  readonly sources = new Sources(this.context.workspace.library);
  readonly cast = new Cast(this.context, this.builtins);
  readonly motions = new Motions(this.context, this.builtins);
  readonly playback = new Playback(this.context, !this.ports.calm);
  readonly settings = new ProjectSettings(this.context);
  readonly dragging: Dragging = new Dragging(this.context, (dropped) => (this.pins.armed ? this.pins : this.poses).take(dropped));
  readonly points = new Points(this.context);
  readonly poses = new Poses(this.context, this.dragging);
  readonly pins = new Pins(this.context, this.dragging);
  readonly contacts = new Contacts(this.context);
  readonly coverage = new Coverage(this.context, this.poses);
  readonly guesses = new Guesses(this.context);
  readonly pairing = new Pairing(this.context, this.points, this.guesses);
  readonly presenter = new Presenter(this.context, this);
  readonly thumbnails = new Thumbnails(this.context, this.poses, this.dragging, this.presenter, this.ports.clock);
  readonly opening = new Opening(this.context, this, this.ports);
  readonly saving = new Saving(this.context, this, this.ports);
  readonly actions = createActions(this);
  /** Here once there is something to keep. */
  keeping: Keeping | null = null;
  /** Here once somebody looked at a motion. */
  editing: MotionEditing | null = null;

  /** Here once a song came. */
  song: Song | null = null;
  /** Here once somebody danced beside. */
  duet: Duet | null = null;

  private kept: Promise<Keeping> | undefined;

  constructor(private readonly ports: Ports) {
    this.signals.on("document", () => {
      if (this.history.touched && !this.keeping) void this.keep();
      if (this.document.companion) void this.accompany();
    });
    this.signals.on("song", () => void this.keep());
    this.jobs.on("change", () => this.signals.tell("jobs"));
    this.sayWhatTheEngineSays();
  }

  /**
   * Begins with what a link holds, what the browser keeps, or else the cactus. The stage is built while the engine bakes: its
   * shaders keep the page busy, and the engine would wait for its orders behind them.
   */
  async start(buildStage: () => StagePort): Promise<void> {
    const { selection, workspace } = this.context;
    const { address, memory } = this.ports;
    if (!memory.kept) selection.beginIntro();
    const build = (): void => {
      if (!this.presenter.hasStage) this.build(buildStage);
    };
    workspace.on("performance", () => setTimeout(build)); // after the engine has been told to bake
    if (address.link && (await (await import("./link-opening")).openLink(this.context, this, this.ports))) return;
    if (memory.kept && (await (await this.keep()).resume())) return;
    if (!(await this.opening.first())) build();
  }

  close(): void {
    this.context.player.pause();
    this.context.workspace.close();
    this.duet?.close();
    this.presenter.close();
  }

  get signals(): Signals {
    return this.context.signals;
  }
  get player(): Player {
    return this.context.player;
  }
  get selection(): Selection {
    return this.context.selection;
  }
  get history(): History {
    return this.context.history;
  }
  get document(): ProjectDocument {
    return this.context.document;
  }
  get performance(): Performance | null {
    return this.context.performance;
  }
  /** The page asks for something, or speaks of a pin. */
  get asks(): boolean {
    const { selection, pairing, coverage, pins } = this;
    return (selection.panel === "points" && pairing.asks) || coverage.asking !== null || pins.chosen !== null || pins.armed;
  }

  async music(): Promise<Song> {
    const { Song } = await import("./song");
    return (this.song ??= new Song(this.context, this.ports));
  }

  async accompany(): Promise<Duet> {
    const { Duet } = await import("./duet");
    return (this.duet ??= new Duet(this.context, this, this.ports));
  }

  private async keep(): Promise<Keeping> {
    this.kept ??= import("./keeping").then(({ Keeping }) => (this.keeping = new Keeping(this.context, this, this.ports)));
    const keeping = await this.kept;
    keeping.later();
    return keeping;
  }

  private build(buildStage: () => StagePort): void {
    try {
      const stage = buildStage();
      listenToStage(stage, this.context, this);
      this.presenter.attach(stage);
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      this.context.notices.say({
        bad: true,
        title: "This browser shows no 3D graphics.",
        text: `Turn on hardware acceleration or try another browser. (${why})`,
      });
    }
  }

  private sayWhatTheEngineSays(): void {
    const { workspace, notices } = this.context;
    workspace.on("failed", (error) => notices.say({ bad: true, title: error.message, text: "The dance is as it was before." }));
    workspace.on("recovered", () =>
      notices.say({ title: "The solver had to be started again.", text: "Everything you made is still here." }),
    );
  }
}
