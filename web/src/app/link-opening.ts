// Somebody sent a project as a link: it is shown, and becomes a project of its own with the first change.

import { isLink, readLink } from "../io/project-link";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Context } from "./context";
import { errorText } from "./error-words";
import { PoseJoints } from "./pose-joints";
import type { Ports } from "./ports";
import type { Sources } from "./sources";

export interface LinkOpeners {
  readonly builtins: Builtins;
  readonly sources: Sources;
}

/** False, and said, if it cannot be opened. */
export async function openLink(
  context: Context,
  { builtins, sources }: LinkOpeners,
  { address, readModel }: Pick<Ports, "address" | "readModel">,
): Promise<boolean> {
  const { history, notices, selection, signals, workspace } = context;
  if (!isLink(address.link)) return false;
  const characterOf = (id: string) => builtins.characters.find((character) => character.id === id);
  const joints = new PoseJoints(builtins, workspace.createEngine());
  try {
    const baseOf = async (id: string) => {
      const character = characterOf(id);
      return character ? (await builtins.load(character)).document : null;
    };
    const { of, document } = await readLink(address.link, baseOf, joints.of);
    const character = characterOf(of) ?? builtins.characters[0];
    const [motion = "", ...others] = document.motion.files;
    if (others.length > 0 || !builtins.motions.some((ours) => ours.file === motion))
      throw new Error("It dances to a motion that is not here.");
    const [{ bytes }, text] = await Promise.all([builtins.load(character), builtins.motionText(motion)]);
    const files = [{ name: builtins.modelFile(character), bytes }];
    const file = sources.addModel(files[0].name, await readModel(files), files);
    const next = { ...document, mesh: { ...document.mesh, file }, motion: { files: sources.addMotion([motion], { name: motion, text }) } };
    await workspace.tryOn(next);
    history.replace(next);
    history.markSaved();
    selection.endIntro();
    notices.say({
      title: `${document.name} came with a link.`,
      text: "Make it yours: drag any dot. From then on it is a project of your own, kept in this browser.",
      icon: "poses",
    });
    const stop = signals.on("document", () => {
      if (!history.touched) return;
      stop();
      address.forget();
    });
    return true;
  } catch (error) {
    if (!isAbort(error)) notices.say({ bad: true, title: "This link cannot be opened.", text: errorText(error) });
    return false;
  } finally {
    joints.close();
  }
}
