// Numbers that the core knows too. Made by wasm/abi.mjs from wasm/abi.h: change that.

export const FPS = 30;

export const PERSON_HEIGHT = 1.7;

export const DEFAULT_SMOOTHNESS = 0.3;
