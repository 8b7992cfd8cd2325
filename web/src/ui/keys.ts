import type { KeyPress } from "../app/keys";

/** A key that went down, as the app wants to know it. `clicked`: what the pointer has put the focus on. */
export function pressOf(event: KeyboardEvent, clicked: EventTarget | null): KeyPress {
  const target = event.composedPath()[0];
  const { key, shiftKey: shift, altKey: alt } = event;
  return {
    key,
    ctrl: event.ctrlKey || event.metaKey,
    shift,
    alt,
    typing: isTyping(target),
    onButton: target !== clicked && isButton(target),
  };
}

/** A field of text or a list of choices. */
function isTyping(target: EventTarget | undefined): boolean {
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio"].includes(target.type);
  return target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

function isButton(target: EventTarget | undefined): boolean {
  return target instanceof HTMLButtonElement || (target instanceof HTMLInputElement && target.type === "checkbox");
}

/** What has the focus, in whichever shadow it lies. */
export function focused(): Element | null {
  let element = document.activeElement;
  while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
  return element;
}
