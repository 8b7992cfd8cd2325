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
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { head: [0, -0.46, 0.2], chin: [0, -0.42, 0.04], nape: [0, -0.34, 0.06], elbow: [0, -0.2, -0.14] } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // shuffles, the shade looks where it goes
    head: [0.06, 0.02, 0.14], chin: [0.02, -0.01, 0.07], nape: [0.04, 0.03, 0.1], elbow: [0.01, 0, 0.02], "left-edge": [0, 0, 0.15], "right-edge": [0, 0, -0.13],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: { // rolls over its left edge
    head: [0.16, -0.05, 0], chin: [0.05, -0.01, 0.02], nape: [0.1, -0.04, 0], elbow: [0.03, -0.01, 0], "right-edge": [0.03, 0.12, -0.02], "left-edge": [0, 0, 0.02],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.18, -0.05, 0.04], chin: [-0.02, 0.01, 0.04], nape: [-0.11, -0.04, 0.02], elbow: [-0.04, 0.01, 0.02], "left-edge": [-0.03, 0.11, 0.1], "right-edge": [0, 0, -0.06],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // gallops: the base kicks out behind, the shade ahead
    head: [0, 0.08, 0.22], chin: [0, 0.08, 0.12], nape: [0, 0.08, 0.12], elbow: [0, 0.05, 0.02], "left-edge": [-0.02, 0.14, -0.28], "right-edge": [0.02, 0.06, 0.28],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // folds over one edge
    head: [-0.05, -0.16, 0.2], chin: [-0.03, -0.14, 0.1], nape: [-0.05, -0.12, 0.06], elbow: [-0.03, -0.07, -0.04], "left-edge": [-0.02, 0.14, 0.06], "right-edge": [0, 0, -0.06],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // cocks its head
    head: [-0.12, 0.01, -0.02], chin: [0.04, 0.03, 0.02], nape: [-0.05, 0.02, 0], elbow: [0.05, 0.01, 0], "left-edge": [0.04, 0, 0], "right-edge": [0, 0.04, 0.03],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: {
    head: [-0.03, -0.12, 0.06], chin: [0, -0.11, 0.02], nape: [-0.02, -0.08, 0.02], elbow: [0, -0.05, -0.04], "left-edge": [0.08, 0.06, 0.05], "right-edge": [-0.03, 0, 0],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: {
    head: [0, 0.14, -0.04], chin: [0, 0.15, 0.02], nape: [0, 0.1, 0], elbow: [0, 0.03, 0.02], "left-edge": [0, 0.1, 0.08], "right-edge": [0, 0.03, 0.02],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: { // shows the underside of its base
    head: [0.08, -0.18, -0.05], chin: [0.03, -0.18, 0], nape: [0.05, -0.15, -0.02], elbow: [0.03, -0.06, -0.02], "right-edge": [0.02, 0.18, 0.16], "left-edge": [-0.02, 0, 0],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: { head: [0, -0.26, 0.14], chin: [0, -0.23, 0.03], nape: [0, -0.18, 0.03], elbow: [0, -0.12, -0.08] } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: { // looks up
    head: [0.04, 0.1, -0.14], chin: [0.02, 0.14, 0.02], nape: [0.02, 0.06, -0.04], elbow: [0, 0.04, 0.03],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: { // nods to one side
    head: [0.12, 0.06, -0.16], chin: [0.0, 0.12, 0.03], nape: [0.06, 0.04, -0.05], elbow: [0, 0.03, 0.03],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: { // and to the other
    head: [-0.1, 0.08, -0.2], chin: [0.02, 0.14, 0.03], nape: [-0.05, 0.04, -0.07], elbow: [0, 0.03, 0.04],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // tips onto its front edge
    head: [0.05, -0.16, 0.24], chin: [0.03, -0.14, 0.1], nape: [0.04, -0.1, 0.12], elbow: [0.04, -0.05, 0.02], "right-edge": [0.02, 0.14, -0.2], "left-edge": [-0.02, 0, 0],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // the base flung up, the shade thrown back
    head: [0.06, 0.02, -0.22], chin: [0.03, 0.06, -0.1], nape: [0.04, 0.0, -0.14], elbow: [0.03, -0.01, -0.06], "right-edge": [0.04, 0.3, 0.22], "left-edge": [-0.02, 0, 0.02],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: { head: [-0.1, -0.1, 0.08], chin: [-0.03, -0.1, 0.03], nape: [-0.07, -0.07, 0.04], elbow: [0, -0.06, -0.03] } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.08, -0.04, 0], chin: [0.03, -0.04, 0.02], nape: [0.06, -0.03, 0], elbow: [0, -0.03, 0], "right-edge": [0.02, 0.08, 0],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // stretched, like a skater
    head: [0.02, 0.0, -0.1], chin: [0.01, 0.02, -0.02], nape: [0.02, 0, -0.05], elbow: [0, -0.01, 0], "right-edge": [0.02, 0.09, -0.04],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // peers ahead, one edge high
    head: [-0.05, -0.02, 0.22], chin: [-0.02, -0.02, 0.12], nape: [-0.04, -0.01, 0.12], elbow: [-0.03, -0.04, -0.04], "left-edge": [-0.02, 0.26, 0.06], "right-edge": [0, 0, 0],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: { // folded low
    head: [0.01, -0.36, 0.28], chin: [0.01, -0.34, 0.1], nape: [0.01, -0.25, 0.12], elbow: [0, -0.16, -0.12], "left-edge": [0, 0, 0.16], "right-edge": [0, 0, -0.14],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { head: [0, -0.4, 0.3], chin: [0, -0.44, 0.04], nape: [0, -0.22, 0.16], elbow: [0, -0.07, -0.06], "left-edge": [0, 0, 0.04], "right-edge": [0, 0, -0.03] } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: { head: [0.016, -0.002, 0], chin: [0.005, -0.006, 0], nape: [0.014, -0.006, 0], elbow: [0.02, -0.004, 0] } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: { head: [0.014, -0.002, -0.02], chin: [0.005, 0, 0], nape: [0.01, 0, -0.008], elbow: [0.016, 0, 0.004] } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
