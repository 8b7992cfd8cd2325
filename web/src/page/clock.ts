import type { ClockPort } from "../app/ports";

export const clock: ClockPort = {
  nextFrame(call) {
    const request = requestAnimationFrame(call);
    return () => cancelAnimationFrame(request);
  },
  /** Pictures cost the graphics card; the dance comes first. */
  idle: () =>
    new Promise((resolve) => {
      if ("requestIdleCallback" in window) requestIdleCallback(() => resolve(), { timeout: 250 });
      else setTimeout(resolve, 100);
    }),
};
