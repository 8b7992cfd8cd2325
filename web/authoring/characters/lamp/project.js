// The lamp's points and poses. It has one foot, whose edges follow the human's feet, and speaks with its shade and its elbow.

export const POINTS = [
  { id: "head", name: "Shade", joint: "Head", near: [0, 1.32, 0.3], radius: 0.12 },
  { id: "chin", name: "Chin", joint: "Neck", near: [0, 0.74, 0.28], radius: 0.08 },
  { id: "nape", name: "Nape", joint: "Spine2", near: [0, 1.1, -0.14], radius: 0.04 },
  { id: "elbow", name: "Elbow", joint: "Spine", near: [0, 0.53, -0.32], radius: 0.05 },
  { id: "edge", name: "Edge", joint: "Foot", near: [0.33, 0.02, 0], radius: 0.13, pair: true },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { head: [0, -0.36, 0.12], chin: [0, -0.3, 0.04], nape: [0, -0.3, 0.02], elbow: [0, -0.16, -0.1] } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { head: [0, -0.3, 0.2], chin: [0, -0.32, 0.04], nape: [0, -0.2, 0.06], elbow: [0, -0.13, -0.1] } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { head: [0, 0.15, -0.06], chin: [0, 0.16, 0.02], nape: [0, 0.1, -0.03], elbow: [0, 0.06, 0.05] } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // the whole arm straight, face to the sky
    head: [0, 0.2, -0.14], chin: [0, 0.26, 0.03], nape: [0, 0.12, -0.04], elbow: [0, 0.08, 0.09], edge: [-0.02, 0, -0.02],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: { head: [0, 0.06, 0.06], chin: [0, 0.04, 0.02], nape: [0, 0.05, 0.02], elbow: [0, 0.02, 0.02] } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.24, 0.02, 0], chin: [0.1, 0.06, 0.03], nape: [0.15, 0.04, 0], elbow: [0.08, 0.03, 0], "left-edge": [-0.02, -0.02, 0], "right-edge": [0.02, 0.08, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.12, 0, 0.06], chin: [-0.02, 0.01, 0.04], nape: [-0.08, 0.01, 0.04], elbow: [-0.04, 0.01, 0.02], "left-edge": [-0.02, 0.09, 0.12], "right-edge": [0, 0, -0.03],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0, 0.14], chin: [0, 0, 0.08], nape: [0, 0.02, 0.09], elbow: [0, 0.02, 0.03], "left-edge": [0, 0.06, -0.1], "right-edge": [0, 0.03, 0.08],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // cocks its head
    head: [-0.26, 0.06, -0.02], chin: [0.06, 0.1, 0.03], nape: [-0.12, 0.08, 0], elbow: [0.06, 0.02, 0], "left-edge": [0.02, 0, 0], "right-edge": [0, 0.02, 0],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: {
    head: [-0.04, -0.16, 0.16], chin: [-0.02, -0.17, 0.08], nape: [-0.03, -0.1, 0.08], elbow: [-0.02, -0.08, -0.06], "left-edge": [-0.02, 0.1, 0.08], "right-edge": [0, 0, -0.02],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { head: [0, -0.36, 0.26], chin: [0, -0.42, 0.02], nape: [0, -0.2, 0.14], elbow: [0, -0.05, -0.06], "right-edge": [0, 0, -0.03] } },
];

export const SETTINGS = { volume: 1, smoothness: 0.25, groundContact: true, inPlace: false, symmetry: true };
