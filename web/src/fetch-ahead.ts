/** So long after the page began to dance there is time for what may be needed later. */
const LATER_MS = 10_000;

/** Fetches the parts of the page that come with a click, so that none of them depends on the network by then. */
export function fetchAhead(): void {
  setTimeout(async () => {
    const parts = [
      () => import("./ui/elements/late"),
      () => import("./ui/assist"),
      () => import("./app/project-saving"),
      () => import("./app/exporting"),
      () => import("./engine/messages"),
      () => import("./engine/skin-in-worker"),
      () => import("./app/keeping"),
      () => import("./page/shelf"),
      () => import("./app/file-opening"),
      () => import("./sync/shape-input"),
      () => import("./viewport/surface-picker"),
      () => import("./viewport/carried-body"),
    ];
    for (const part of parts) await part().catch(() => undefined); // offline: whoever needs it says so
  }, LATER_MS);
}
