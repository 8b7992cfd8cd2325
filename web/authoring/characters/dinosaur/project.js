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
    head: [0, -0.32, 0.12], chest: [0, -0.2, 0.05], hips: [0, -0.14, 0.0], hand: [0.16, -0.22, 0], foot: [0.04, 0, 0.01], tail: [0, 0.18, 0.08],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: { // bows down to leap, hands back, the tail high behind
    head: [0.01, -0.28, 0.2], chest: [0.01, -0.18, 0.08], hips: [0, -0.13, -0.04], hand: [0.26, -0.1, -0.14], foot: [0.02, 0, 0], tail: [0, 0.26, 0.1],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: { // long, still on the ground: the tail trails
    head: [0, 0.12, 0.0], chest: [0, 0.09, 0.01], hips: [0, 0.06, 0.02], hand: [0.06, 0.14, 0.08], foot: [0, 0, -0.03], tail: [0, -0.16, 0.04],
  } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // top of the leap
    head: [0, 0.24, -0.06], chest: [0, 0.16, -0.02], hips: [0, 0.07, 0.02], hand: [0.2, 0.64, -0.12], foot: [0.04, 0.06, -0.08], tail: [0, 0.05, 0.02],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.1, 0.04], chest: [0, 0.05, 0.01], hips: [0, 0.03, 0], hand: [0.24, 0.38, -0.02], foot: [0, 0, 0.05], tail: [0, 0.24, 0.06],
  } },
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { // a ball with a tail, about to go off
    head: [0, -0.42, 0.26], chest: [0, -0.28, 0.12], hips: [0, -0.22, -0.05], hand: [0.26, -0.2, -0.08], foot: [0.05, 0, 0], tail: [0, 0.14, 0.12],
  } },
  { id: "soars", motion: "jump", seconds: 1.27, moves: { // everything up, the tail hangs
    head: [0, 0.3, -0.1], chest: [0, 0.2, -0.04], hips: [0, 0.1, 0.04], hand: [0.14, 0.78, -0.16], foot: [0.05, 0.08, -0.06], tail: [0, -0.12, 0.06],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.22, 0.07, 0], chest: [0.09, 0.05, 0], hips: [0.03, 0.04, 0],
    "left-hand": [0.24, 0.42, 0], "right-hand": [-0.06, 0.24, 0.04], "left-foot": [0.0, 0.0, 0], "right-foot": [-0.02, 0.08, -0.05], tail: [-0.34, 0.1, 0.06],
  } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // stomps: the left foot far ahead, the tail swings over it
    head: [0.03, -0.02, 0.06], chest: [0.02, -0.02, 0.04], hips: [0.02, -0.03, 0.02],
    "left-hand": [0.18, -0.06, -0.12], "right-hand": [-0.06, 0.12, 0.12], "left-foot": [0.01, 0, 0.3], "right-foot": [0, 0, -0.24], tail: [0.22, 0.02, 0.03],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: { // high on the left foot, the right one passes
    head: [0.06, 0.01, 0.04], chest: [0.06, 0.01, 0.02], hips: [0.06, 0.01, 0.02],
    "left-hand": [0.1, -0.04, -0.06], "right-hand": [-0.04, 0.05, 0.05], "left-foot": [0, 0, 0], "right-foot": [-0.03, 0.26, -0.06], tail: [0.12, 0.03, 0.03],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: { // the weight rolls over the right foot
    head: [-0.06, -0.03, 0.05], chest: [-0.06, -0.02, 0.03], hips: [-0.06, -0.01, 0.03],
    "left-hand": [0.1, -0.04, -0.06], "right-hand": [0, 0.04, 0.08], "left-foot": [0.02, 0.2, 0.22], "right-foot": [0, 0, -0.11], tail: [-0.12, 0.03, 0.03],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // flies, both legs wide, nose and tail in one line
    head: [0, 0.19, 0.18], chest: [0, 0.17, 0.1], hips: [0, 0.14, 0.02], "left-hand": [0.06, 0.26, 0.1], "right-hand": [-0.18, -0.04, -0.14],
    "left-foot": [-0.02, 0.2, -0.38], "right-foot": [0.05, 0.08, 0.34], tail: [0.12, 0.22, 0],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // squashed on the right foot, the left knee high
    head: [-0.06, -0.22, 0.18], chest: [-0.06, -0.18, 0.08], hips: [-0.04, -0.07, 0], "left-hand": [0.02, 0.04, 0.06], "right-hand": [-0.02, 0, -0.04],
    "left-foot": [0.1, 0.08, 0.28], "right-foot": [0.04, 0, -0.08], tail: [-0.1, -0.02, 0.06],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // on one foot, the other high, hands like paws
    head: [-0.06, -0.04, 0.16], chest: [-0.06, -0.03, 0.09], hips: [-0.07, 0.02, 0], hand: [-0.02, 0.16, 0.06], "left-foot": [0.05, 0.2, 0.22], "right-foot": [0.02, 0, -0.02], tail: [-0.12, 0.1, 0.06],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: { // low, far apart
    head: [0.02, -0.32, 0.26], chest: [0.01, -0.22, 0.13], hips: [0.01, -0.16, -0.02], hand: [0, -0.04, 0.1], "left-foot": [0, 0.03, 0.26], "right-foot": [0, 0.02, -0.2], tail: [0.1, 0.06, 0.08],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: {
    head: [0, -0.5, 0.4], chest: [0, -0.32, 0.24], hips: [0, -0.13, -0.1], "right-hand": [0.02, -0.32, 0.2], "left-hand": [0.3, 0.16, -0.14], "left-foot": [0, 0, 0.08], "right-foot": [0, 0, -0.12], tail: [0, 0.22, 0.14],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // one claw up, hip out
    head: [-0.08, 0, -0.05], chest: [-0.02, -0.03, 0], hips: [0.11, -0.03, 0], "right-hand": [-0.18, 0.8, -0.06], "left-hand": [0.2, -0.1, -0.12], "right-foot": [-0.04, 0.03, 0.04], tail: [-0.3, 0, 0.08],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: { // steps out, low
    head: [-0.05, -0.12, 0.06], chest: [-0.03, -0.1, 0.03], hips: [0, -0.09, 0], "left-hand": [0.2, -0.1, -0.14], "right-hand": [-0.02, -0.06, 0.08], "left-foot": [0.14, 0.07, 0.06], "right-foot": [-0.08, 0, 0], tail: [0.26, 0.06, 0.06],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: {
    head: [0, 0.22, -0.04], chest: [0, 0.16, 0], hips: [0, 0.12, 0], hand: [0.12, 0.1, -0.06], "left-foot": [0.02, 0.1, 0.1], "right-foot": [0, 0.02, 0.02], tail: [0.1, -0.08, 0],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: { // the right foot up in front
    head: [0.1, -0.24, -0.08], chest: [0.09, -0.19, -0.04], hips: [0.07, -0.15, 0.02], hand: [0.12, -0.04, -0.06], "right-foot": [-0.12, 0.17, 0.3], "left-foot": [-0.04, 0, 0], tail: [-0.26, 0.04, 0.06],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: { // gathers itself
    head: [0, -0.2, 0.14], chest: [0, -0.16, 0.07], hips: [0, -0.14, -0.02], "left-hand": [0.1, -0.14, -0.12], "right-hand": [-0.1, -0.16, -0.12], tail: [0, 0.02, 0.08],
  } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: { // rises, claw up
    head: [0.04, 0.14, -0.12], chest: [0.02, 0.12, -0.06], hips: [0, 0.09, 0.02], "right-hand": [-0.24, 0.6, -0.06], "left-hand": [0.06, 0.06, 0.08], foot: [0, 0.02, 0], tail: [0.12, -0.08, 0.04],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: {
    head: [0.18, 0.04, -0.22], chest: [0.08, 0.05, -0.1], hips: [0.04, 0.03, 0.05], "right-hand": [-0.04, 1, -0.2], "left-hand": [0.06, 0.26, 0.06], foot: [0, 0, 0], tail: [-0.3, -0.04, 0.06],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: {
    head: [0, 0.06, -0.26], chest: [-0.02, 0.06, -0.13], hips: [-0.05, 0.04, 0.05], "right-hand": [-0.46, 0.5, -0.34], "left-hand": [0, 0.32, 0.04], foot: [0, 0, 0], tail: [0.26, -0.04, 0.06],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // winds up behind, nose down
    head: [0.1, -0.3, 0.3], chest: [0.07, -0.18, 0.16], hips: [0.07, -0.1, 0], "left-hand": [0.3, -0.1, -0.06], "right-hand": [-0.12, 0.12, 0.08], "right-foot": [-0.06, 0.16, -0.36], "left-foot": [-0.04, 0, 0], tail: [0.3, 0.12, 0.06],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // thrown back, the foot before the chest, the tail props
    head: [0.08, 0.06, -0.3], chest: [0.06, 0.05, -0.18], hips: [0.06, 0.04, 0.04], "left-hand": [0.04, 0.4, 0.08], "right-hand": [-0.28, -0.06, -0.16], "right-foot": [-0.16, 0.5, 0.58], "left-foot": [-0.03, 0, 0.02], tail: [-0.2, -0.1, 0.1],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: {
    head: [-0.1, -0.12, 0.1], chest: [-0.06, -0.1, 0.05], hips: [-0.03, -0.09, 0], "left-hand": [-0.08, -0.06, 0.12], "right-hand": [-0.1, -0.1, -0.12], foot: [0.02, 0, 0], tail: [0.44, 0.04, 0.14],
  } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.07, -0.05, 0], chest: [0.05, -0.05, 0], hips: [0.03, -0.06, 0], "left-hand": [0.34, 0.14, -0.12], "right-hand": [-0.04, 0.2, 0.16], "right-foot": [0, 0.09, 0], tail: [-0.44, 0.12, 0.16],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // arms wide, the tail flies round
    head: [0.02, -0.05, -0.14], chest: [0.02, -0.05, -0.06], hips: [0.03, -0.05, 0], "left-hand": [0.42, 0.3, -0.3], "right-hand": [-0.42, 0.42, -0.04], "right-foot": [0, 0.1, -0.06], tail: [0.3, 0.22, 0.1],
  } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: {
    head: [0.03, -0.004, 0], chest: [0.04, -0.004, 0], hips: [0.045, -0.004, 0], hand: [0.01, -0.02, -0.03], tail: [-0.08, 0, 0],
  } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: {
    head: [0.03, -0.004, -0.04], chest: [0.035, -0.002, 0.01], hips: [0.035, -0.003, 0], hand: [0.025, 0.02, -0.01], tail: [0.02, -0.03, 0.01],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
