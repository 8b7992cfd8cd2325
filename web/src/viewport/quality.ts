// How much the picture may cost. A machine that keeps us waiting for frames loses the sun's shadow step by step, then fine
// pixels; the soft dark under the feet stays, it costs nothing. A step is never taken back, so that the picture does not flicker.

export interface Quality {
  /** Width of the shadow map; 0: no sun shadow. */
  shadowMap: number;
  blurSamples: number;
  maxPixelRatio: number;
}

const STEPS: readonly Quality[] = [
  { shadowMap: 1024, blurSamples: 12, maxPixelRatio: 2 },
  { shadowMap: 512, blurSamples: 6, maxPixelRatio: 2 },
  { shadowMap: 0, blurSamples: 0, maxPixelRatio: 2 },
  { shadowMap: 0, blurSamples: 0, maxPixelRatio: 1 },
];

/** A frame that came later than this after it was asked for was late: 25 a second. */
const LATE_MS = 40;
const MOST_PER_FRAME_MS = 250;
const PATIENCE_MS = 400;
/** Later than this, and a smaller shadow would not help either. */
const HOPELESS_MS = 300;
/** Shaders compile during these. */
const WARM_UP = 2;

export class QualityGovernor {
  private step: number;
  private lateness = 0;
  private frames = 0;

  /** `renderer`: what the graphics card calls itself; a program that plays one begins without the sun's shadow,
   *  whose shaders alone would keep the first motion waiting for seconds. */
  constructor(renderer = "") {
    this.step = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer) ? 2 : 0;
  }

  get quality(): Quality {
    return STEPS[this.step]!;
  }

  /** Takes the wait for one frame in milliseconds; true if the quality was lowered. */
  note(wait: number): boolean {
    if (++this.frames <= WARM_UP) return false;
    const late = Math.min(MOST_PER_FRAME_MS, wait - LATE_MS);
    this.lateness = late > 0 ? this.lateness + late : 0.5 * this.lateness;
    if (this.lateness < PATIENCE_MS || this.step === STEPS.length - 1) return false;
    this.step = wait > HOPELESS_MS ? Math.max(this.step + 1, 2) : this.step + 1;
    this.lateness = 0;
    this.frames = 0;
    return true;
  }
}
