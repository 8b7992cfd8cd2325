// The bird's points and poses: wings for hands, and a tail that follows the whole pose.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.08, 0.24], radius: 0.19 },
  { id: "wing", name: "Wing", joint: "Hand", near: [0.86, 0.6, -0.02], radius: 0.05, pair: true },
  { id: "foot", name: "Foot", joint: "Foot", near: [0.14, 0, 0.04], radius: 0.08, pair: true },
  { id: "hips", name: "Belly", joint: "Hips", near: [0, 0.5, 0.31], radius: 0.12 },
  { id: "elbow", name: "Feathers", joint: "ForeArm", near: [0.5, 0.76, -0.02], radius: 0.05, pair: true },
  { id: "tail", name: "Tail", joint: null, near: [0, 0.55, -0.57], radius: 0.05 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { // a ball on two feet
    head: [0, -0.24, 0.05], hips: [0, -0.13, 0.04], wing: [-0.05, -0.3, 0.1], elbow: [0.02, -0.17, 0.03], foot: [0.03, 0, 0], tail: [0, 0.08, 0.05],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { // bows, wings back and down, tail up
    head: [0.01, -0.22, 0.13], hips: [0, -0.11, 0.02], wing: [-0.12, -0.2, -0.36], elbow: [-0.01, -0.13, -0.12], foot: [0.02, 0, 0], tail: [0, 0.14, 0.08],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { // on its toes, the wings on their way up
    head: [0, 0.14, 0], hips: [0, 0.07, 0.01], wing: [-0.04, 0.24, 0.12], elbow: [0, 0.15, 0.04], foot: [0, 0, -0.04], tail: [0, -0.1, 0.03],
  } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // wings spread high
    head: [0, 0.16, -0.03], hips: [0, 0.06, 0.01], wing: [-0.12, 0.68, 0], elbow: [-0.04, 0.32, 0], foot: [-0.01, -0.02, -0.05], tail: [0, -0.08, -0.02],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.07, 0.02], hips: [0, 0.03, 0], wing: [-0.02, 0.4, 0.04], elbow: [-0.01, 0.2, 0.02], foot: [0, 0, 0.02], tail: [0, 0.08, 0],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: { // banks like a plane
    head: [0.17, 0.05, 0], hips: [0.05, 0.04, 0],
    "left-wing": [-0.04, 0.46, 0], "left-elbow": [0.03, 0.22, 0], "right-wing": [0.12, -0.08, 0.05], "right-elbow": [0.06, 0.04, 0.02],
    "left-foot": [-0.02, 0, 0], "right-foot": [-0.01, 0.05, -0.03], tail: [-0.12, 0.02, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: { // a waddle
    head: [-0.12, 0.0, 0.04], hips: [-0.06, 0.02, 0.03],
    "left-wing": [-0.05, 0.12, -0.12], "left-elbow": [-0.03, 0.06, -0.05], "right-wing": [-0.02, -0.06, 0.14], "right-elbow": [-0.04, -0.03, 0.06],
    "left-foot": [-0.02, 0.09, 0.15], "right-foot": [0, 0, -0.04], tail: [0.03, 0.02, 0],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0.03, 0.08], hips: [0, 0.02, 0.02], "left-wing": [-0.08, 0.14, 0.26], "left-elbow": [-0.03, 0.07, 0.1], "right-wing": [0.04, 0.08, -0.22], "right-elbow": [0.02, 0.04, -0.08],
    "left-foot": [-0.02, 0.06, -0.12], "right-foot": [0.01, 0.02, 0.12], tail: [0, 0.1, 0],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: {
    head: [-0.04, -0.05, 0.09], hips: [-0.04, -0.02, 0.02], "left-wing": [-0.2, 0.1, 0.25], "right-wing": [0.2, 0.1, 0.25], "left-elbow": [-0.06, 0.04, 0.1], "right-elbow": [0.06, 0.04, 0.1],
    "left-foot": [-0.02, 0.1, 0.12], "right-foot": [0, 0, -0.02], tail: [0, 0.08, 0],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { // one wing across, one spread, the tail up
    head: [0, -0.22, 0.2], hips: [0, -0.04, -0.05], "right-wing": [0.42, -0.06, 0.36], "right-elbow": [0.14, -0.04, 0.14], "left-wing": [0, 0.2, -0.2], "left-elbow": [0.02, 0.06, -0.06],
    "right-foot": [0, 0, -0.1], tail: [0, 0.26, 0.02],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.3, groundContact: true, inPlace: false, symmetry: true };
