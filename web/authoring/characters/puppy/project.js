// The puppy's points and poses. Each foreleg follows the foot across, as in a trot, so that all four paws stand; ears and tail
// have no joint: they follow the whole pose, a little against it.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.2, 0.34], radius: 0.19 },
  { id: "left-fore", name: "Left forepaw", joint: "RightFoot", near: [0.165, 0, 0.27], radius: 0.07, mirror: "right-fore" },
  { id: "right-fore", name: "Right forepaw", joint: "LeftFoot", near: [-0.165, 0, 0.27], radius: 0.07, mirror: "left-fore" },
  { id: "hind", name: "Hind paw", joint: "Foot", near: [0.2, 0, -0.31], radius: 0.07, pair: true },
  { id: "hips", name: "Back", joint: "Hips", near: [0, 0.73, -0.25], radius: 0.1 },
  { id: "chest", name: "Chest", joint: "Spine2", near: [0, 0.5, 0.38], radius: 0.09 },
  { id: "ear", name: "Ear", joint: null, near: [0.37, 0.78, 0.33], radius: 0.04, pair: true },
  { id: "tail", name: "Tail", joint: null, near: [0, 1.01, -0.53], radius: 0.04 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: { // a heap with ears in the air
    head: [0, -0.22, 0.06], chest: [0, -0.15, 0.03], hips: [0, -0.15, 0], ear: [0.1, -0.06, 0.02], tail: [0, -0.02, 0.06], "left-fore": [0.04, 0, 0.03], "right-fore": [-0.04, 0, 0.03], hind: [0.04, 0, -0.02],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { // bows to play
    head: [0, -0.2, 0.08], chest: [0, -0.19, 0.05], hips: [0, -0.03, -0.05], ear: [0.02, -0.22, 0.06], tail: [0.04, 0.02, 0.04], "left-fore": [0.02, 0, 0.04], "right-fore": [-0.02, 0, 0.04],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { head: [0, 0.13, -0.02], chest: [0, 0.1, -0.01], hips: [0, 0.05, 0.03], ear: [-0.02, 0.02, 0], tail: [0, -0.08, -0.04] } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // rears in the air, paws forward
    head: [0, 0.22, -0.06], chest: [0, 0.15, -0.03], hips: [0, 0.05, 0.02], ear: [0.14, 0.34, -0.04], tail: [0, -0.16, -0.08], "left-fore": [0.02, 0.2, 0.12], "right-fore": [-0.02, 0.2, 0.12], hind: [0.02, -0.02, -0.1],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.06, 0.04], chest: [0, 0.04, 0.02], hips: [0, 0.03, 0], ear: [0.16, 0.3, 0], tail: [0, 0.06, 0.02], "left-fore": [0, 0.03, 0.06], "right-fore": [0, 0.03, 0.06],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.14, 0.05, 0], chest: [0.08, 0.04, 0], hips: [0.04, 0.04, 0], "left-ear": [0.26, 0.2, 0], "right-ear": [0.16, 0.02, 0], tail: [-0.22, 0.02, 0.02],
    "left-fore": [0, 0.01, 0], "right-fore": [0, 0.07, 0.03], "left-hind": [0, 0, 0], "right-hind": [0, 0.06, -0.02],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.04, 0.01, 0.03], chest: [-0.03, 0.01, 0.02], hips: [-0.03, 0.01, 0.02], "left-ear": [-0.03, 0.03, -0.02], "right-ear": [-0.05, 0.03, 0.03], tail: [0.14, 0, 0],
    "left-hind": [0, 0.08, 0.14], "right-hind": [0, 0, -0.06], "left-fore": [0, 0, -0.06], "right-fore": [0, 0.09, 0.15],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: {
    head: [0, 0.02, 0.05], chest: [0, 0.02, 0.04], hips: [0, 0.02, 0.02], ear: [0.06, 0.14, -0.1], tail: [0, -0.05, -0.05],
    "left-hind": [0, 0.06, -0.13], "right-hind": [0, 0.02, 0.13], "left-fore": [0, 0.03, 0.14], "right-fore": [0, 0.05, -0.12],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: {
    head: [-0.12, 0.06, 0], chest: [-0.05, 0.04, 0], hips: [0.07, -0.01, 0], "right-ear": [-0.14, 0.34, 0], "left-ear": [-0.1, -0.02, 0], tail: [0.2, 0.02, 0],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: {
    head: [-0.02, -0.16, 0.1], chest: [-0.02, -0.12, 0.03], hips: [-0.02, -0.09, 0], ear: [0, -0.18, 0.08], tail: [0, -0.14, -0.04],
    "left-hind": [0, 0.1, 0.1], "right-hind": [0, 0, -0.03], "left-fore": [0, 0, -0.03], "right-fore": [0, 0.12, 0.13],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: {
    head: [0, -0.3, 0.1], chest: [0, -0.24, 0.05], hips: [0, 0.02, -0.04], ear: [0.04, -0.3, 0.1], tail: [0.06, 0.08, 0.02],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.3, groundContact: true, inPlace: false, symmetry: true };
