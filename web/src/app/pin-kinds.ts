// What kinds of pins say, and how fast one moves on. Not part of the first load.

import { pointFromStage, pointToStage } from "../document/stage-transform";
import type { Pin, Vec3 } from "../document/types";
import { stageFor } from "../sync/placement";
import { pointsOfControls } from "../sync/point-controls";
import { FPS } from "../util/constants";
import type { Context } from "./context";

export const PIN_KINDS: Readonly<Record<Pin["kind"], { make: string; is: string; means: string }>> = {
  place: { make: "Hold it", is: "is held", means: "It is just there, whatever the poses say." },
  still: { make: "Stand still", is: "stands still", means: "It is where it was a frame before." },
  moves: { make: "Move on", is: "moves on", means: "So fast it comes from the frame before, in centimetres a second." },
  level: { make: "Keep level", is: "is level", means: "It is as high as another point." },
};

/** How fast a pin moves on, as the model stands: metres per second on the stage, across, up and on. */
export function velocityOf({ model, document }: Context, { velocity }: Pin): Vec3 | null {
  if (!model || !velocity) return null;
  return pointToStage({ ...stageFor(model, document.mesh), offset: [0, 0, 0] }, velocity);
}

/** The same pin with another speed along one axis. */
export function withSpeed(context: Context, pin: Pin, axis: number, speed: number): Pin {
  const { model, document } = context;
  const now = velocityOf(context, pin);
  if (!model || !now) return pin;
  const [x, y, z] = now.map((value, k) => (k === axis ? speed : value));
  return { ...pin, velocity: pointFromStage({ ...stageFor(model, document.mesh), offset: [0, 0, 0] }, [x, y, z]) };
}

/** A pin that moves on as the point does in the present dance. */
export function movingOn({ model, document, performance }: Context, pin: Pin): Pin {
  const size = 3 * document.points.length;
  const places = [pin.frame - 1, pin.frame].map((frame) => {
    const controls = performance?.controls.subarray(frame * size, (frame + 1) * size);
    return model && controls?.length === size ? pointsOfControls(model, document, controls)[pin.point] : undefined;
  });
  const [from = [0, 0, 0], to = [0, 0, 0]] = places;
  return { ...pin, kind: "moves", velocity: [FPS * (to[0] - from[0]), FPS * (to[1] - from[1]), FPS * (to[2] - from[2])] };
}
