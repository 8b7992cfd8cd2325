import type { Action, Actions } from "./actions";

/** A key that went down, and where. */
export interface KeyPress {
  /** As KeyboardEvent has it. */
  readonly key: string;
  /** Ctrl, or Cmd. */
  readonly ctrl: boolean;
  readonly shift: boolean;
  readonly alt: boolean;
  /** The focus is in a field of text or a list of choices. */
  readonly typing: boolean;
  /** The keyboard has put the focus on a button or a box to tick. */
  readonly onButton: boolean;
}

/** Does what a key means. Answers whether the key was ours. */
export function handleKey(actions: Actions, press: KeyPress): boolean {
  if (press.alt && !press.ctrl) return false;
  const name = press.key === " " ? "Space" : press.key.length === 1 ? press.key.toUpperCase() : press.key;
  const ctrl = press.ctrl ? "Ctrl+" : "";
  // Where Shift makes no difference it may be down: it is for "?" on most keyboards.
  const action = (press.shift && find(actions, `${ctrl}Shift+${name}`)) || find(actions, ctrl + name);
  if (!action || !action.enabled()) return false;
  if (press.typing && !action.whileTyping) return false;
  if (press.onButton && action.leftToButtons) return false;
  action.run();
  return true;
}

function find(actions: Actions, key: string): Action | undefined {
  return Object.values(actions).find(({ keys }) => keys.includes(key));
}
