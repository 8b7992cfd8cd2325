// What was said about single motions: pins, contacts, flights. Each is found by the motion file's name without folders.

import type { Command } from "./store";
import type { ClipEdits, Pin, ProjectDocument } from "./types";

const NOTHING: ClipEdits = {};

export function clipName({ motion }: Pick<ProjectDocument, "motion">): string {
  const { files } = motion; // a skeleton may stand beside it, before or after
  return (files.find((file) => !/\.asf$/i.test(file)) ?? files[0] ?? "").replace(/^.*[/\\]/, "");
}

/** What is danced, and how what is said of it is called. */
export type Danced = Pick<ProjectDocument, "motion" | "clips">;

/** What was said about the motion that plays, in frames of the whole motion as the document has it. */
export function saidOf(document: Danced): ClipEdits {
  const name = clipName(document);
  const { clips } = document;
  return clips && Object.hasOwn(clips, name) ? clips[name] : NOTHING;
}

/** The frame of the whole motion with which its dance begins. */
export const startOf = (document: Danced): number => saidOf(document).cut?.[0] ?? 0;

const OF_DANCE = new WeakMap<ClipEdits, ClipEdits>();

/** The same in frames of the dance, some of which may lie before it or after its end. */
export function clipOf(document: Danced): ClipEdits {
  const said = saidOf(document);
  const known = OF_DANCE.get(said) ?? moved(said, -startOf(document));
  OF_DANCE.set(said, known);
  return known;
}

type Runs = readonly (readonly [number, number])[];

/** All frames so many later. */
function moved(clip: ClipEdits, by: number): ClipEdits {
  if (by === 0) return clip;
  const { pins, contacts, flights } = clip;
  const later = (runs: Runs): Runs => runs.map(([a, b]) => [a + by, b + by] as const);
  return {
    ...clip,
    ...(pins && { pins: pins.map((pin) => ({ ...pin, frame: pin.frame + by })) }),
    ...(contacts && { contacts: Object.fromEntries(Object.entries(contacts).map(([id, runs]) => [id, later(runs)])) }),
    ...(flights && { flights: later(flights) }),
  };
}

/** The points that a pin names. */
export const pointsOfPin = ({ point, other = point }: Pin): string[] => [point, other];

/** What a pin of its kind lacks or may not say, as a field and a sentence about it; null: nothing. */
export function pinFault({ kind, point, other = point, frame, position, velocity }: Pin): string | null {
  if (kind === "place" && !position) return 'position is missing: a pin of kind "place" says where.';
  if (kind === "moves" && !velocity) return 'velocity is missing: a pin of kind "moves" says how fast.';
  if ((kind === "still" || kind === "moves") && frame === 0)
    return "frame is 0, but no frame comes before it in which its point could stand.";
  if (kind === "level" && other === point) return 'other is missing: a pin of kind "level" names another point.';
  return null;
}

/** A new pin, in frames of the dance as all that follows, or another place for the one that has its point, frame and kind. */
export const setPin = (pin: Pin): Command =>
  changeClip(({ pins = [], ...clip }) => {
    const others = pins.filter(
      (old) => old.id !== pin.id && !(old.point === pin.point && old.frame === pin.frame && old.kind === pin.kind),
    );
    return { ...clip, pins: [...others, pin].sort((a, b) => a.frame - b.frame) };
  });

export const removePin = (id: string): Command =>
  changeClip((clip) => (clip.pins?.some((pin) => pin.id === id) ? { ...clip, pins: clip.pins.filter((pin) => pin.id !== id) } : clip));

/** Says when a point stands; null: as in the motion. */
export const setContacts = (point: string, runs: Runs | null): Command =>
  changeClip((clip) => {
    const { [point]: old, ...others } = clip.contacts ?? {};
    if (runs === null) return old === undefined ? clip : { ...clip, contacts: others };
    return { ...clip, contacts: { ...others, [point]: merged(runs) } };
  });

/** Says when the model flies; null: as in the motion. */
export const setFlights = (flights: Runs | null): Command =>
  changeClip(({ flights: _, ...clip }) => (flights === null ? clip : { ...clip, flights: merged(flights) }));

/** Without what was said of a point, in every clip. */
export function forgetPoint(clips: ProjectDocument["clips"], id: string): ProjectDocument["clips"] {
  if (!clips) return clips;
  return Object.fromEntries(
    Object.entries(clips).map(([name, { pins, contacts, ...clip }]) => [
      name,
      {
        ...clip,
        ...(pins && { pins: pins.filter((pin) => !pointsOfPin(pin).includes(id)) }),
        ...(contacts && { contacts: Object.fromEntries(Object.entries(contacts).filter(([point]) => point !== id)) }),
      },
    ]),
  );
}

/** In order; runs that touch or overlap are one. */
export function merged(runs: Runs): [number, number][] {
  const out: [number, number][] = [];
  for (const [a, b] of runs.filter(([a, b]) => a < b).toSorted((p, q) => p[0] - q[0])) {
    const last = out.at(-1);
    if (last && a <= last[1]) last[1] = Math.max(last[1], b);
    else out.push([a, b]);
  }
  return out;
}

function changeClip(change: (clip: ClipEdits) => ClipEdits): Command {
  return (document) => {
    const old = clipOf(document);
    const clip = change(old);
    if (clip === old) return document;
    return { ...document, clips: { ...document.clips, [clipName(document)]: moved(clip, startOf(document)) } };
  };
}
