import { expect, test } from "vitest";
import type { Action, Actions } from "../../src/app/actions";
import { handleKey } from "../../src/app/keys";
import type { KeyPress } from "../../src/app/keys";

const press = (key: string, more: Partial<KeyPress> = {}): KeyPress => ({
  key,
  ctrl: false,
  shift: false,
  alt: false,
  typing: false,
  onButton: false,
  ...more,
});

/** Some actions that write down that they ran. */
function table() {
  const ran: string[] = [];
  const action = (id: Action["id"], keys: string[], more: Partial<Action> = {}): Action => ({
    id,
    label: id,
    keys,
    enabled: () => true,
    run: () => ran.push(id),
    ...more,
  });
  const actions = {
    save: action("save", ["Ctrl+S"], { whileTyping: true }),
    undo: action("undo", ["Ctrl+Z"]),
    redo: action("redo", ["Ctrl+Shift+Z", "Ctrl+Y"]),
    play: action("play", ["Space"], { leftToButtons: true }),
    fit: action("fit", ["F"]),
    help: action("help", ["?"]),
    mirror: action("mirror", ["M"], { enabled: () => false }),
  } as Partial<Actions> as Actions;
  return { actions, ran };
}

test("a key runs its action, whichever case it comes in", () => {
  const { actions, ran } = table();
  expect(handleKey(actions, press("f"))).toBe(true);
  expect(handleKey(actions, press("F", { shift: true }))).toBe(true);
  expect(handleKey(actions, press("?", { shift: true }))).toBe(true);
  expect(handleKey(actions, press("z", { ctrl: true }))).toBe(true);
  expect(handleKey(actions, press("Z", { ctrl: true, shift: true }))).toBe(true);
  expect(handleKey(actions, press("y", { ctrl: true }))).toBe(true);
  expect(handleKey(actions, press(" "))).toBe(true);
  expect(ran).toEqual(["fit", "fit", "help", "undo", "redo", "redo", "play"]);
});

test("fields of text, buttons and other programs keep their keys", () => {
  const { actions, ran } = table();
  expect(handleKey(actions, press("f", { typing: true }))).toBe(false);
  expect(handleKey(actions, press("z", { ctrl: true, typing: true }))).toBe(false);
  expect(handleKey(actions, press(" ", { onButton: true }))).toBe(false);
  expect(handleKey(actions, press("f", { alt: true }))).toBe(false);
  expect(handleKey(actions, press("f", { ctrl: true }))).toBe(false);
  expect(handleKey(actions, press("m"))).toBe(false);
  expect(handleKey(actions, press("q"))).toBe(false);
  expect(ran).toEqual([]);
  expect(handleKey(actions, press("s", { ctrl: true, typing: true }))).toBe(true);
  expect(ran).toEqual(["save"]);
});
