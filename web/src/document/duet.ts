// Two dancers: the one in hand and its companion, who is a project of its own kind beside it.

import { clipName, saidOf } from "./clips";
import type { Command } from "./store";
import type { ClipEdits, Companion, Dancer, MotionRef, Offset, ProjectDocument } from "./types";

/** Where a companion stands who was not put anywhere: at the left of the one in hand, as far from the eye as that is. */
export const BESIDE: Offset = { seconds: 0, place: [1.6, -0.15], yaw: 0 };

/** What of a document is its dancer in hand. */
export function dancerOf({ version: _, name: __, companion: ___, ...dancer }: ProjectDocument): Dancer {
  return dancer;
}

/** Whose model and poses these are, as a companion; `motion` null: it dances to that of the one in hand. */
export function companionOf(own: ProjectDocument, offset: Offset, motion: MotionRef | null): Companion {
  const { motion: _, ...dancer } = dancerOf(own);
  return { ...dancer, ...(motion && { motion }), offset };
}

const SHARED = new WeakMap<ClipEdits, WeakMap<ClipEdits, ClipEdits>>();

/** Cut, sped up and read as the one, with the other's pins and contacts; the same again for the same two. */
function shared(hand: ClipEdits, own: ClipEdits): ClipEdits {
  const known = SHARED.get(hand) ?? new WeakMap<ClipEdits, ClipEdits>();
  const { pins: _, contacts: __, flights: ___, ...motion } = hand;
  const { pins, contacts, flights } = own;
  const clip = known.get(own) ?? { ...motion, ...(pins && { pins }), ...(contacts && { contacts }), ...(flights && { flights }) };
  SHARED.set(hand, known.set(own, clip));
  return clip;
}

/** The companion as a document of its own; null: nobody dances beside. */
export function companionDocument(document: ProjectDocument): ProjectDocument | null {
  const { companion } = document;
  if (!companion) return null;
  const { offset: _, ...own } = companion;
  const named = { version: 1, name: document.name } as const;
  const { motion } = own;
  if (motion) return { ...named, ...own, motion };
  const dances = { ...own, motion: document.motion };
  const [hand, its] = [saidOf(document), saidOf(dances)];
  if (hand === its) return { ...named, ...dances };
  return { ...named, ...dances, clips: { ...own.clips, [clipName(document)]: shared(hand, its) } };
}

/** Somebody dances beside from now on; null: nobody. */
export const setCompanion =
  (companion: Companion | null): Command =>
  ({ companion: _, ...document }) =>
    companion ? { ...document, companion } : document;

/** Metres from the one in hand: as far as a project file reaches. */
const FARTHEST = 100;

const onFloor = ([x, z]: Offset["place"]): Offset["place"] => {
  const near = (value: number): number => Math.min(Math.max(value, -FARTHEST), FARTHEST);
  return [near(x), near(z)];
};

/** Another time and place for the companion. */
export const moveCompanion =
  (offset: Partial<Offset>): Command =>
  (document) => {
    const { companion } = document;
    if (!companion) return document;
    const wanted = { ...companion.offset, ...offset };
    const moved = { ...wanted, place: onFloor(wanted.place) };
    if (JSON.stringify(moved) === JSON.stringify(companion.offset)) return document;
    return { ...document, companion: { ...companion, offset: moved } };
  };

/** The companion dances to a motion of its own; null: to that of the one in hand. */
export const setCompanionMotion =
  (motion: MotionRef | null): Command =>
  (document) => {
    const { companion } = document;
    if (!companion) return document;
    if (!motion) {
      const { motion: _, ...dancer } = companion;
      return companion.motion ? { ...document, companion: dancer } : document;
    }
    // What it danced to so far is cut as it was.
    const { clips } = companionDocument(document) ?? companion;
    return { ...document, companion: { ...companion, ...(clips && { clips }), motion } };
  };

/** The two change places: the companion is in hand now, and each stays where it is. */
export const swapDancers: Command = (document) => {
  const { companion, version, name } = document;
  const other = companionDocument(document);
  if (!companion || !other) return document;
  const { seconds, place, yaw } = companion.offset;
  const [x, z] = place;
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  const round = (value: number): number => Math.round(1e6 * value) / 1e6 || 0;
  const offset: Offset = { seconds: -seconds || 0, place: onFloor([round(s * z - c * x), round(-s * x - c * z)]), yaw: -yaw || 0 };
  const { motion, ...dancer } = dancerOf(document);
  return { version, name, ...dancerOf(other), companion: { ...dancer, ...(companion.motion && { motion }), offset } };
};
