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
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { // flat
    head: [0, -0.342, 0.18], hips: [0, -0.18, 0], "left-hand": [0.2, -0.14, -0.14],
    "right-hand": [-0.2, -0.14, -0.14], "left-foot": [0.04, 0, 0], "right-foot": [-0.04, 0, 0],
  } },
  { id: "soars", motion: "jump", seconds: 1.27, moves: { // long
    head: [0, 0.234, -0.072], hips: [0, 0.081, 0.018], "left-hand": [0.2, 0.5, -0.04],
    "right-hand": [-0.2, 0.5, -0.04], "left-foot": [0.02, 0.029, -0.044], "right-foot": [-0.02, 0.029, -0.044],
  } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // rocks onto its left heel
    head: [0.036, -0.018, 0.054], hips: [0.018, -0.027, 0.018], "left-hand": [0.072, 0, -0.24],
    "right-hand": [0, 0.069, 0.24], "left-foot": [0, 0.07, 0.19], "right-foot": [0, 0.05, -0.15],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: {
    head: [0.063, 0.009, 0.036], hips: [0.045, 0.009, 0.018],
    "left-hand": [0.072, 0, -0.08], "right-hand": [-0.029, 0.026, 0.06], "right-foot": [-0.03, 0.158, -0.053],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: { // rocks from foot to foot
    head: [-0.072, -0.009, 0.036], hips: [-0.054, 0.009, 0.027], "left-hand": [0.029, 0, -0.12],
    "right-hand": [-0.029, 0.026, 0.1], "left-foot": [0, 0.13, 0.176], "right-foot": [0, 0, -0.079],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // rolls ahead, both feet in the air
    head: [0, 0.081, 0.144], hips: [0, 0.063, 0.018], "left-hand": [0.058, 0.258, 0.24],
    "right-hand": [-0.145, 0.034, -0.26], "left-foot": [-0.02, 0.08, -0.24], "right-foot": [0.03, 0.04, 0.26],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // squashed on one foot
    head: [-0.06, -0.18, 0.14], hips: [-0.04, -0.1, 0], "left-hand": [0.058, 0.052, 0.12],
    "right-hand": [-0.087, 0.017, 0.04], "left-foot": [0.05, 0.08, 0.2], "right-foot": [0.03, 0, -0.07],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // on tiptoe, hands like paws
    head: [-0.05, 0, 0.16], hips: [-0.054, 0, 0.018], "left-hand": [-0.058, 0.172, 0.26],
    "right-hand": [0.058, 0.172, 0.26], "left-foot": [0.05, 0.14, 0.2], "right-foot": [0, 0, -0.018],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: {
    head: [0.02, -0.32, 0.24], hips: [0.01, -0.17, 0], "left-hand": [0.029, 0.017, 0.24],
    "right-hand": [0.029, 0.034, 0.28], "left-foot": [0, 0, 0.211], "right-foot": [0, 0, -0.176],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { // tips over to the front
    head: [0, -0.36, 0.42], hips: [0, -0.15, -0.06], "left-hand": [0.319, 0.206, -0.12],
    "right-hand": [-0.06, -0.26, 0.24], "left-foot": [0, 0, 0.088], "right-foot": [0, 0, -0.088],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // one hand up, the belly out
    head: [-0.09, 0, -0.036], hips: [0.09, -0.045, 0], "left-hand": [0.145, -0.017, -0.1],
    "right-hand": [-0.26, 0.5, -0.04], "left-foot": [0.02, 0, 0], "right-foot": [-0.03, 0.022, 0.035],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: {
    head: [-0.045, -0.126, 0.054], hips: [0, -0.099, 0], "left-hand": [0.203, -0.017, -0.12],
    "right-hand": [0.029, -0.017, 0.12], "left-foot": [0.13, 0.043, 0.053], "right-foot": [-0.07, 0, 0],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: {
    head: [0, 0.126, -0.036], hips: [0, 0.072, 0], "left-hand": [0.145, 0.12, -0.04],
    "right-hand": [-0.145, 0.12, -0.04], "left-foot": [0.02, 0.06, 0.1], "right-foot": [0, 0.022, 0.018],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: { // sits down a little and shows its sole
    head: [0.072, -0.162, -0.045], hips: [0.054, -0.108, 0.018], "left-hand": [0.116, -0.034, -0.06],
    "right-hand": [-0.116, -0.034, -0.06], "left-foot": [-0.03, 0, 0], "right-foot": [-0.08, 0.1, 0.22],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: {
    head: [0, -0.162, 0.108], hips: [0, -0.099, 0], "left-hand": [0.116, -0.086, -0.2], "right-hand": [-0.116, -0.103, -0.18],
  } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: {
    head: [0.045, 0.108, -0.09], hips: [0.009, 0.063, 0.018], "left-hand": [0.029, 0.103, 0.14],
    "right-hand": [-0.261, 0.516, 0], "left-foot": [0, 0.007, 0], "right-foot": [0, 0.007, 0],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: { // leans back to be seen
    head: [0.126, 0.027, -0.144], hips: [0.027, 0.018, 0.036], "left-hand": [0.029, 0.224, 0.14], "right-hand": [-0.058, 0.705, -0.14],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: {
    head: [0.018, 0.036, -0.18], hips: [-0.027, 0.018, 0.036], "left-hand": [0, 0.275, 0.1], "right-hand": [-0.551, 0.43, -0.24],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // tips onto its nose
    head: [0.06, -0.14, 0.32], hips: [0.054, -0.072, 0], "left-hand": [0.145, 0.052, -0.28],
    "right-hand": [0.058, 0.206, 0.28], "left-foot": [-0.03, 0, 0], "right-foot": [-0.06, 0.144, -0.264],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // rolls on its back
    head: [0.05, 0.04, -0.4], hips: [0.045, 0.018, 0.036], "left-hand": [-0.029, 0.31, 0.22],
    "right-hand": [-0.232, 0, -0.26], "left-foot": [-0.03, 0, 0.018], "right-foot": [-0.1, 0.18, 0.36],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: {
    head: [-0.09, -0.108, 0.072], hips: [-0.027, -0.072, 0], "left-hand": [-0.087, -0.034, 0.14],
    "right-hand": [-0.145, -0.052, -0.16], "left-foot": [0.02, 0, 0], "right-foot": [-0.02, 0, 0],
  } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.072, -0.036, 0], hips: [0.027, -0.045, 0],
    "left-hand": [0.406, 0.155, -0.16], "right-hand": [0, 0.172, 0.24], "right-foot": [0, 0.065, 0],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // a top
    head: [0.018, -0.036, -0.126], hips: [0.018, -0.045, 0],
    "left-hand": [0.435, 0.258, -0.3], "right-hand": [-0.435, 0.344, -0.04], "right-foot": [0, 0.072, -0.053],
  } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: {
    head: [0.03, -0.004, 0], hips: [0.04, -0.004, 0], "left-hand": [0, -0.017, -0.04], "right-hand": [0, -0.017, -0.04],
  } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: {
    head: [0.035, -0.004, -0.035], hips: [0.035, -0.004, 0], "left-hand": [0.043, 0.017, -0.01], "right-hand": [-0.043, 0.017, -0.01],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
