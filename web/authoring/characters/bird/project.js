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
  { id: "crouch", motion: "jump", seconds: 0.74, moves: { // a ball
    head: [0, -0.342, 0.18], hips: [0, -0.18, 0], "left-wing": [-0.08, -0.26, -0.2], "right-wing": [0.08, -0.26, -0.2],
    "left-elbow": [0, -0.2, -0.06], "right-elbow": [0, -0.2, -0.06], "left-foot": [0.04, 0, 0], "right-foot": [-0.04, 0, 0], tail: [0, 0.06, 0.06],
  } },
  { id: "soars", motion: "jump", seconds: 1.27, moves: { // wings spread high
    head: [0, 0.12, -0.05], hips: [0, 0.081, 0.018], "left-wing": [-0.1, 0.6, 0], "right-wing": [0.1, 0.6, 0],
    "left-elbow": [-0.04, 0.3, 0], "right-elbow": [0.04, 0.3, 0], "left-foot": [0.02, 0.03, -0.048], "right-foot": [-0.02, 0.03, -0.048], tail: [0, -0.1, 0],
  } },
  { id: "strike-left", motion: "walk", seconds: 0, moves: { // a waddle, one foot far ahead
    head: [0.036, -0.018, 0.054], hips: [0.018, -0.027, 0.018], "left-wing": [0.03, 0, -0.264], "right-wing": [0, 0.08, 0.264],
    "left-elbow": [0.017, 0, -0.12], "right-elbow": [0, 0.04, 0.12], "left-foot": [0, 0, 0.266], "right-foot": [0, 0, -0.209], tail: [0.1, 0.02, 0],
  } },
  { id: "pass-right", motion: "walk", seconds: 0.3, moves: {
    head: [0.063, 0.009, 0.036], hips: [0.045, 0.009, 0.018], "left-wing": [0.03, 0, -0.088], "right-wing": [-0.012, 0.03, 0.066],
    "left-elbow": [0.017, 0, -0.04], "right-elbow": [-0.007, 0.015, 0.03], "right-foot": [-0.03, 0.165, -0.057], tail: [0.08, 0.02, 0],
  } },
  { id: "step-left", motion: "walk", seconds: 0.97, moves: { // a waddle
    head: [-0.072, -0.009, 0.036], hips: [-0.054, 0.009, 0.027], "left-wing": [0.012, 0, -0.132], "right-wing": [-0.012, 0.03, 0.11],
    "left-elbow": [0.007, 0, -0.06], "right-elbow": [-0.007, 0.015, 0.05], "left-foot": [0, 0.135, 0.19], "right-foot": [0, 0, -0.085], tail: [-0.06, 0.02, 0],
  } },
  { id: "run", motion: "run", seconds: 0.07, moves: { // flaps ahead
    head: [0, 0.081, 0.144], hips: [0, 0.063, 0.018], "left-wing": [0.024, 0.3, 0.264], "right-wing": [-0.06, 0.04, -0.286],
    "left-elbow": [0.014, 0.15, 0.12], "right-elbow": [-0.034, 0.02, -0.13], "left-foot": [-0.03, 0.128, -0.323], "right-foot": [0.03, 0.053, 0.304], tail: [0.05, 0.1, 0],
  } },
  { id: "run-stands", motion: "run", seconds: 0.25, moves: { // wings down, squashed
    head: [-0.054, -0.135, 0.126], hips: [-0.036, -0.072, 0], "left-wing": [0.024, 0.06, 0.132], "right-wing": [-0.036, 0.02, 0.044],
    "left-elbow": [0.014, 0.03, 0.06], "right-elbow": [-0.02, 0.01, 0.02], "left-foot": [0.06, 0.105, 0.152], "right-foot": [0.03, 0, -0.076], tail: [-0.04, -0.04, 0],
  } },
  { id: "sneak", motion: "sneak", seconds: 0.6, moves: { // wings like cloaks
    head: [-0.04, -0.02, 0.14], hips: [-0.05, 0.02, 0.02], "left-wing": [-0.024, 0.2, 0.286], "right-wing": [0.024, 0.2, 0.286],
    "left-elbow": [-0.014, 0.1, 0.13], "right-elbow": [0.014, 0.1, 0.13], "left-foot": [0.02, 0.15, 0.171], "right-foot": [0, 0, -0.019], tail: [-0.04, 0.1, 0],
  } },
  { id: "creep", motion: "sneak", seconds: 1.05, moves: {
    head: [0.02, -0.28, 0.22], hips: [0.01, -0.17, 0], "left-wing": [0.012, 0.02, 0.264], "right-wing": [0.012, 0.04, 0.308],
    "left-elbow": [0.007, 0.01, 0.12], "right-elbow": [0.007, 0.02, 0.14], "left-foot": [0, 0, 0.228], "right-foot": [0, 0, -0.19], tail: [0.04, 0.06, 0.02],
  } },
  { id: "bow", motion: "bow", seconds: 1.9, moves: { // one wing across, one spread, the tail up
    head: [0, -0.4, 0.3], hips: [0, -0.14, -0.06], "left-wing": [0.132, 0.24, -0.132], "right-wing": [0.3, -0.2, 0.34],
    "left-elbow": [0.075, 0.12, -0.06], "right-elbow": [0.1, -0.16, 0.14], "left-foot": [0, 0, 0.095], "right-foot": [0, 0, -0.095], tail: [0, 0.22, 0.02],
  } },
  { id: "point", motion: "disco", seconds: 0.75, moves: { // one wing to the sky
    head: [-0.08, -0.02, -0.04], hips: [0.09, -0.045, 0], "left-wing": [0.06, -0.02, -0.11], "right-wing": [-0.084, 0.66, -0.044],
    "left-elbow": [0.034, -0.01, -0.05], "right-elbow": [-0.048, 0.33, -0.02], "right-foot": [-0.05, 0.03, 0.02], tail: [-0.16, 0.02, 0.02],
  } },
  { id: "groove", motion: "disco", seconds: 0.2, moves: {
    head: [-0.05, -0.08, 0.05], hips: [0, -0.06, 0], "left-wing": [0.084, -0.02, -0.132], "right-wing": [0.012, -0.02, 0.132],
    "left-elbow": [0.048, -0.01, -0.06], "right-elbow": [0.007, -0.01, 0.06], "left-foot": [0.13, 0.045, 0.057], "right-foot": [-0.07, 0, 0], tail: [0.14, -0.02, 0.02],
  } },
  { id: "folk-air", motion: "folk", seconds: 0.07, moves: {
    head: [0, 0.126, -0.036], hips: [0, 0.072, 0], "left-wing": [0.06, 0.14, -0.044], "right-wing": [-0.06, 0.14, -0.044],
    "left-elbow": [0.034, 0.07, -0.02], "right-elbow": [-0.034, 0.07, -0.02], "left-foot": [0.02, 0.09, 0.114], "right-foot": [0, 0.022, 0.019],
  } },
  { id: "folk-kick", motion: "folk", seconds: 0.3, moves: { // shows its foot
    head: [0.072, -0.162, -0.045], hips: [0.054, -0.108, 0.018], "left-wing": [0.048, -0.04, -0.066], "right-wing": [-0.048, -0.04, -0.066],
    "left-elbow": [0.027, -0.02, -0.03], "right-elbow": [-0.027, -0.02, -0.03], "left-foot": [-0.03, 0, 0], "right-foot": [-0.06, 0.12, 0.24], tail: [-0.12, 0, 0.03],
  } },
  { id: "wave-dips", motion: "wave", seconds: 0.4, moves: {
    head: [0, -0.162, 0.108], hips: [0, -0.099, 0], "left-wing": [0.048, -0.1, -0.22],
    "right-wing": [-0.048, -0.12, -0.198], "left-elbow": [0.027, -0.05, -0.1], "right-elbow": [-0.027, -0.06, -0.09],
  } },
  { id: "wave-toes", motion: "wave", seconds: 0.95, moves: {
    head: [0.045, 0.108, -0.09], hips: [0.009, 0.063, 0.018], "left-wing": [0.012, 0.12, 0.154], "right-wing": [-0.108, 0.6, 0],
    "left-elbow": [0.007, 0.06, 0.07], "right-elbow": [-0.061, 0.3, 0], "left-foot": [0, 0.007, 0], "right-foot": [0, 0.007, 0], tail: [0.06, -0.08, 0.02],
  } },
  { id: "wave-up", motion: "wave", seconds: 1.3, moves: { // the whole wing
    head: [0.126, 0.027, -0.144], hips: [0.027, 0.018, 0.036], "left-wing": [0.012, 0.26, 0.154],
    "right-wing": [-0.024, 0.82, -0.154], "left-elbow": [0.007, 0.13, 0.07], "right-elbow": [-0.014, 0.41, -0.07], tail: [-0.16, -0.08, 0.03],
  } },
  { id: "wave-out", motion: "wave", seconds: 1.65, moves: {
    head: [0.018, 0.036, -0.18], hips: [-0.027, 0.018, 0.036], "left-wing": [0, 0.32, 0.11],
    "right-wing": [-0.228, 0.5, -0.264], "left-elbow": [0, 0.16, 0.05], "right-elbow": [-0.129, 0.25, -0.12], tail: [0.14, -0.08, 0.03],
  } },
  { id: "kick-back", motion: "kick", seconds: 0.74, moves: { // nose down, tail up
    head: [0.063, -0.153, 0.198], hips: [0.054, -0.072, 0], "left-wing": [0.06, 0.06, -0.308], "right-wing": [0.024, 0.24, 0.308],
    "left-elbow": [0.034, 0.03, -0.14], "right-elbow": [0.014, 0.12, 0.14], "left-foot": [-0.03, 0, 0], "right-foot": [-0.06, 0.15, -0.285], tail: [0.12, 0.16, 0.03],
  } },
  { id: "kick-high", motion: "kick", seconds: 1.16, moves: { // thrown back on its tail
    head: [0.06, 0.03, -0.3], hips: [0.045, 0.018, 0.036], "left-wing": [-0.012, 0.36, 0.242], "right-wing": [-0.096, 0, -0.286],
    "left-elbow": [-0.007, 0.18, 0.11], "right-elbow": [-0.054, 0, -0.13], "left-foot": [-0.03, 0, 0.019], "right-foot": [-0.1, 0.28, 0.4], tail: [-0.1, -0.16, 0.06],
  } },
  { id: "turn-winds", motion: "turn", seconds: 0.35, moves: {
    head: [-0.09, -0.108, 0.072], hips: [-0.027, -0.072, 0], "left-wing": [-0.036, -0.04, 0.154], "right-wing": [-0.06, -0.06, -0.176],
    "left-elbow": [-0.02, -0.02, 0.07], "right-elbow": [-0.034, -0.03, -0.08], "left-foot": [0.02, 0, 0], "right-foot": [-0.02, 0, 0], tail: [0.18, 0, 0.04],
  } },
  { id: "turn-flings", motion: "turn", seconds: 0.9, moves: {
    head: [0.072, -0.036, 0], hips: [0.027, -0.045, 0], "left-wing": [0.168, 0.18, -0.176], "right-wing": [0, 0.2, 0.264],
    "left-elbow": [0.095, 0.09, -0.08], "right-elbow": [0, 0.1, 0.12], "right-foot": [0, 0.068, 0], tail: [-0.2, 0.04, 0.04],
  } },
  { id: "turn-spins", motion: "turn", seconds: 1.4, moves: { // wings wide, like a coin
    head: [0.018, -0.036, -0.126], hips: [0.018, -0.045, 0], "left-wing": [0.18, 0.3, -0.33], "right-wing": [-0.18, 0.4, -0.044],
    "left-elbow": [0.102, 0.15, -0.15], "right-elbow": [-0.102, 0.2, -0.02], "right-foot": [0, 0.075, -0.057], tail: [0.12, 0.1, 0.03],
  } },
  { id: "idle-left", motion: "idle", seconds: 0.4, moves: {
    head: [0.03, -0.004, 0], hips: [0.04, -0.004, 0], "left-wing": [0, -0.02, -0.044],
    "right-wing": [0, -0.02, -0.044], "left-elbow": [0, -0.01, -0.02], "right-elbow": [0, -0.01, -0.02], tail: [-0.04, 0, 0],
  } },
  { id: "idle-breathes", motion: "idle", seconds: 1.25, moves: {
    head: [0.035, -0.004, -0.035], hips: [0.035, -0.004, 0], "left-wing": [0.018, 0.02, -0.011],
    "right-wing": [-0.018, 0.02, -0.011], "left-elbow": [0.01, 0.01, -0.005], "right-elbow": [-0.01, 0.01, -0.005], tail: [0.02, -0.02, 0],
  } },
];

export const SETTINGS = { volume: 1, smoothness: 0.1, groundContact: true, inPlace: false, symmetry: true };
