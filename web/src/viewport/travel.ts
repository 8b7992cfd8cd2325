// How the stage goes along with figures that travel: they stay under the camera, and the ground goes by. A clip that begins again
// is no jump: the figures go on from where they are, on ground that goes on under them.

import { Vector2 } from "three";

const FOLLOW_SECONDS = 0.15;
/** Farther than a dancer moves between two frames: another moment was chosen. */
const JUMP = 1.2;
/** Within this time figures that ended a loop apart come together again. */
const REUNION_SECONDS = 0.25;
const NEAR = 0.001;

/** One figure that travels. All vectors are x and z in metres. */
export class Traveller {
  /** It is on the stage. */
  here = false;
  /** Where it is in its world. */
  readonly ground = new Vector2();
  /** From its world to the scene. */
  readonly aside = new Vector2();
  /** Where it was when the clip began again. */
  readonly before = new Vector2();
  /** How far from its place it is still drawn since then. */
  readonly slip = new Vector2();
  /** How far it is from the middle of all, which is not drawn where all stand on one spot. */
  readonly lead = new Vector2();
}

export class Travel {
  /** How far the ground has gone by. */
  readonly gone = new Vector2();
  /** What the camera looks at, in the figures' world. */
  private readonly here = new Vector2();
  private readonly goal = new Vector2();
  private readonly earlier = new Vector2();
  private again = false;

  /** `still`: whatever moves is there at once. */
  constructor(
    private readonly travellers: readonly Traveller[],
    private readonly still: boolean,
  ) {}

  /** The next places are those of the clip's beginning, reached by its end. */
  beginAgain(): void {
    this.again = !this.still;
    for (const { before, ground } of this.travellers) before.copy(ground);
  }

  /** After figures moved. */
  aim(): void {
    const present = this.travellers.filter(({ here }) => here);
    const jump = this.goal.clone().negate();
    this.goal.set(0, 0);
    for (const { ground } of present) this.goal.addScaledVector(ground, 1 / present.length);
    if (!this.again) return;
    this.again = false;
    jump.add(this.goal);
    this.here.add(jump);
    this.earlier.sub(jump);
    for (const { slip, before, ground } of present) slip.add(before).sub(ground).add(jump);
  }

  /**
   * Follows the figures for some seconds, at once if `snap`; true while it has not caught up. `together`: 1 where all stand on one spot,
   * 0 where each is drawn as far from the others as it is.
   */
  follow(seconds: number, snap: boolean, together: number): boolean {
    const lag = this.here.distanceTo(this.goal);
    const ease = snap || this.still || lag > JUMP || lag < NEAR ? 1 : 1 - Math.exp(-seconds / FOLLOW_SECONDS);
    this.here.lerp(this.goal, ease);
    this.gone.addVectors(this.here, this.earlier);
    let moving = lag >= NEAR;
    for (const { ground, aside, slip, lead } of this.travellers) {
      const slips = !snap && slip.length() >= NEAR;
      moving ||= slips;
      slip.multiplyScalar(slips ? Math.exp(-seconds / REUNION_SECONDS) : 0);
      lead.subVectors(ground, this.goal);
      aside
        .copy(slip)
        .multiplyScalar(1 - together)
        .addScaledVector(lead, -together)
        .sub(this.here);
    }
    return moving;
  }
}
