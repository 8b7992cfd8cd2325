// The egg's points and poses. It has no neck and no knees: it squashes, rolls and rocks as one.

export const POINTS = [
  { id: "head", name: "Top", joint: "Head", near: [0, 1.18, 0.1], radius: 0.16 },
  { id: "hand", name: "Hand", joint: "Hand", near: [0.6, 0.44, 0.13], radius: 0.06, pair: true },
  { id: "foot", name: "Foot", joint: "Foot", near: [0.185, 0, 0.075], radius: 0.09, pair: true },
  { id: "hips", name: "Belly", joint: "Hips", near: [0, 0.5, 0.38], radius: 0.1 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { head: [0, -0.27, 0.05], hips: [0, -0.13, 0.04], hand: [0.12, -0.12, 0.03], foot: [0.03, 0, 0] } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { head: [0.01, -0.23, 0.12], hips: [0, -0.12, 0.03], hand: [0.02, -0.1, -0.24], foot: [0.02, 0, 0] } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { head: [0, 0.14, 0], hips: [0, 0.06, 0.01], hand: [0.02, 0.2, 0.12], foot: [0, 0, -0.04] } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { head: [0, 0.2, -0.03], hips: [0, 0.07, 0], hand: [0.02, 0.56, 0], foot: [-0.01, -0.01, -0.03] } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: { head: [0, 0.08, 0.02], hips: [0, 0.03, 0], hand: [0.08, 0.34, 0.03], foot: [0, 0, 0.02] } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.2, 0.04, 0], hips: [0.05, 0.04, 0], "left-hand": [0.1, 0.34, 0], "right-hand": [0.06, 0.04, 0.06], "left-foot": [-0.02, 0, 0], "right-foot": [0, 0.06, -0.03],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: { // rocks from foot to foot
    head: [-0.13, 0, 0.04], hips: [-0.06, 0.01, 0.02], "left-hand": [-0.04, 0.02, -0.17], "right-hand": [-0.02, 0.05, 0.2], "left-foot": [-0.02, 0.1, 0.15], "right-foot": [0, 0, -0.04],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: {
    head: [-0.08, 0.04, 0], hips: [0.07, 0, 0.02], "right-hand": [-0.02, 0.62, 0.02], "left-hand": [-0.06, 0.02, 0.1], "left-foot": [0.1, 0, 0], "right-foot": [-0.02, 0.02, 0],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: {
    head: [-0.02, -0.22, 0.36], hips: [0, -0.02, -0.06], "right-hand": [0.16, -0.1, 0.22], "left-hand": [0.08, 0.22, -0.1], "right-foot": [0, 0.01, -0.1],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0.03, 0.1], hips: [0, 0.03, 0.02], "left-hand": [-0.04, 0.1, 0.22], "right-hand": [-0.02, 0.05, -0.16], "left-foot": [-0.02, 0.06, -0.12], "right-foot": [0.02, 0.02, 0.12],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // on tiptoe, hands like paws
    head: [-0.06, -0.05, 0.1], hips: [-0.04, -0.02, 0.02], "left-hand": [-0.06, 0.18, 0.16], "right-hand": [0.06, 0.18, 0.16], "left-foot": [-0.02, 0.12, 0.12], "right-foot": [0, 0, -0.02],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.3, groundContact: true, inPlace: false, symmetry: true };
