import { Spoken } from "../app/spoken";
import type { Session } from "../app/session";
import type { Topics } from "../app/signals";
import { focused } from "./keys";
import { everything, oneStopEach, stepInRing } from "./rings";

/** The parts of the page in the order that the eye takes; F6 goes from one to the next. */
const PARTS = ["rigless-top-bar", "rigless-rail", "main", "rigless-inspector", ".dock"];

const STOP = "button, input, select, [tabindex]";

/** For keyboards and screen readers: few stops, ways between the parts, and words for every change. */
export class Assist {
  private readonly spoken: Spoken;
  private readonly region = document.createElement("p");
  private readonly abort = new AbortController();

  constructor(
    session: Session,
    private readonly root: HTMLElement | DocumentFragment,
  ) {
    this.spoken = new Spoken(session.context, session.dragging);
    this.region.className = "vh";
    this.region.role = "status";
    root.append(this.region);
    const { signal } = this.abort;
    const stop = session.signals.on("document", (before) => this.speak(before));
    signal.addEventListener("abort", stop);
    addEventListener("keydown", (event) => event.key === "Tab" && oneStopEach(root, focused()), { signal, capture: true });
    addEventListener("keydown", (event) => this.keyed(event), { signal });
  }

  close(): void {
    this.abort.abort();
  }

  /** The document was that one. */
  speak(before: Topics["document"]): void {
    const words = this.spoken.of(before);
    if (words) this.region.textContent = words;
  }

  private keyed(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const done = event.key === "F6" ? this.goOn(event.shiftKey ? -1 : 1) : !event.shiftKey && stepInRing(this.root, focused(), event.key);
    if (done) event.preventDefault();
  }

  /** Beyond the last part the browser's own begin. */
  private goOn(by: 1 | -1): boolean {
    oneStopEach(this.root, focused());
    const parts = PARTS.map((part) => this.root.querySelector<HTMLElement>(part)).filter((part) => part?.checkVisibility());
    const here = focused();
    const now = parts.findIndex((part) => part && [part, ...everything(part.shadowRoot ?? part)].some((one) => one === here));
    for (let k = now < 0 && by < 0 ? parts.length - 1 : now + by; k >= 0 && k < parts.length; k += by) {
      const part = parts[k];
      const stop = part && [...everything(part.shadowRoot ?? part)].find((one): one is HTMLElement => isStop(one));
      stop?.focus();
      if (stop) return true;
    }
    return false;
  }
}

function isStop(element: Element): boolean {
  return (
    element instanceof HTMLElement &&
    element.matches(STOP) &&
    element.tabIndex >= 0 &&
    !element.matches(":disabled") &&
    element.checkVisibility()
  );
}
