import { figure } from "../util/words";

/** "0.5 s later" */
export function sayLater(seconds: number): string {
  if (seconds === 0) return "at the same time";
  return `${figure(Math.abs(seconds), 1)} s ${seconds > 0 ? "later" : "earlier"}`;
}
