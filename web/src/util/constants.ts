// Numbers that the core knows too. Made by wasm/abi.mjs from wasm/abi.h: change that.

/** Of every performance. */
export const FPS = 30;

/** Metres, where nothing better is known. */
export const PERSON_HEIGHT = 1.7;

/** How tall a model stands on the stage, metres. */
export const STAGE_HEIGHT = 1.7;

/** How much of its width counts as height. */
export const WIDTH_SHARE = 0.6;

/** Of a point, in model heights. */
export const DEFAULT_RADIUS = 0.05;

/** Weight of acceleration at 30 fps. */
export const DEFAULT_SMOOTHNESS = 0.3;
