// Draws surfaces side by side, each in a viewport of the page.

import { BufferAttribute, BufferGeometry } from "three";
import type { Picture } from "../../src/gltf/document";
import { buildDocument } from "../../src/io/gltf/build";
import { readModel } from "../../src/io/read-model";
import { Viewport } from "../../src/viewport/viewport";
import type { PointMark, DrawnModel } from "../../src/stage/port";

interface Surfaces {
  faces: number[];
  controls: number[];
  surfaces: { name: string; volume: number; positions: number[] }[];
}

declare global {
  interface Window {
    /** Draws `data` with the skin of a model or, without one, as an egg; a label goes under each. */
    draw: (data: Surfaces, labels: string[], skin: string | null) => Promise<void>;
  }
}

window.draw = async (data, labels, skin) => {
  const one = skin ? await skinned(skin) : await painted(data);
  const figures = data.surfaces.map(({ positions }) => standing(positions));
  const widest = figures.reduce((a, b) => (extent(b, 0) > extent(a, 0) ? b : a));
  const tallest = figures.reduce((a, b) => (extent(b, 1) > extent(a, 1) ? b : a));
  const model: DrawnModel = {
    ...one,
    positions: Float32Array.from({ length: 3 * one.toVertex.length }, (_, i) => widest[3 * one.toVertex[Math.floor(i / 3)] + (i % 3)]),
    faces: Uint32Array.from(data.faces),
    rest: widest,
    solid: null,
  };
  const dots = data.controls.map((vertex, c): PointMark => ({ id: String(c), number: c + 1, name: "", vertex, joint: -1 }));
  for (const [k, positions] of figures.entries()) {
    const panel = document.createElement("figure");
    const stage = document.createElement("div");
    const caption = document.createElement("figcaption");
    caption.textContent = labels[k];
    panel.append(stage, caption);
    document.body.append(panel);
    const viewport = new Viewport(stage);
    await viewport.setModel(model);
    // The camera steps back for the widest and the tallest and stays there: one scale for all panels.
    for (const shape of [widest, tallest, positions]) {
      viewport.setShape(shape);
      await frames(3);
    }
    viewport.setPoints(dots, null);
    await frames(3);
  }
};

async function frames(count: number): Promise<void> {
  for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
}

function extent(positions: Float32Array, axis: number): number {
  const along = positions.filter((_, i) => i % 3 === axis);
  return Math.max(...along) - Math.min(...along);
}

/** On the ground by the lowest vertex. */
function standing(positions: readonly number[]): Float32Array {
  const lowest = Math.min(...positions.filter((_, i) => i % 3 === 1));
  return Float32Array.from(positions, (x, i) => (i % 3 === 1 ? x - lowest : x));
}

type Skin = Omit<DrawnModel, "positions" | "faces" | "rest" | "solid">;

async function skinned(url: string): Promise<Skin> {
  const bytes = new Uint8Array(await (await fetch(url)).arrayBuffer());
  const { document, drawn } = await readModel([{ name: url, bytes }]);
  return { ...drawn, document };
}

/** An egg in trousers that looks at us, painted from the front. */
async function painted({ faces, surfaces: [rest] }: Surfaces): Promise<Skin> {
  const count = rest.positions.length / 3;
  let top = 0;
  for (let v = 0; v < count; v++) top = Math.max(top, rest.positions[3 * v + 1]);
  const size = 512;
  const canvas = new OffscreenCanvas(size, size);
  const brush = canvas.getContext("2d") as OffscreenCanvasRenderingContext2D;
  const band = (colour: string, from: number, to: number): void => {
    brush.fillStyle = colour;
    brush.fillRect(0, from * size, size, (to - from) * size);
  };
  band("#ecdcbf", 0, 1);
  band("#2f5a86", 0.62, 1);
  band("#d9822b", 0.56, 0.62);
  brush.fillStyle = "#1c1a1e";
  for (const side of [-1, 1]) {
    brush.beginPath();
    brush.ellipse((0.5 + 0.1 * side) * size, 0.33 * size, 0.032 * size, 0.05 * size, 0, 0, 7);
    brush.fill();
  }
  brush.lineWidth = 0.014 * size;
  brush.strokeStyle = "#1c1a1e";
  brush.lineCap = "round";
  brush.beginPath();
  brush.arc(0.5 * size, 0.4 * size, 0.06 * size, 0.5, Math.PI - 0.5);
  brush.stroke();
  const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
  return wrapped(rest.positions, faces, top, { bytes, mime: "image/png", drawn: true });
}

/** A surface with a picture from the front; its vertices in the order in which faces name them, as a document keeps them. */
function wrapped(places: readonly number[], faces: readonly number[], top: number, picture: Picture): Skin {
  const order = [...new Set(faces)];
  const rank = new Map(order.map((vertex, k) => [vertex, k]));
  const index = Uint32Array.from(faces, (vertex) => rank.get(vertex)!);
  const positions = Float32Array.from(order.flatMap((v) => places.slice(3 * v, 3 * v + 3)));
  const uvs = order.flatMap((v) => [0.5 + places[3 * v] / top, 1 - places[3 * v + 1] / top]);
  const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3)).setIndex([...index]);
  geometry.computeVertexNormals();
  const normals = Float32Array.from(geometry.attributes.normal.array);
  const look = { pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.8 } };
  return {
    document: buildDocument("egg", {
      parts: [{ positions, index, normals, uvs: [uvs], material: 0 }],
      materials: [look],
      pictures: [{ name: "front", picture }],
    }),
    instances: [
      {
        ...{ node: 0, mesh: 0, primitive: 0, first: 0, from: 0 },
        count: order.length,
        to: index.length,
        vertices: null,
        flat: false,
        open: true,
      },
    ],
    normals,
    index,
    toVertex: Uint32Array.from(order),
  };
}
