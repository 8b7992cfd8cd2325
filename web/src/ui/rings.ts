// Lists and bars that the Tab key enters once: inside, arrows lead on, and Page Up and Page Down where arrows already do something.

/** In which elements, and what of them; an element that has a shadow of its own stands for what it holds. */
const RINGS: readonly (readonly [within: string, items: string])[] = [
  ["rigless-top-bar, rigless-transport, rigless-view", "button"],
  ["nav, .gallery, .shelf, .chips, .poses, .rows, .row-acts", "button"],
  [".panel > ul", ".item, .row button"],
  [".switches", "rigless-switch"],
  [".marks", ".point.model"],
];

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowDown: 1,
  PageDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  PageUp: -1,
  Home: -Infinity,
  End: Infinity,
};

/** What a ring was left at. */
const left = new WeakMap<Element, HTMLElement>();

interface Ring {
  within: Element;
  items: readonly HTMLElement[];
}

/** All elements, those in shadows too, in the order of the page. */
export function* everything(root: ParentNode): Generator<Element> {
  for (const element of root.children) {
    yield element;
    if (element.shadowRoot) yield* everything(element.shadowRoot);
    yield* everything(element);
  }
}

function rings(root: ParentNode): Ring[] {
  const found: Ring[] = [];
  for (const within of everything(root)) {
    for (const [where, what] of RINGS) {
      if (!within.matches(where)) continue;
      const items = [...(within.shadowRoot ?? within).querySelectorAll<HTMLElement>(what)]
        .map((item) => item.shadowRoot?.querySelector("input") ?? item)
        .filter((item) => !item.matches(":disabled") && item.checkVisibility());
      if (items.length > 0) found.push({ within, items });
    }
  }
  return found;
}

/** Before Tab leaves for the next stop: one item of each ring is one. */
export function oneStopEach(root: ParentNode, focus: Element | null): void {
  for (const { within, items } of rings(root)) {
    const last = left.get(within);
    const stop =
      items.find((item) => item === focus) ??
      items.find((item) => item === last) ??
      items.find((item) => item.matches("[aria-pressed=true]:not(.loop), [aria-current=true]")) ??
      items[0];
    for (const item of items) item.tabIndex = item === stop ? 0 : -1;
    if (stop) left.set(within, stop);
  }
}

/** A key that leads on in the ring that has the focus. Answers whether it did. */
export function stepInRing(root: ParentNode, focus: Element | null, key: string): boolean {
  const step = STEPS[key];
  if (step === undefined || !focus) return false;
  const ring = rings(root).find(({ items }) => items.some((item) => item === focus));
  if (!ring) return false;
  const { within, items } = ring;
  const at = items.findIndex((item) => item === focus) + step;
  const to = Number.isFinite(at) ? items[(at + items.length) % items.length] : items.at(at > 0 ? -1 : 0);
  if (to) left.set(within, to);
  to?.focus();
  return true;
}
