// What a change of the document sounds like, for whoever does not see it.

import { saidOf, startOf } from "../document/clips";
import type { ClipEdits, ProjectDocument, Settings } from "../document/types";
import { count, figure, move, stem } from "../util/words";
import { sayLater } from "./beside-words";
import type { Context } from "./context";
import type { Drag, Dragging } from "./dragging";

const CLIP: { readonly [K in keyof Required<ClipEdits>]: (said: ClipEdits) => string } = {
  file: () => "Facts of the file changed",
  cut: ({ cut }) => (cut ? `Danced from frame ${cut[0]} to ${cut[1]} of the file` : "All of it is danced"),
  speed: ({ speed = 1 }) => `Speed ${speed} times`,
  mirror: ({ mirror }) => (mirror ? "Mirrored" : "Not mirrored"),
  loop: ({ loop }) => (loop ? "A loop" : "Not a loop"),
  pins: ({ pins = [] }) => count(pins.length, "pin"),
  contacts: () => "Ground contacts changed",
  flights: () => "Flights changed",
};

/** Says what became of the document by each change; a drag with its way, as in "Left hand 3 cm up, 4 poses". */
export class Spoken {
  private held: Drag | null = null;

  constructor(
    private readonly context: Context,
    dragging: Dragging,
  ) {
    context.signals.on("drag", () => {
      const { active } = dragging;
      if (active) this.held = active;
      else void Promise.resolve().then(() => (this.held = null)); // a drop becomes a pose before that, a cancelled drag never
    });
  }

  /** "" where nothing is worth a word. */
  of(before: ProjectDocument): string {
    const { document } = this.context;
    return [
      before.name === document.name ? "" : `The project is ${document.name}`,
      before.mesh === document.mesh ? "" : stem(document.mesh.file),
      duet(before, document),
      before.motion === document.motion ? "" : stem(document.motion.files.at(-1) ?? ""),
      points(before, document) || this.poses(before), // a point that goes is forgotten by the poses
      ...settings(before.settings, document.settings),
      ...clip(saidOf(before), saidOf(document)),
    ]
      .filter(Boolean)
      .join(", ");
  }

  private poses(before: ProjectDocument): string {
    const { document } = this.context;
    const [was, is] = [before.examples, document.examples];
    if (was === is) return "";
    const gone = was.find(({ id }) => !is.some((pose) => pose.id === id));
    const other = is.find((pose) => !was.includes(pose)) ?? gone;
    if (!other) return "";
    const at = `Pose at frame ${other.source.frame - startOf(document)}`;
    const what = other === gone ? `${at} is gone` : (this.moved() ?? at);
    return `${what}, ${count(is.length, "pose")}`;
  }

  private moved(): string | null {
    const { held } = this;
    const name = held && this.context.document.points.find(({ id }) => id === held.id)?.name;
    if (!held || !name) return null;
    const { from, to } = held;
    return `${name} ${move([to[0] - from[0], to[1] - from[1], to[2] - from[2]])}`;
  }
}

function points({ points: was }: ProjectDocument, { points: is }: ProjectDocument): string {
  if (was === is) return "";
  const gone = was.find(({ id }) => !is.some((point) => point.id === id));
  const fresh = is.find(({ id }) => !was.some((point) => point.id === id));
  if (gone || fresh) return `${(fresh ?? gone)?.name} ${fresh ? "added" : "is gone"}, ${count(is.length, "point")}`;
  const other = is.find((point) => !was.includes(point));
  if (!other) return "";
  const old = was.find(({ id }) => id === other.id);
  if (old?.joint !== other.joint)
    return other.joint === null ? `${other.name} follows the whole pose` : `${other.name} follows ${other.joint}`;
  return old?.name === other.name ? `${other.name} changed` : `${old?.name} is ${other.name}`;
}

function settings(was: Settings, is: Settings): string[] {
  const keys = (Object.keys(is) as (keyof Settings)[]).filter((key) => was[key] !== is[key]);
  return keys.map((key) => {
    const words = key.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
    const value = is[key];
    return `${words[0]?.toUpperCase()}${words.slice(1)} ${typeof value === "number" ? figure(value, 1) : value ? "on" : "off"}`;
  });
}

function clip(was: ClipEdits, is: ClipEdits): string[] {
  return (Object.keys(CLIP) as (keyof ClipEdits)[]).filter((key) => was[key] !== is[key]).map((key) => CLIP[key](is));
}

function duet({ companion: was }: ProjectDocument, { companion: is }: ProjectDocument): string {
  if (was === is) return "";
  if (!is) return `${stem(was?.mesh.file ?? "")} dances beside no more`;
  if (was?.mesh !== is.mesh) return `${stem(is.mesh.file)} dances beside`;
  if (was.motion !== is.motion) return is.motion ? `Beside: ${stem(is.motion.files.at(-1) ?? "")}` : "Beside: the same motion";
  const [a, b] = [was.offset, is.offset];
  if (a.seconds !== b.seconds) return `Beside: ${sayLater(b.seconds)}`;
  if (a.yaw !== b.yaw) return `Beside: turned by ${figure((b.yaw * 180) / Math.PI)} degrees`;
  const place = move([b.place[0], 0, b.place[1]]);
  return a.place === b.place ? "Beside: changed" : `Beside: ${place}`;
}
