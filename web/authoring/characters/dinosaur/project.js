// The dinosaur's points and poses. The tail has no joint: it follows the whole pose, and always balances the head.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.42, 0.26], radius: 0.16 },
  { id: "hand", name: "Hand", joint: "Hand", near: [0.33, 0.74, 0.37], radius: 0.04, pair: true },
  { id: "foot", name: "Foot", joint: "Foot", near: [0.235, 0, 0.09], radius: 0.09, pair: true },
  { id: "hips", name: "Belly", joint: "Hips", near: [0, 0.55, 0.28], radius: 0.1 },
  { id: "chest", name: "Chest", joint: "Spine2", near: [0, 0.86, 0.17], radius: 0.07 },
  { id: "tail", name: "Tail", joint: null, near: [0, 0.39, -1.05], radius: 0.05 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { // landed: down, hands flung out, the tail up
    head: [0, -0.29, 0.08], chest: [0, -0.2, 0.05], hips: [0, -0.14, 0.0], hand: [0.07, -0.2, 0.03], foot: [0.04, 0, 0.01], tail: [0, 0.18, 0.08],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { // bows down to leap, hands back, the tail high behind
    head: [0.01, -0.27, 0.17], chest: [0.01, -0.18, 0.08], hips: [0, -0.13, -0.04], hand: [0.07, -0.16, -0.2], foot: [0.02, 0, 0], tail: [0, 0.26, 0.1],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { // long, still on the ground: the tail trails
    head: [0, 0.12, 0.0], chest: [0, 0.09, 0.01], hips: [0, 0.06, 0.02], hand: [0.04, 0.12, 0.08], foot: [0, 0, -0.03], tail: [0, -0.16, 0.04],
  } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // top of the leap
    head: [0, 0.18, -0.02], chest: [0, 0.12, 0], hips: [0, 0.07, 0.02], hand: [0.12, 0.3, -0.04], foot: [0.04, 0.02, -0.03], tail: [0, 0.05, 0.02],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.08, 0.02], chest: [0, 0.05, 0.01], hips: [0, 0.03, 0], hand: [0.13, 0.2, 0.02], foot: [0, 0, 0.02], tail: [0, 0.24, 0.06],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.18, 0.06, 0], chest: [0.09, 0.05, 0], hips: [0.03, 0.04, 0],
    "left-hand": [0.1, 0.22, 0.02], "right-hand": [0.03, 0.04, 0.05], "left-foot": [0.0, 0.0, 0], "right-foot": [0.0, 0.05, -0.03], tail: [-0.34, 0.1, 0.06],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.07, 0.0, 0.05], chest: [-0.06, 0.01, 0.03], hips: [-0.05, 0.01, 0.03],
    "left-hand": [0, -0.03, -0.08], "right-hand": [0, 0.04, 0.08], "left-foot": [-0.01, 0.1, 0.18], "right-foot": [0, 0, -0.05], tail: [-0.08, 0.03, 0.03],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0.01, 0.1], chest: [0, 0.01, 0.06], hips: [0, 0.02, 0.02], "left-hand": [-0.02, 0.06, 0.09], "right-hand": [-0.02, -0.02, -0.07],
    "left-foot": [-0.02, 0.06, -0.14], "right-foot": [0.02, 0.02, 0.14], tail: [0, 0.14, 0],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: {
    head: [-0.04, -0.07, 0.12], chest: [-0.03, -0.05, 0.06], hips: [-0.04, -0.03, 0.02], hand: [0, 0.08, 0.06], "left-foot": [-0.01, 0.12, 0.16], "right-foot": [0, 0, -0.03], tail: [-0.05, 0.12, 0.05],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: {
    head: [0, -0.27, 0.24], chest: [0, -0.15, 0.13], hips: [0, -0.04, -0.07], "right-hand": [0.12, -0.18, 0.16], "left-hand": [0.06, -0.06, 0.02], "right-foot": [0, 0, -0.12], tail: [0, 0.34, 0.1],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.3, groundContact: true, inPlace: false, symmetry: true };
