// Everything that a key, a button of the bars or a menu does: one table, which keys, help, tooltips and menus read.

import type { Context } from "./context";
import type { Coverage } from "./coverage";
import type { Dragging } from "./dragging";
import type { Opening } from "./opening";
import type { Pairing } from "./pairing";
import { PANELS } from "./panels";
import type { PanelName } from "./panels";
import type { Pins } from "./pins";
import type { Playback } from "./playback";
import type { Points } from "./points";
import type { Poses } from "./poses";
import type { Presenter } from "./presenter";
import type { Saving } from "./saving";

type Fixed =
  | "save"
  | "open"
  | "export"
  | "undo"
  | "redo"
  | "play"
  | "frameBack"
  | "frameOn"
  | "poseBefore"
  | "poseAfter"
  | "addPose"
  | "pin"
  | "armPin"
  | "mirror"
  | "answer"
  | "loop"
  | "speed"
  | "fit"
  | "threeQuarter"
  | "side"
  | "top"
  | "turn"
  | "help"
  | "escape"
  | "delete";

export type ActionId = Fixed | PanelName;

export interface Action {
  readonly id: ActionId;
  /** What its button says. */
  readonly label: string | (() => string);
  /** What the pointer reads over its button; left out: the label. */
  readonly title?: string;
  /** What the sheet of keys says; neighbours that say the same share a row. Left out: the label. */
  readonly help?: string;
  /** The first is the one that is shown. As "Ctrl+Shift+Z"; letters are capital, Ctrl is also Cmd. */
  readonly keys: readonly string[];
  /** Also while a field of text has the focus. */
  readonly whileTyping?: boolean;
  /** A button that has the focus keeps the key for itself. */
  readonly leftToButtons?: boolean;
  readonly enabled: () => boolean;
  readonly run: () => void;
}

/** What the actions act on. */
export interface Actors {
  readonly context: Context;
  readonly opening: Opening;
  readonly saving: Saving;
  readonly playback: Playback;
  readonly dragging: Dragging;
  readonly points: Points;
  readonly pairing: Pairing;
  readonly poses: Poses;
  readonly pins: Pins;
  readonly coverage: Coverage;
  readonly presenter: Presenter;
}

/** By id; the order is the one in which help lists them. */
export type Actions = Readonly<Record<ActionId, Action>>;

const VIEWS = "From three quarters, the side, the top";

type Row = Omit<Action, "id" | "keys" | "enabled"> & Partial<Pick<Action, "keys" | "enabled">>;

export function createActions(actors: Actors): Actions {
  const { context, coverage, dragging, opening, pins, playback, points, poses, presenter, saving } = actors;
  const { history, player, selection } = context;
  const danced = (): boolean => context.performance !== null;
  const held = (): boolean => dragging.active !== null;
  const posed = (): boolean => poses.here.length > 0;
  const escapes = escapesOf(actors);
  const rows: Record<ActionId, Row> = {
    play: {
      label: () => (player.playing ? "Pause" : "Play"),
      help: "Play, pause",
      keys: ["Space"],
      leftToButtons: true,
      enabled: () => player.frames > 0,
      run: () => playback.toggle(),
    },
    frameBack: { label: "One frame back", help: "One frame back, on", keys: [","], run: () => player.step(-1) },
    frameOn: { label: "One frame on", help: "One frame back, on", keys: ["."], run: () => player.step(1) },
    poseBefore: { label: "Previous pose", help: "Pose before, after", keys: ["["], enabled: posed, run: () => poses.step(-1) },
    poseAfter: { label: "Next pose", help: "Pose before, after", keys: ["]"], enabled: posed, run: () => poses.step(1) },
    addPose: {
      label: "Add pose",
      title: "Add a pose at this frame",
      help: "Add a pose here",
      keys: ["K"],
      enabled: danced,
      run: () => poses.add(),
    },
    answer: {
      label: "Keep pose",
      help: "Keep the pose that is asked for",
      keys: ["Enter"],
      leftToButtons: true,
      enabled: () => coverage.asking !== null,
      run: () => coverage.answer(),
    },
    pin: {
      label: "Pin here",
      help: "Pin the point in hand, or the selected one, here",
      keys: ["C"],
      enabled: danced,
      run: () => pins.add(),
    },
    armPin: {
      label: "Pin",
      title: "The next drag pins a point at this frame and makes no pose",
      enabled: danced,
      run: () => pins.arm(!pins.armed),
    },
    mirror: {
      label: "Mirror",
      help: "While holding a dot: its partner mirrors it",
      keys: ["M"],
      enabled: held,
      run: () => dragging.mirror(),
    },
    ...panelRows(actors),
    fit: {
      label: "Fit",
      title: "Fit the view, from the front",
      help: "Fit the view, from the front",
      keys: ["F"],
      run: () => presenter.fit(),
    },
    threeQuarter: { label: "Three quarters", help: VIEWS, keys: ["Q"], run: () => presenter.fit("three-quarter") },
    side: { label: "Side", help: VIEWS, keys: ["S"], run: () => presenter.fit("side") },
    top: { label: "Top", help: VIEWS, keys: ["T"], run: () => presenter.fit("top") },
    turn: { label: "Goes around", help: "The view goes around, slowly", keys: ["R"], run: () => selection.setTurning(!selection.turning) },
    escape: {
      label: "Let go",
      help: "Let go of a dot, close what is open",
      keys: ["Escape"],
      enabled: () => escapes.some(([there]) => there()),
      run: () => escapes.find(([there]) => there())?.[1](),
    },
    delete: {
      label: "Delete",
      help: "Delete the selected point or pin",
      keys: ["Delete"],
      enabled: () => pins.chosen !== null || (points.selected !== null && !held()),
      run: () => {
        if (pins.chosen !== null) pins.remove(pins.chosen);
        else if (points.selected !== null) points.remove(points.selected);
      },
    },
    undo: { label: "Undo", keys: ["Ctrl+Z"], enabled: () => history.canUndo || held(), run: () => history.undo() },
    redo: { label: "Redo", keys: ["Ctrl+Shift+Z", "Ctrl+Y"], enabled: () => history.canRedo || held(), run: () => history.redo() },
    open: { label: "Open", help: "Open files", keys: ["Ctrl+O"], whileTyping: true, run: () => void opening.pick() },
    save: { label: "Save", help: "Save the project file", keys: ["Ctrl+S"], whileTyping: true, run: () => void saving.save() },
    export: { label: "Export", enabled: danced, run: () => void saving.openExport() },
    loop: { label: "Loop", run: () => player.setLoop(!player.loop) },
    speed: { label: "Speed", title: "How fast you watch. The dance's own speed is set in Motion.", run: () => player.nextSpeed() },
    help: { label: "Help and keys", keys: ["?"], run: () => selection.setHelp(true) },
  };
  const actions = Object.entries(rows).map(([id, row]) => [id, { id, keys: [], enabled: () => true, ...row }]);
  return Object.fromEntries(actions) as Actions;
}

function panelRows({ context: { selection } }: Actors): Record<PanelName, Row> {
  const rows = PANELS.map(({ id, name }, k): [PanelName, Row] => [
    id,
    { label: name, help: "Model, motion, points, poses", keys: [`${k + 1}`], run: () => selection.togglePanel(id) },
  ]);
  return Object.fromEntries(rows) as Record<PanelName, Row>;
}

/** What can be put away, and how; of what is there the first goes. */
function escapesOf({ context, coverage, dragging, pairing, pins }: Actors): readonly (readonly [() => boolean, () => void])[] {
  const { selection } = context;
  return [
    [() => dragging.active !== null, () => dragging.cancel()],
    [() => selection.help, () => selection.setHelp(false)],
    [() => coverage.asking !== null, () => coverage.skip()],
    [() => pins.armed, () => pins.arm(false)],
    [() => pins.chosen !== null, () => pins.choose(null)],
    [() => pairing.asks, () => pairing.stop()],
    [() => selection.panel !== null, () => selection.setPanel(null)],
    [() => selection.point !== null, () => selection.select(null)],
  ];
}

export function labelOf({ label }: Action): string {
  return typeof label === "string" ? label : label();
}

/** "Undo (Ctrl+Z)" */
export function titleOf(action: Action): string {
  const words = action.title ?? labelOf(action);
  const [key] = action.keys;
  return key === undefined ? words : `${words} (${key})`;
}

/** The keys of an action as keyboards name them: ["Ctrl", "Z"], ["Esc"]. */
export function capsOf({ keys: [key = ""] }: Action): readonly string[] {
  return key.split("+").map((cap) => ({ Escape: "Esc", Delete: "Del" })[cap] ?? cap);
}

/** As the aria-keyshortcuts attribute wants them; null without keys. */
export function shortcutsOf({ keys }: Action): string | null {
  return keys.length === 0 ? null : keys.map((key) => key.replace("Ctrl", "Control")).join(" ");
}

/** The sheet of keys: what each row says and the caps of its keys. */
export function helpRows(actions: Actions): readonly { words: string; caps: readonly string[] }[] {
  const rows: { words: string; caps: string[] }[] = [];
  for (const action of Object.values(actions)) {
    if (action.keys.length === 0) continue;
    const words = action.help ?? labelOf(action);
    const last = rows.at(-1);
    if (last?.words === words) last.caps.push(...capsOf(action));
    else rows.push({ words, caps: [...capsOf(action)] });
  }
  return rows;
}
