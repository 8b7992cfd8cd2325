import type { PackedStatus } from "./abi";
import type { Subject } from "./messages";

/** What the core does not take: thrown where it runs. What is said of it (messages.ts) is fetched by the page when it happens. */
export class Refusal extends Error {
  constructor(
    readonly packed: PackedStatus,
    readonly subject: Subject,
  ) {
    super();
  }
}
