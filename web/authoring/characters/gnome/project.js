// The gnome's points and poses. The hat's tip has no joint: it swings after the head.

export const POINTS = [
  { id: "head", name: "Head", joint: "Head", near: [0, 1.4, 0.13], radius: 0.12 },
  { id: "hand", name: "Hand", joint: "Hand", near: [0.54, 0.41, 0.12], radius: 0.06, pair: true },
  { id: "foot", name: "Foot", joint: "Foot", near: [0.17, 0, 0.07], radius: 0.09, pair: true },
  { id: "hips", name: "Belt", joint: "Hips", near: [0, 0.53, 0.31], radius: 0.09 },
  { id: "chest", name: "Beard", joint: "Spine2", near: [0, 0.83, 0.33], radius: 0.08 },
  { id: "tip", name: "Hat", joint: null, near: [0.22, 1.5, 0.03], radius: 0.04 },
];

export const POSES = [
  { id: "rest", motion: "hop", seconds: 0, moves: {} },
  { id: "squash", motion: "hop", seconds: 3.24, moves: {
    head: [0, -0.25, 0.08], chest: [0, -0.21, 0.07], hips: [0, -0.12, 0.03], hand: [0.12, -0.06, 0.06], foot: [0.03, 0, 0], tip: [0.02, -0.27, 0.1],
  } },
  { id: "wind-up", motion: "hop", seconds: 0.35, moves: {
    head: [0.01, -0.21, 0.15], chest: [0.01, -0.18, 0.1], hips: [0, -0.1, 0.02], hand: [0.0, -0.02, -0.28], foot: [0.02, 0, 0], tip: [0.02, -0.22, 0.2],
  } },
  { id: "launch", motion: "hop", seconds: 2.47, moves: {
    head: [0, 0.13, 0], chest: [0, 0.09, 0], hips: [0, 0.05, 0.01], hand: [0.08, 0.2, 0.16], foot: [0, 0, -0.04], tip: [0.0, 0.05, -0.03],
  } },
  { id: "stretch", motion: "hop", seconds: 2.76, moves: { // arms up, the hat left behind
    head: [0, 0.2, -0.03], chest: [0, 0.13, 0], hips: [0, 0.06, 0.01], hand: [0.14, 0.68, 0], foot: [-0.01, -0.01, -0.04], tip: [0.03, 0.1, -0.06],
  } },
  { id: "touchdown", motion: "hop", seconds: 3.03, moves: {
    head: [0, 0.07, 0.03], chest: [0, 0.05, 0.02], hips: [0, 0.03, 0], hand: [0.18, 0.4, 0.06], foot: [0, 0, 0.02], tip: [0.04, 0.15, 0],
  } },
  { id: "lean-left", motion: "hop", seconds: 0.84, moves: {
    head: [0.2, 0.06, 0], chest: [0.1, 0.04, 0], hips: [0.04, 0.04, 0],
    "left-hand": [0.22, 0.48, 0.02], "right-hand": [0.0, 0.14, 0.08], "left-foot": [-0.02, 0, 0], "right-foot": [0, 0.06, -0.03], tip: [0.1, 0.06, 0],
  } },
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { // sits on its heels
    head: [0, -0.26, 0.16], chest: [0, -0.22, 0.1], hips: [0, -0.14, 0.02], "left-hand": [0.2, -0.02, -0.2],
    "right-hand": [-0.2, -0.02, -0.2], "left-foot": [0.04, 0, 0], "right-foot": [-0.04, 0, 0], tip: [0.02, -0.27, 0.18],
  } },
  { id: "soars", motion: "jump", seconds: 1.27, moves: { // arms up, the hat left behind
    head: [0, 0.247, -0.076], chest: [0, 0.162, -0.019], hips: [0, 0.085, 0.019], "left-hand": [0.12, 0.612, -0.095],
    "right-hand": [-0.12, 0.612, -0.095], "left-foot": [0.02, 0.028, -0.048], "right-foot": [-0.02, 0.028, -0.048], tip: [0.02, 0.18, -0.1],
  } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // marches
    head: [0.038, -0.019, 0.057], chest: [0.028, -0.019, 0.038], hips: [0.019, -0.028, 0.019], "left-hand": [0.06, 0, -0.228],
    "right-hand": [0, 0.068, 0.228], "left-foot": [0, 0, 0.266], "right-foot": [0, 0, -0.209], tip: [0, -0.03, 0.02],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: {
    head: [0.067, 0.009, 0.038], chest: [0.057, 0.009, 0.028], hips: [0.048, 0.009, 0.019],
    "left-hand": [0.06, 0, -0.076], "right-hand": [-0.024, 0.025, 0.057], "right-foot": [-0.03, 0.154, -0.057], tip: [0.02, 0, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: {
    head: [-0.076, -0.009, 0.038], chest: [-0.057, 0.009, 0.028], hips: [-0.057, 0.009, 0.028], "left-hand": [0.024, 0, -0.114],
    "right-hand": [-0.024, 0.025, 0.095], "left-foot": [0, 0.126, 0.19], "right-foot": [0, 0, -0.085], tip: [-0.12, 0, 0.02],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // flies, hat behind
    head: [0, 0.085, 0.152], chest: [0, 0.076, 0.085], hips: [0, 0.067, 0.019], "left-hand": [0.048, 0.255, 0.228],
    "right-hand": [-0.12, 0.034, -0.247], "left-foot": [-0.02, 0.08, -0.24], "right-foot": [0.03, 0.04, 0.24], tip: [0, 0.04, -0.06],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // squashed on one foot
    head: [-0.05, -0.14, 0.12], chest: [-0.05, -0.13, 0.08], hips: [-0.038, -0.076, 0], "left-hand": [0.048, 0.051, 0.114],
    "right-hand": [-0.072, 0.017, 0.038], "left-foot": [0.06, 0.06, 0.18], "right-foot": [0.03, 0, -0.076], tip: [-0.02, -0.08, 0.1],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // on tiptoe, hands like paws
    head: [-0.05, -0.03, 0.14], chest: [-0.05, -0.03, 0.1], hips: [-0.057, 0, 0.019], "left-hand": [-0.048, 0.17, 0.247],
    "right-hand": [0.048, 0.17, 0.247], "left-foot": [0.02, 0.14, 0.171], "right-foot": [0, 0, -0.019], tip: [-0.08, -0.06, 0.12],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: {
    head: [0.02, -0.24, 0.2], chest: [0.02, -0.21, 0.13], hips: [0.01, -0.15, 0], "left-hand": [0.024, 0.017, 0.228],
    "right-hand": [0.024, 0.034, 0.266], "left-foot": [0, 0, 0.228], "right-foot": [0, 0, -0.19], tip: [0.04, -0.24, 0.22],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { // hat to the ground
    head: [0, -0.28, 0.36], chest: [0, -0.22, 0.24], hips: [0, -0.12, -0.07], "left-hand": [0.24, 0.2, -0.12],
    "right-hand": [-0.16, 0.02, 0.26], "left-foot": [0, 0, 0.095], "right-foot": [0, 0, -0.095], tip: [0, -0.36, 0.46],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // one hand up, hip out
    head: [-0.095, 0, -0.038], chest: [-0.038, 0, 0], hips: [0.095, -0.048, 0], "left-hand": [0.12, -0.017, -0.095],
    "right-hand": [-0.18, 0.7, -0.04], "left-foot": [0.02, 0, 0], "right-foot": [-0.03, 0.021, 0.038], tip: [-0.02, -0.04, -0.06],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: {
    head: [-0.048, -0.133, 0.057], chest: [-0.028, -0.104, 0.028], hips: [0, -0.104, 0], "left-hand": [0.168, -0.017, -0.114],
    "right-hand": [0.024, -0.017, 0.114], "left-foot": [0.13, 0.042, 0.057], "right-foot": [-0.07, 0, 0], tip: [0.02, -0.16, 0.06],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: {
    head: [0, 0.133, -0.038], chest: [0, 0.095, 0], hips: [0, 0.076, 0], "left-hand": [0.12, 0.119, -0.038],
    "right-hand": [-0.12, 0.119, -0.038], "left-foot": [0.02, 0.084, 0.114], "right-foot": [0, 0.021, 0.019], tip: [0.04, 0.08, -0.06],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: {
    head: [0.076, -0.171, -0.048], chest: [0.057, -0.133, -0.019], hips: [0.057, -0.114, 0.019], "left-hand": [0.096, -0.034, -0.057],
    "right-hand": [-0.096, -0.034, -0.057], "left-foot": [-0.03, 0, 0], "right-foot": [-0.06, 0.14, 0.304], tip: [0.16, -0.24, -0.06],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: {
    head: [0, -0.15, 0.1], chest: [0, -0.13, 0.07], hips: [0, -0.104, 0],
    "left-hand": [0.096, -0.085, -0.19], "right-hand": [-0.096, -0.102, -0.171], tip: [0, -0.2, 0.16],
  } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: {
    head: [0.048, 0.114, -0.095], chest: [0.028, 0.085, -0.048], hips: [0.009, 0.067, 0.019], "left-hand": [0.024, 0.102, 0.133],
    "right-hand": [-0.216, 0.51, 0], "left-foot": [0, 0.007, 0], "right-foot": [0, 0.007, 0], tip: [0.1, 0.1, -0.16],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: { // the whole arm, the hat over one ear
    head: [0.133, 0.028, -0.152], chest: [0.076, 0.028, -0.076], hips: [0.028, 0.019, 0.038],
    "left-hand": [0.024, 0.221, 0.133], "right-hand": [-0.12, 0.92, -0.14], tip: [0.16, 0, -0.2],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: {
    head: [0.019, 0.038, -0.19], chest: [-0.009, 0.038, -0.095], hips: [-0.028, 0.019, 0.038],
    "left-hand": [0, 0.272, 0.095], "right-hand": [-0.5, 0.56, -0.24], tip: [0.02, 0, -0.28],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // winds up
    head: [0.067, -0.162, 0.209], chest: [0.048, -0.114, 0.114], hips: [0.057, -0.076, 0], "left-hand": [0.12, 0.051, -0.266],
    "right-hand": [0.048, 0.204, 0.266], "left-foot": [-0.03, 0, 0], "right-foot": [-0.06, 0.14, -0.285], tip: [0.06, -0.18, 0.26],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // thrown back
    head: [0.067, 0.028, -0.247], chest: [0.048, 0.019, -0.142], hips: [0.048, 0.019, 0.038], "left-hand": [-0.024, 0.306, 0.209],
    "right-hand": [-0.192, 0, -0.247], "left-foot": [-0.03, 0, 0.019], "right-foot": [-0.1, 0.26, 0.44], tip: [0.1, 0, -0.34],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: {
    head: [-0.095, -0.114, 0.076], chest: [-0.057, -0.085, 0.038], hips: [-0.028, -0.076, 0], "left-hand": [-0.072, -0.034, 0.133],
    "right-hand": [-0.12, -0.051, -0.152], "left-foot": [0.02, 0, 0], "right-foot": [-0.02, 0, 0], tip: [-0.16, -0.14, 0.1],
  } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.076, -0.038, 0], chest: [0.048, -0.038, 0], hips: [0.028, -0.048, 0],
    "left-hand": [0.336, 0.153, -0.152], "right-hand": [0, 0.17, 0.228], "right-foot": [0, 0.063, 0], tip: [0, -0.02, 0.06],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // arms wide, the hat flies round
    head: [0.019, -0.038, -0.133], chest: [0.019, -0.038, -0.067], hips: [0.019, -0.048, 0],
    "left-hand": [0.36, 0.255, -0.285], "right-hand": [-0.36, 0.34, -0.038], "right-foot": [0, 0.07, -0.057], tip: [0.12, -0.06, -0.2],
  } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: {
    head: [0.033, -0.009, -0.005], chest: [0.038, -0.009, 0], hips: [0.043, -0.009, 0],
    "left-hand": [0, -0.017, -0.038], "right-hand": [0, -0.017, -0.038], tip: [0.04, -0.02, 0],
  } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: {
    head: [0.038, 0.006, -0.038], chest: [0.038, 0.006, 0], hips: [0.038, 0.002, 0],
    "left-hand": [0.036, 0.017, -0.009], "right-hand": [-0.036, 0.017, -0.009], tip: [0.05, 0, -0.05],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
