import type { Session } from "./session";
import { PANELS } from "./panels";

/** True while the keys belong to a field of text or a list of choices. */
function isTyping(event: KeyboardEvent): boolean {
  const target = event.composedPath()[0];
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio"].includes(target.type);
  return target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

function onButton(event: KeyboardEvent): boolean {
  const target = event.composedPath()[0];
  return target instanceof HTMLButtonElement || (target instanceof HTMLInputElement && target.type === "checkbox");
}

/** The page's keys. Answers whether the key was ours. */
export function handleKey(session: Session, event: KeyboardEvent): boolean {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.metaKey) {
    if (key === "s") void session.save();
    else if (key === "o") session.pickFiles();
    else if (isTyping(event)) return false;
    else if (key === "z" && !event.shiftKey) session.undo();
    else if (key === "y" || (key === "z" && event.shiftKey)) session.redo();
    else return false;
    return true;
  }
  if (isTyping(event) || event.altKey) return false;
  const panel = PANELS[Number(key) - 1];
  if (panel) {
    session.setPanel(session.panel === panel.id ? null : panel.id);
    return true;
  }
  const { player } = session;
  switch (key) {
    case " ":
      if (onButton(event)) return false;
      session.togglePlay();
      return true;
    case ",":
      player.step(-1);
      return true;
    case ".":
      player.step(1);
      return true;
    case "[":
      session.poses.step(-1);
      return true;
    case "]":
      session.poses.step(1);
      return true;
    case "k":
      session.keepShape();
      return true;
    case "c":
      session.pins.key();
      return true;
    case "m":
      if (!session.drag) return false;
      session.dragging.mirror();
      return true;
    case "Enter":
      if (session.coverage.asking === null || onButton(event)) return false;
      session.coverage.keep();
      return true;
    case "f":
      session.fit();
      return true;
    case "?":
      session.setHelp(true);
      return true;
    case "Escape":
      return session.escape();
    case "Delete":
      if (session.pins.chosen) session.pins.remove(session.pins.chosen);
      else return session.points.removeSelected();
      return true;
    default:
      return false;
  }
}
