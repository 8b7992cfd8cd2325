// The gnome's points and poses. The hat's tip has no joint: it swings after the head.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.4, 0.13], radius: 0.12 },
  { id: "hand", name: "Hand", joint: "Hand", near: [0.54, 0.41, 0.12], radius: 0.06, pair: true },
  { id: "foot", name: "Foot", joint: "Foot", near: [0.17, 0, 0.07], radius: 0.09, pair: true },
  { id: "hips", name: "Belt", joint: "Hips", near: [0, 0.53, 0.31], radius: 0.09 },
  { id: "chest", name: "Beard", joint: "Spine2", near: [0, 0.83, 0.33], radius: 0.08 },
  { id: "tip", name: "Hat", joint: null, near: [0.22, 1.5, 0.03], radius: 0.04 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: {
    head: [0, -0.27, 0.08], chest: [0, -0.18, 0.06], hips: [0, -0.1, 0.03], hand: [0.12, -0.06, 0.06], foot: [0.03, 0, 0], tip: [0.06, -0.36, 0.12],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: {
    head: [0.01, -0.22, 0.16], chest: [0.01, -0.15, 0.09], hips: [0, -0.09, 0.02], hand: [0.0, -0.02, -0.28], foot: [0.02, 0, 0], tip: [0.02, -0.22, 0.28],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: {
    head: [0, 0.13, 0], chest: [0, 0.09, 0], hips: [0, 0.05, 0.01], hand: [0.08, 0.2, 0.16], foot: [0, 0, -0.04], tip: [0.0, 0.05, -0.03],
  } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // arms up, the hat left behind
    head: [0, 0.17, -0.02], chest: [0, 0.11, 0], hips: [0, 0.06, 0.01], hand: [0.1, 0.62, 0.02], foot: [-0.01, -0.01, -0.04], tip: [0.03, 0.1, -0.06],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.07, 0.03], chest: [0, 0.05, 0.02], hips: [0, 0.03, 0], hand: [0.18, 0.4, 0.06], foot: [0, 0, 0.02], tip: [0.04, 0.15, 0],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.17, 0.05, 0], chest: [0.1, 0.04, 0], hips: [0.04, 0.04, 0],
    "left-hand": [0.18, 0.42, 0.02], "right-hand": [0.0, 0.14, 0.08], "left-foot": [-0.02, 0, 0], "right-foot": [0, 0.06, -0.03], tip: [0.1, 0.06, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.08, 0.0, 0.05], chest: [-0.06, 0.01, 0.03], hips: [-0.05, 0.01, 0.03],
    "left-hand": [-0.03, -0.01, -0.16], "right-hand": [-0.02, 0.04, 0.2], "left-foot": [-0.02, 0.1, 0.16], "right-foot": [0, 0, -0.05], tip: [-0.12, 0, 0.02],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0.02, 0.08], chest: [0, 0.02, 0.05], hips: [0, 0.02, 0.02], "left-hand": [-0.06, 0.14, 0.24], "right-hand": [0.02, 0.04, -0.2],
    "left-foot": [-0.02, 0.06, -0.13], "right-foot": [0.02, 0.02, 0.13], tip: [0, -0.02, -0.1],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: {
    head: [-0.04, -0.07, 0.09], chest: [-0.03, -0.05, 0.06], hips: [-0.04, -0.03, 0.02], "left-hand": [-0.12, 0.22, 0.18], "right-hand": [0.12, 0.22, 0.18],
    "left-foot": [-0.02, 0.1, 0.14], "right-foot": [0, 0, -0.03], tip: [-0.06, -0.06, 0.12],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: {
    head: [0, -0.24, 0.27], chest: [0, -0.13, 0.15], hips: [0, -0.04, -0.06], "right-hand": [0.3, 0.06, 0.22], "left-hand": [0.12, 0.16, -0.1], "right-foot": [0, 0, -0.1], tip: [0, -0.3, 0.4],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.2, groundContact: true, inPlace: false, symmetry: true };
