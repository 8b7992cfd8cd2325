import type { StagePort } from "../stage/port";
import type { Context } from "./context";
import type { Dragging } from "./dragging";
import type { MotionEditing } from "./motion-editing";
import type { Pairing } from "./pairing";
import type { Presenter } from "./presenter";

const RESET = "Graphics were reset by the browser.";

/** What the hand does on the stage reaches the parts that it is for. */
export function listenToStage(
  stage: StagePort,
  { player, selection, notices }: Context,
  parts: { dragging: Dragging; pairing: Pairing; presenter: Presenter; editing: MotionEditing | null },
): void {
  const { dragging, pairing, presenter } = parts;
  stage.on("point-grab", ({ id }) => dragging.grab(id));
  stage.on("point-move", ({ position }) => dragging.move(position));
  stage.on("point-drop", () => dragging.drop());
  stage.on("point-cancel", () => dragging.cancel());
  stage.on("point-reach", ({ near }) => player.wait(near));
  stage.on("point-pick", ({ id, on }) => {
    if (on === "model" || !parts.editing?.takeDot(id)) pairing.pick(id, on);
  });
  stage.on("surface-pick", ({ vertex }) => pairing.surface(vertex));
  stage.on("joint-pick", ({ joint }) => {
    if (!parts.editing?.takeJoint(joint)) pairing.joint(joint);
  });
  stage.on("empty-pick", () => selection.select(null));
  stage.on("context-lost", () => notices.say({ title: RESET, text: "Your work is here. The picture comes back by itself." }));
  stage.on("context-restored", () => {
    notices.dismissTitle(RESET);
    presenter.everything();
  });
}
