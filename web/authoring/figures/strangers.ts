// Draws and measures dances that the command line baked, and models as their files hold them.

import {
  AmbientLight,
  Box3,
  CircleGeometry,
  DirectionalLight,
  type Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  OrthographicCamera,
  PMREMGenerator,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { type Bounds, boundsOf, Samples, stretchOf, swingOf, topologyOf, trunkOf, turnSince, volumeOf } from "./measures";
import { PosedDance } from "./posed";
import { loadRaw } from "./raw-model";

interface GuessedPoint {
  name: string;
  /** Where it is in the first frame, world. */
  place: number[];
}

interface DanceInput {
  dances: { url: string; points: GuessedPoint[] }[];
  frames: number;
  cell: number;
}

interface Measures {
  triangles: number;
  shells: number;
  /** Peak to peak, degrees, of each dance. */
  swing: number[];
  /** Smallest and largest of all dances, rest is 1; null when the surface is open or holds nothing. */
  volume: [number, number] | null;
  stretch: number;
}

interface SheetRow {
  title: string;
  strip: string;
}

declare global {
  interface Window {
    /** Two rows, from the front and the side: rest with its points, then each dance's moments. */
    drawStranger: (input: DanceInput) => Promise<{ strip: string; measures: Measures }>;
    /** As the file holds it: seen along -z and -x with y up, and along -y with -z up. */
    drawRaw: (input: { url: string; cell: number }) => Promise<string>;
    /** Rows under each other, as many on a sheet as eyes take in; RGB bytes in base64. */
    drawSheets: (input: SheetRow[]) => Promise<{ width: number; height: number; rgb: string }[]>;
  }
}

const TITLE = 17;
/** Height of a sheet in pixels, about. */
const SHEET = 1350;
const FRONT = { azimuth: 0.6, elevation: 0.14 };
const SIDE = { azimuth: Math.PI / 2, elevation: 0.06 };

/** Camera directions towards the eye. */
const eye = ({ azimuth, elevation }: typeof FRONT): Vector3 =>
  new Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));

const COLOURS: readonly [RegExp, string][] = [
  [/head/i, "#d81b1b"],
  [/left.*(hand|wing)/i, "#1c54d8"],
  [/right.*(hand|wing)/i, "#12a5c9"],
  [/left.*foot/i, "#12803a"],
  [/right.*foot/i, "#6fbe12"],
  [/hip|chest|trunk|body/i, "#b812b0"],
];

class Studio {
  readonly renderer = new WebGLRenderer({ alpha: true }); // drawn twice as large, then averaged
  readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly ground = new Mesh(
    new CircleGeometry(1, 48).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ color: "#dfe6ea", depthWrite: false }),
  );

  constructor() {
    const pmrem = new PMREMGenerator(this.renderer);
    this.scene.environment = pmrem.fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.45;
    const sun = new DirectionalLight("#ffffff", 1.15);
    sun.position.set(2, 4, 3);
    this.scene.add(new AmbientLight("#ffffff", 0.3), sun, this.ground);
    this.ground.renderOrder = -1;
  }

  /** Draws what is in the scene into a cell; `up` is the camera's. */
  shoot(context: CanvasRenderingContext2D, cell: Cell, view: View, floor: number | null): void {
    const { x, y, width, height } = cell;
    this.renderer.setSize(2 * width, 2 * height, false);
    const { camera, ground } = this;
    const { half, centre, towards, up } = view;
    const rise = (half * height) / width;
    Object.assign(camera, { left: -half, right: half, top: rise, bottom: -rise, near: 0.01 * half, far: 60 * half });
    camera.up.copy(up);
    camera.position.copy(centre).addScaledVector(towards, 30 * half);
    camera.lookAt(centre);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    ground.visible = floor !== null;
    ground.position.set(centre.x, floor ?? 0, centre.z);
    ground.scale.setScalar(0.45 * half);
    this.renderer.render(this.scene, camera);
    context.drawImage(this.renderer.domElement, x, y, width, height);
  }

  /** Pixels of a place in the cell that was shot last. */
  project(place: Vector3, cell: Cell): [number, number] {
    const { x, y } = place.clone().project(this.camera);
    return [cell.x + ((x + 1) / 2) * cell.width, cell.y + ((1 - y) / 2) * cell.height];
  }
}

interface Cell {
  x: number;
  y: number;
  width: number;
  height: number;
}

interface View {
  /** Of the cell's width. */
  half: number;
  centre: Vector3;
  towards: Vector3;
  up: Vector3;
}

let studio: Studio | null = null;

function clear(width: number, height: number): { canvas: HTMLCanvasElement; context: CanvasRenderingContext2D } {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#f2f5f7";
  context.fillRect(0, 0, width, height);
  context.imageSmoothingQuality = "high";
  return { canvas, context };
}

interface Moment {
  dance: PosedDance;
  time: number | null;
}

window.drawStranger = async ({ dances: inputs, frames, cell }) => {
  studio ??= new Studio();
  const dances = await Promise.all(inputs.map(({ url }) => PosedDance.load(url)));
  const [first] = dances;
  const still = await PosedDance.load(inputs[0].url);
  const rest = still.at(null);
  const moments: Moment[] = [{ dance: still, time: null }];
  const spots = inputs[0].points.length > 0 ? spotsAtRest(rest, first.at(first.times[0] ?? 0), inputs[0].points) : [];
  const measures = measured(dances, rest);
  for (const dance of dances) {
    const { times } = dance;
    for (let k = 0; k < frames; k++) moments.push({ dance, time: times[Math.floor(((k + 0.5) * times.length) / frames)] ?? 0 });
  }
  const { low, high } = bodyOf(rest);
  const { half, rise } = reachOf(moments, rest);
  const height = Math.ceil((cell * rise) / half);
  const { canvas, context } = clear(moments.length * cell, 2 * height);
  const middle = (low[1] + high[1]) / 2;
  moments.forEach(({ dance, time }, k) => {
    const places = dance.at(time);
    const [x, , z] = centreOf(places);
    studio!.scene.add(dance.group);
    dance.show(places, new Vector3(-x, 0, -z));
    [FRONT, SIDE].forEach((angles, row) => {
      const view = { half, centre: new Vector3(0, middle, 0), towards: eye(angles), up: new Vector3(0, 1, 0) };
      const at = { x: k * cell, y: row * height, width: cell, height };
      studio!.shoot(context, at, view, low[1]);
      if (time === null) markPoints(context, at, spots, new Vector3(-x, 0, -z));
    });
    studio!.scene.remove(dance.group);
  });
  rule(context, [1, 1 + frames], cell, canvas.height);
  for (const dance of [still, ...dances]) dance.dispose();
  return { strip: canvas.toDataURL("image/png"), measures };
};

function measured(dances: readonly PosedDance[], rest: Float32Array): Measures {
  const [{ faces }] = dances;
  const { shells, closed, edges } = topologyOf(rest, faces);
  const samples = new Samples(rest, faces, 3000);
  const before = samples.at(rest);
  const trunk = trunkOf(before);
  const { low, high } = boundsOf(rest);
  const whole = volumeOf(rest, faces);
  const holds = closed && Math.abs(whole) > 1e-3 * [0, 1, 2].reduce((box, k) => box * (high[k] - low[k]), 1);
  const volumes: number[] = [];
  let stretch = 0;
  const swing = dances.map((dance) =>
    swingOf(
      dance.times.map((time) => {
        const places = dance.at(time);
        if (holds) volumes.push(volumeOf(places, dance.faces) / whole);
        stretch = Math.max(stretch, stretchOf(rest, places, edges, high[1] - low[1]));
        return turnSince(before, samples.at(places), trunk);
      }),
    ),
  );
  const volume: [number, number] | null = holds ? [Math.min(...volumes), Math.max(...volumes)] : null;
  return { triangles: faces.length / 3, shells, swing, volume, stretch };
}

/** The mean place of the body. */
function centreOf(places: Float32Array): [number, number, number] {
  const { low, high } = bodyOf(places);
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (let i = 0; i < places.length; i += 3) {
    if (low.some((x, k) => places[i + k] < x || places[i + k] > high[k])) continue;
    for (let k = 0; k < 3; k++) sum[k] += places[i + k];
    count++;
  }
  return sum.map((x) => x / count) as typeof sum;
}

/** Half the width and height that every moment fits; what flies far apart is cut off, or nothing else could be seen. */
function reachOf(moments: readonly Moment[], rest: Float32Array): { half: number; rise: number } {
  const own = bodyOf(rest);
  const middle = (own.low[1] + own.high[1]) / 2;
  const reach = (places: Float32Array): [number, number] => {
    const [x, , z] = centreOf(places);
    const { low, high } = bodyOf(places);
    return [Math.max(x - low[0], high[0] - x, z - low[2], high[2] - z), Math.max(middle - low[1], high[1] - middle)];
  };
  const still = reach(rest);
  const most = 1.35 * Math.max(...still);
  const all = moments.flatMap(({ dance, time }) => (time === null ? [] : [reach(dance.at(time))]));
  const [wide, rise] = [0, 1].map((k) => 1.08 * Math.min(Math.max(still[k], ...all.map((one) => one[k])), most));
  const half = Math.max(wide, rise);
  return { half, rise: Math.max(rise, 0.35 * half) };
}

/** Bounds without the crumbs, wide grounds and the like of at most 3 % of the vertices that would leave the body a dot. */
function bodyOf(places: Float32Array): Bounds {
  const all = boundsOf(places);
  const axes = [0, 1, 2].map((k) => places.filter((_, i) => i % 3 === k).sort());
  const at = (share: number): Bounds["low"] => axes.map((values) => values[Math.round(share * (values.length - 1))]) as Bounds["low"];
  const inner = { low: at(0.03), high: at(0.97) };
  const size = ({ low, high }: Bounds): number => Math.max(...high.map((x, k) => x - low[k]));
  const margin = 0.15 * size(inner);
  if (size(all) < 3 * size(inner)) return all;
  return { low: inner.low.map((x) => x - margin) as Bounds["low"], high: inner.high.map((x) => x + margin) as Bounds["high"] };
}

/** Where each point is at rest: the vertex that is where the point is in the first frame. */
function spotsAtRest(rest: Float32Array, first: Float32Array, points: readonly GuessedPoint[]): { name: string; place: Vector3 }[] {
  return points.map(({ name, place }) => {
    let [best, found] = [Infinity, 0];
    for (let i = 0; i < first.length; i += 3) {
      const far = (first[i] - place[0]) ** 2 + (first[i + 1] - place[1]) ** 2 + (first[i + 2] - place[2]) ** 2;
      if (far < best) [best, found] = [far, i];
    }
    return { name, place: new Vector3().fromArray(rest, found) };
  });
}

function markPoints(
  context: CanvasRenderingContext2D,
  cell: Cell,
  spots: readonly { name: string; place: Vector3 }[],
  offset: Vector3,
): void {
  for (const { name, place } of spots) {
    const [x, y] = studio!.project(place.clone().add(offset), cell);
    context.beginPath();
    context.arc(x, y, 3.2, 0, 7);
    context.fillStyle = COLOURS.find(([pattern]) => pattern.test(name))?.[1] ?? "#f08a00";
    context.fill();
    context.strokeStyle = "#ffffff";
    context.lineWidth = 1;
    context.stroke();
  }
}

function rule(context: CanvasRenderingContext2D, columns: readonly number[], cell: number, height: number): void {
  context.fillStyle = "#b9c6ce";
  for (const column of columns) context.fillRect(column * cell, 0, 1, height);
}

window.drawRaw = async ({ url, cell }) => {
  studio ??= new Studio();
  const model: Object3D = await loadRaw(url);
  const { canvas, context } = clear(3 * cell, cell);
  const box = new Box3().setFromObject(model);
  const centre = box.getCenter(new Vector3());
  const half = 0.55 * Math.max(...box.getSize(new Vector3()).toArray());
  studio.scene.add(model as Group);
  const views: [Vector3, Vector3][] = [
    [new Vector3(0.12, 0.1, 1), new Vector3(0, 1, 0)],
    [new Vector3(1, 0.1, 0.12), new Vector3(0, 1, 0)],
    [new Vector3(0.12, 1, 0.1), new Vector3(0, 0, -1)],
  ];
  views.forEach(([towards, up], k) => {
    const at = { x: k * cell, y: 0, width: cell, height: cell };
    studio!.shoot(context, at, { half, centre, towards: towards.normalize(), up }, null);
  });
  studio.scene.remove(model as Group);
  return canvas.toDataURL("image/png");
};

window.drawSheets = async (rows) => {
  const strips = await Promise.all(rows.map(async ({ strip }) => createImageBitmap(await (await fetch(strip)).blob())));
  const sheets: number[][] = [];
  let left = 0;
  strips.forEach(({ height }, n) => {
    const needed = height + TITLE;
    if (needed > left) {
      sheets.push([]);
      left = SHEET;
    }
    sheets[sheets.length - 1].push(n);
    left -= needed;
  });
  return sheets.map((sheet) =>
    sheetOf(
      sheet.map((n) => rows[n].title),
      sheet.map((n) => strips[n]),
    ),
  );
};

function sheetOf(titles: readonly string[], strips: readonly ImageBitmap[]): { width: number; height: number; rgb: string } {
  const width = Math.max(...strips.map((strip) => strip.width));
  const height = strips.reduce((sum, strip) => sum + strip.height + TITLE, 0);
  const { canvas, context } = clear(width, height);
  context.font = "12px system-ui, sans-serif";
  context.textBaseline = "middle";
  let top = 0;
  titles.forEach((title, n) => {
    context.fillStyle = "#d9e1e6";
    context.fillRect(0, top, width, TITLE);
    context.fillStyle = "#17212b";
    context.fillText(title, 4, top + TITLE / 2 + 1);
    context.drawImage(strips[n], 0, top + TITLE);
    top += TITLE + strips[n].height;
  });
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  const rgb = new Uint8Array((data.length / 4) * 3);
  // Six bits of each colour: a third fewer bytes, and nothing to see.
  for (let i = 0; i < data.length / 4; i++) for (let k = 0; k < 3; k++) rgb[3 * i + k] = data[4 * i + k] & 0xfc;
  const chunks: string[] = [];
  for (let i = 0; i < rgb.length; i += 0x6000) chunks.push(btoa(String.fromCharCode(...rgb.subarray(i, i + 0x6000))));
  return { width, height, rgb: chunks.join("") };
}
