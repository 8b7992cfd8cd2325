// The puppy's points and poses. Each foreleg follows the foot across, as in a trot, so that all four paws stand; its ears are its
// arms: they wave, point and fling. The tail has no joint: it wags with the whole pose.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.2, 0.34], radius: 0.19 },
  { id: "left-fore", name: "Left forepaw", joint: "RightFoot", near: [0.165, 0, 0.27], radius: 0.07, mirror: "right-fore" },
  { id: "right-fore", name: "Right forepaw", joint: "LeftFoot", near: [-0.165, 0, 0.27], radius: 0.07, mirror: "left-fore" },
  { id: "hind", name: "Hind paw", joint: "Foot", near: [0.2, 0, -0.31], radius: 0.07, pair: true },
  { id: "hips", name: "Back", joint: "Hips", near: [0, 0.73, -0.25], radius: 0.1 },
  { id: "chest", name: "Chest", joint: "Spine2", near: [0, 0.5, 0.38], radius: 0.09 },
  { id: "ear", name: "Ear", joint: "Hand", near: [0.37, 0.78, 0.33], radius: 0.04, pair: true },
  { id: "tail", name: "Tail", joint: null, near: [0, 1.01, -0.53], radius: 0.04 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { // a heap with ears in the air
    head: [0, -0.24, 0.08], chest: [0, -0.16, 0.03], hips: [0, -0.15, 0], ear: [0.2, 0.04, 0.0], tail: [0, -0.02, 0.06], "left-fore": [0.04, 0, 0.03], "right-fore": [-0.04, 0, 0.03], hind: [0.04, 0, -0.02],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { // bows to play
    head: [0, -0.22, 0.12], chest: [0, -0.19, 0.05], hips: [0, -0.05, -0.05], ear: [0.04, -0.2, -0.12], tail: [0.04, 0.02, 0.04], "left-fore": [0.02, 0, 0.04], "right-fore": [-0.02, 0, 0.04],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { head: [0, 0.13, -0.02], chest: [0, 0.1, -0.01], hips: [0, 0.05, 0.03], ear: [0.02, 0.08, 0.06], tail: [0, -0.08, -0.04] } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // rears in the air, paws forward
    head: [0, 0.18, -0.06], chest: [0, 0.15, -0.03], hips: [0, 0.05, 0.02], ear: [0.36, 0.5, -0.06], tail: [0, -0.16, -0.08], "left-fore": [0.02, 0.2, 0.14], "right-fore": [-0.02, 0.2, 0.14], hind: [0.02, -0.02, -0.1],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.06, 0.04], chest: [0, 0.04, 0.02], hips: [0, 0.03, 0], ear: [0.46, 0.34, -0.02], tail: [0, 0.06, 0.02], "left-fore": [0, 0.03, 0.06], "right-fore": [0, 0.03, 0.06],
  } },
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { // flat on the ground, ears back
    head: [0, -0.32, 0.16], chest: [0, -0.24, 0.05], hips: [0, -0.2, -0.02], ear: [0.18, -0.1, -0.16], tail: [0, -0.02, 0.06], "left-fore": [0.04, 0, 0.05], "right-fore": [-0.04, 0, 0.05], hind: [0.04, 0, -0.02],
  } },
  { id: "soars", motion: "jump", seconds: 1.27, moves: { // a star with ears
    head: [0, 0.2, -0.08], chest: [0, 0.15, -0.03], hips: [0, 0.07, 0.03], ear: [0.36, 0.54, -0.1], tail: [0, -0.16, -0.08], "left-fore": [0.04, 0.24, 0.2], "right-fore": [-0.04, 0.24, 0.2], hind: [0.04, 0, -0.14],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.16, 0.05, 0], chest: [0.09, 0.04, 0], hips: [0.04, 0.04, 0], "left-ear": [0.5, 0.5, 0], "right-ear": [-0.22, 0.1, 0], tail: [-0.22, 0.02, 0.02],
    "left-fore": [0, 0.01, 0], "right-fore": [0, 0.09, 0.03], "left-hind": [0, 0, 0], "right-hind": [0, 0.07, -0.03],
  } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // a trot: across, hind and fore far apart
    head: [0.03, -0.1, 0.07], chest: [0.02, -0.05, 0.03], hips: [0.02, -0.05, 0.01], "left-ear": [0.02, -0.02, -0.12], "right-ear": [-0.02, 0.06, 0.06], tail: [-0.2, 0, 0],
    "left-hind": [0.02, 0.02, 0.2], "right-hind": [0, 0.06, -0.2], "left-fore": [0, 0.06, -0.14], "right-fore": [0, 0.02, 0.26],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: {
    head: [0.03, 0.01, 0.05], chest: [0.03, 0.01, 0.02], hips: [0.03, 0.01, 0.01], "left-ear": [0.03, 0, -0.06], "right-ear": [-0.02, 0.03, 0.03], tail: [-0.1, 0, 0],
    "left-hind": [0, 0, 0], "right-hind": [-0.02, 0.2, -0.06], "left-fore": [0.02, 0.2, -0.04], "right-fore": [0, 0, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.04, 0.03, 0.03], chest: [-0.03, 0.01, 0.02], hips: [-0.03, 0.03, 0.02], "left-ear": [-0.01, 0.02, -0.06], "right-ear": [-0.02, 0.03, 0.02], tail: [0.16, 0, 0],
    "left-hind": [0, 0.1, 0.16], "right-hind": [0, 0, -0.1], "left-fore": [0, 0, -0.1], "right-fore": [0, 0.12, 0.2],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // flies long, ears streaming
    head: [0, 0.08, 0.12], chest: [0, 0.07, 0.07], hips: [0, 0.05, 0.02], "left-ear": [0.3, 0.2, 0.02], "right-ear": [-0.16, 0.06, -0.12], tail: [0, -0.05, -0.08],
    "left-hind": [0.02, 0.12, -0.28], "right-hind": [0, 0.05, 0.12], "left-fore": [0, 0.09, 0.34], "right-fore": [0, 0.1, -0.06],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // gathered low, ears late
    head: [-0.02, -0.14, 0.1], chest: [-0.03, -0.11, 0.04], hips: [-0.03, -0.08, 0.02], "left-ear": [0.08, 0.02, 0.06], "right-ear": [-0.02, 0.02, 0], tail: [0.08, 0.06, 0.02],
    "left-hind": [0.08, 0.06, -0.06], "right-hind": [0, 0, -0.08], "left-fore": [0, 0, -0.08], "right-fore": [-0.04, 0.09, 0.14],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // a paw in the air, frozen
    head: [-0.03, -0.05, 0.16], chest: [-0.03, -0.04, 0.05], hips: [-0.03, -0.01, 0.02], ear: [0.02, 0.02, 0.08], tail: [0, -0.1, -0.06],
    "left-hind": [0.03, 0.16, 0.1], "right-hind": [0, 0, -0.02], "left-fore": [0, 0, -0.02], "right-fore": [-0.03, 0.22, 0.14],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: { // belly to the ground
    head: [0.01, -0.36, 0.22], chest: [0.01, -0.28, 0.06], hips: [0.01, -0.22, 0], ear: [0.04, -0.12, 0.06], tail: [0, -0.12, -0.06],
    "left-hind": [0.02, 0, 0.18], "right-hind": [0, 0, -0.2], "left-fore": [0, 0, -0.14], "right-fore": [0, 0, 0.22],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { // the play bow: elbows down, tail high
    head: [0, -0.38, 0.2], chest: [0, -0.28, 0.08], hips: [0, 0, -0.08], "left-ear": [0.36, 0.02, 0], "right-ear": [-0.12, -0.26, 0.06], tail: [0.1, 0.06, 0.02],
    "left-hind": [0, 0, 0.04], "right-fore": [0, 0, 0.1], "right-hind": [0, 0, -0.04], "left-fore": [0, 0, 0.06],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // one ear up, the rump out
    head: [-0.1, 0.02, -0.03], chest: [-0.04, 0.0, 0], hips: [0.1, -0.05, 0], "right-ear": [-0.44, 0.78, -0.06], "left-ear": [0.02, -0.04, 0.06], tail: [0.24, 0.02, 0], "right-hind": [0, 0.02, 0.04], "left-fore": [0.02, 0.02, 0.06],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: { // low, paws apart
    head: [-0.03, -0.15, 0.06], chest: [0, -0.11, 0.02], hips: [0.02, -0.1, 0], "left-ear": [0.18, 0, -0.08], "right-ear": [-0.12, -0.08, 0.04], tail: [-0.2, 0, 0],
    "left-hind": [0.12, 0.06, 0.06], "right-hind": [-0.06, 0, 0], "left-fore": [0.06, 0, 0], "right-fore": [-0.1, 0.06, 0.04],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: { // all four off the ground
    head: [0, 0.18, -0.04], chest: [0, 0.13, 0], hips: [0, 0.1, 0.01], ear: [0.2, 0.14, -0.04], tail: [0, -0.06, -0.02],
    "left-hind": [0, 0.08, 0.08], "right-hind": [0, 0.03, 0.02], "left-fore": [0, 0.03, 0.02], "right-fore": [0, 0.1, 0.1],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: { // gives the left paw
    head: [0.03, -0.26, -0.04], chest: [0, -0.19, 0], hips: [0.05, -0.18, 0], ear: [0.06, -0.02, -0.08], tail: [-0.24, 0, 0],
    "right-hind": [-0.03, 0.16, 0.2], "left-hind": [-0.02, 0, 0], "left-fore": [0.06, 0.3, 0.3], "right-fore": [0.02, 0, 0],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: {
    head: [0, -0.2, 0.1], chest: [0, -0.14, 0.04], hips: [0, -0.12, -0.02], "left-ear": [0.04, -0.12, -0.12], "right-ear": [-0.04, -0.14, -0.1], tail: [0, 0.02, 0.02],
  } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: { // up, an ear and a paw lifted
    head: [0.05, 0.12, -0.08], chest: [0.03, 0.1, -0.04], hips: [0.01, 0.04, -0.02], "right-ear": [-0.42, 0.62, -0.04], "left-ear": [0.06, 0.12, 0.06], tail: [0.12, -0.02, 0],
    "right-fore": [-0.03, 0.16, 0.1],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: { // the paw asks, the ear stands, the tail wags
    head: [0.12, 0.06, -0.12], chest: [0.07, 0.06, -0.06], hips: [0.04, -0.02, -0.04], "right-ear": [-0.38, 0.88, -0.12], "left-ear": [0.06, 0.22, 0.06], tail: [-0.26, 0, 0.02],
    "right-fore": [0.0, 0.42, 0.22],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: {
    head: [0.04, 0.08, -0.16], chest: [0.03, 0.08, -0.08], hips: [0, -0.02, -0.05], "right-ear": [-0.64, 0.48, -0.16], "left-ear": [0.02, 0.3, 0.04], tail: [0.26, 0, 0.02],
    "right-fore": [-0.14, 0.34, 0.16],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // kicks out behind, nose down
    head: [0.06, -0.26, 0.2], chest: [0.05, -0.15, 0.05], hips: [0.05, -0.04, 0.02], "left-ear": [0.06, -0.02, -0.14], "right-ear": [-0.12, 0.08, 0.1], tail: [0.2, 0.08, 0.02],
    "right-hind": [-0.05, 0.24, -0.3], "left-hind": [-0.03, 0, 0.02], "left-fore": [0.02, 0, 0.05], "right-fore": [0.02, 0, 0],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // rears, the left paw flies up
    head: [0.03, 0.16, -0.24], chest: [0.02, 0.14, -0.13], hips: [0.03, -0.08, -0.06], "left-ear": [0.46, 0.5, 0.04], "right-ear": [-0.3, -0.04, -0.1], tail: [-0.2, -0.04, 0],
    "right-hind": [-0.06, 0.1, 0.2], "left-hind": [0.02, 0, 0], "left-fore": [0.08, 0.52, 0.32], "right-fore": [0, 0.2, 0.08],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: {
    head: [-0.08, -0.1, 0.06], chest: [-0.07, -0.1, 0.02], hips: [0.03, -0.1, 0], "left-ear": [-0.04, -0.06, 0.08], "right-ear": [-0.14, -0.06, -0.08], tail: [0.24, 0, 0.04],
  } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.1, -0.04, 0], chest: [0.06, -0.05, 0], hips: [-0.02, -0.06, 0], "left-ear": [0.32, 0.24, -0.08], "right-ear": [-0.1, 0.12, 0.1], tail: [-0.28, 0.02, 0.02],
    "right-hind": [-0.02, 0.1, 0], "left-fore": [0.02, 0.1, 0.02],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // ears like a carousel
    head: [0.02, 0, -0.06], chest: [0.02, -0.02, -0.04], hips: [0.01, -0.06, 0], "left-ear": [0.36, 0.3, -0.16], "right-ear": [-0.36, 0.36, -0.06], tail: [0.24, 0.02, 0.02],
    "right-hind": [-0.03, 0.12, -0.03], "left-fore": [0.03, 0.12, 0.03],
  } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: {
    head: [0.045, 0, 0], chest: [0.035, 0, 0], hips: [0.03, 0, 0], ear: [0.01, -0.03, -0.03], tail: [-0.1, 0, 0],
  } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: {
    head: [0.042, 0, -0.03], chest: [0.03, 0, 0.01], hips: [0.03, 0, 0], ear: [0.03, 0.02, -0.02], tail: [0.1, 0, 0],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
