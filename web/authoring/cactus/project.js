// The cactus's points and poses.
// To change a pose, change the table: moves of the points from rest, in metres of the cactus (1.4 m tall, its left at +x, front +z).

// Wide discs where the shape shall keep its character: the dome of the top, the pot's edges.
export const POINTS = [
  { id: "top", name: "Top", joint: "Head", near: [0, 1.4, 0], radius: 0.17, mirror: "top" },
  { id: "right-arm", name: "Right arm", joint: "RightHand", near: [-0.52, 1.05, 0], radius: 0.07, mirror: "left-arm" },
  { id: "left-arm", name: "Left arm", joint: "LeftHand", near: [0.52, 1.3, 0], radius: 0.07, mirror: "right-arm" },
  { id: "right-edge", name: "Right edge", joint: "RightFoot", near: [-0.21, 0, 0], radius: 0.09, mirror: "left-edge" },
  { id: "left-edge", name: "Left edge", joint: "LeftFoot", near: [0.21, 0, 0], radius: 0.09, mirror: "right-edge" },
  { id: "middle", name: "Middle", joint: "Hips", near: [0, 0.57, 0.3], radius: 0.08, mirror: "middle" },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  {
    id: "squash", // down on the landing: shorter, rounder, arms out and low
    motion: "hop",
    seconds: 3.24,
    moves: {
      top: [0, -0.28, 0.06],
      middle: [0, -0.09, 0.06],
      "right-arm": [-0.15, -0.36, 0.04],
      "left-arm": [0.15, -0.4, 0.04],
      "right-edge": [-0.03, 0, 0],
      "left-edge": [0.03, 0, 0],
    },
  },
  {
    id: "wind-up", // down before the first hop: arms thrown back
    motion: "hop",
    seconds: 0.35,
    moves: {
      top: [0.02, -0.24, 0.12],
      middle: [0, -0.08, 0.05],
      "right-arm": [-0.04, -0.3, -0.22],
      "left-arm": [0.04, -0.34, -0.22],
      "right-edge": [-0.02, 0, 0],
      "left-edge": [0.02, 0, 0],
    },
  },
  {
    // The last moment on the ground: long already, arms on their way up. The pot trails a little, or else the hops, whose
    // travel goes on from the edges' last speed on the ground, would wander backwards.
    id: "launch",
    motion: "hop",
    seconds: 2.47,
    moves: {
      top: [0, 0.16, 0],
      middle: [0, 0.04, 0.01],
      "right-arm": [-0.06, 0.06, 0.1],
      "left-arm": [0.04, 0.02, 0.1],
      "right-edge": [0, 0, -0.06],
      "left-edge": [0, 0, -0.06],
    },
  },
  {
    id: "stretch", // at the top of the big hop: longer, narrower, arms up
    motion: "hop",
    seconds: 2.76,
    moves: {
      top: [0, 0.28, -0.03],
      middle: [0, 0.07, 0.01],
      "right-arm": [0.05, 0.42, 0.02],
      "left-arm": [-0.05, 0.38, 0.02],
      "right-edge": [0.06, 0, 0],
      "left-edge": [-0.06, 0, 0],
    },
  },
  {
    id: "touchdown", // the first moment back on it: still long
    motion: "hop",
    seconds: 3.03,
    moves: {
      top: [0, 0.1, 0.02],
      middle: [0, 0.03, 0.01],
      "right-arm": [-0.1, 0.2, 0.04],
      "left-arm": [0.1, 0.16, 0.04],
    },
  },
  {
    id: "lean-left", // the hop to its left
    motion: "hop",
    seconds: 0.84,
    moves: {
      top: [0.24, 0.08, 0],
      middle: [0.05, 0.03, 0],
      "right-arm": [0.02, -0.1, 0.12],
      "left-arm": [0.13, 0.26, 0.06],
      "right-edge": [-0.03, 0.07, 0],
      "left-edge": [-0.05, -0.03, 0],
    },
  },
  {
    id: "step-left", // the left foot reaches forward: the left edge swings up and ahead, the weight is over the right one
    motion: "walk",
    seconds: 0.97,
    moves: {
      top: [-0.16, -0.01, 0.04],
      middle: [-0.05, 0.01, 0.02],
      "right-arm": [-0.1, -0.04, 0.2],
      "left-arm": [-0.1, 0.06, -0.16],
      "right-edge": [0, 0, -0.03],
      "left-edge": [-0.02, 0.1, 0.12],
    },
  },
  {
    id: "run", // in the air, the left edge behind
    motion: "run",
    seconds: 0.07,
    moves: { top: [0, 0.08, 0.16], middle: [0, 0.06, 0.03], "left-arm": [-0.06, 0.12, 0.26], "right-arm": [0.0, -0.04, -0.24], "left-edge": [0, 0.1, -0.17], "right-edge": [0, 0.03, 0.16] },
  },
  {
    id: "wave", // leans back, the whole right arm up
    motion: "wave",
    seconds: 1.3,
    moves: { top: [0.15, 0.01, -0.2], middle: [0.03, 0.01, 0.04], "right-arm": [0.06, 0.68, -0.1], "left-arm": [0.06, 0.12, 0.14] },
  },
  {
    id: "kick", // thrown back, the right edge of the pot high in front
    motion: "kick",
    seconds: 1.16,
    moves: { top: [0.08, -0.02, -0.3], middle: [0.05, -0.01, 0.02], "left-arm": [0.06, 0.36, 0.26], "right-arm": [-0.2, 0.04, -0.2], "right-edge": [0.02, 0.14, 0.16], "left-edge": [-0.02, 0, 0] },
  },
  {
    id: "turn", // arms wide
    motion: "turn",
    seconds: 1.4,
    moves: { top: [0.03, -0.05, -0.17], middle: [0.02, -0.02, 0], "left-arm": [0.22, 0.06, -0.22], "right-arm": [-0.24, 0.2, -0.02], "right-edge": [0.02, 0.08, -0.04] },
  },
  {
    id: "sneak", // the left edge in the air, arms like paws
    motion: "sneak",
    seconds: 0.6,
    moves: { top: [-0.05, -0.04, 0.16], middle: [-0.03, -0.03, 0.02], "left-arm": [-0.12, 0.02, 0.24], "right-arm": [0.12, 0.06, 0.24], "left-edge": [-0.02, 0.2, 0.12], "right-edge": [0, 0, -0.02] },
  },
  {
    id: "bow",
    motion: "bow",
    seconds: 1.9,
    moves: { top: [0, -0.2, 0.38], middle: [0, -0.02, -0.05], "right-arm": [0.16, -0.24, 0.34], "left-arm": [0.1, 0, -0.02], "right-edge": [0, 0, -0.05] },
  },
];

export const SETTINGS = { volume: 1, smoothness: 0.3, groundContact: true, inPlace: false, symmetry: true };
