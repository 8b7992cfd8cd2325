// Where the parts of a model that is a tree of named parts hang and end.

import type { View } from "./view";

type Place = [number, number, number];

export interface Part {
  readonly base: Place;
  readonly end: Place;
}

/**
 * By node that shows something: where it hangs, and its vertex that is farthest from the middle of all. It hangs on its pivot where
 * that is a hinge, in the part or beside it and no other's, and then ends at its other end; else its middle stands for that.
 */
export function partEnds({ drawn: { instances, positions } }: View, pivotOf: (node: number) => Place): Map<number, Part> {
  const ranges = new Map<number, Range[]>();
  for (const { node, first, count } of instances) ranges.set(node, [...(ranges.get(node) ?? []), [3 * first, 3 * (first + count)]]);
  const middle = middleOf(boxOf(positions, [[0, positions.length]]));
  const uses = new Map<string, number>(); // of a place as a pivot
  for (const node of ranges.keys()) uses.set(`${pivotOf(node)}`, (uses.get(`${pivotOf(node)}`) ?? 0) + 1);
  return new Map(
    [...ranges].map(([node, own]) => {
      const box = boxOf(positions, own);
      const pivot = pivotOf(node);
      if (uses.get(`${pivot}`) !== 1 || !isBeside(pivot, box))
        return [node, { base: middleOf(box), end: farthest(positions, own, middle) }];
      const reach = FAR * Math.hypot(...farthest(positions, own, pivot).map((x, k) => x - pivot[k]));
      return [node, { base: pivot, end: farthest(positions, own, middle, (i) => distance(positions, i, pivot) >= reach) }];
    }),
  );
}

type Range = readonly [from: number, to: number];
type Box = readonly [low: Place, high: Place];

const distance = (positions: Float32Array, i: number, from: Place): number =>
  Math.hypot(positions[i] - from[0], positions[i + 1] - from[1], positions[i + 2] - from[2]);

/** The vertex that is farthest from a place; `may`: of which. */
function farthest(positions: Float32Array, ranges: readonly Range[], from: Place, may = (_i: number): boolean => true): Place {
  let [best, off] = [0, -1];
  for (const [first, last] of ranges) {
    for (let i = first; i < last; i += 3) {
      const far = distance(positions, i, from);
      if (far > off && may(i)) [best, off] = [i, far];
    }
  }
  return placeOf(positions, best);
}

const placeOf = (positions: Float32Array, i: number): Place => [positions[i], positions[i + 1], positions[i + 2]];

/** Of the way from a hinge to the farthest vertex, what is the other end. */
const FAR = 0.85;

function isBeside(place: Place, [low, high]: Box): boolean {
  const slack = 0.1 * Math.hypot(...high.map((x, k) => x - low[k]));
  return place.every((x, k) => x > low[k] - slack && x < high[k] + slack);
}

function boxOf(positions: Float32Array, ranges: readonly Range[]): Box {
  const low: Place = [Infinity, Infinity, Infinity];
  const high: Place = [-Infinity, -Infinity, -Infinity];
  for (const [from, to] of ranges) {
    for (let i = from; i < to; i++) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
  }
  return [low, high];
}

const middleOf = ([low, high]: Box): Place => low.map((x, k) => (x + high[k]) / 2) as Place;
