import type { Command } from "./store";
import type { Point } from "./types";

/** Says that two points are each other's mirror image; one alone: it lies in the middle; null: it has no partner. */
export const pairMirror =
  (id: string, partner: string | null): Command =>
  (document) => {
    const loose = document.points.map((point) => {
      if (![point.id, point.mirror].some((one) => one !== undefined && (one === id || one === partner))) return point;
      const { mirror: _, ...alone } = point;
      return alone;
    });
    const with_ = (point: Point): string | null => (point.id === id ? partner : point.id === partner ? id : null);
    return {
      ...document,
      points: loose.map((point) => {
        const mirror = with_(point);
        return mirror === null ? point : { ...point, mirror };
      }),
    };
  };
