// The soft dark under whatever nearly touches the ground; it sells weight. A small height map of the lowest 30 cm, blurred.

import { DataTexture, LinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry, RGFormat } from "three";

const CELLS = 64;
const SIZE = 2.88;
const CELL = SIZE / CELLS;
const REACH = 0.3;
const OPACITY = 0.55;
const BLUR = 2;
/** Small feet keep their dark after the blur. */
const GAIN = 2;

export class ContactShadow {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly field = new Float32Array(CELLS * CELLS);
  private readonly scratch = new Float32Array(CELLS * CELLS);
  private readonly texture: DataTexture;
  private left = 0;
  private back = 0;

  constructor() {
    this.texture = new DataTexture(new Uint8Array(2 * CELLS * CELLS), CELLS, CELLS, RGFormat);
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    const material = new MeshBasicMaterial({
      alphaMap: this.texture, // reads green
      transparent: true,
      depthWrite: false,
      toneMapped: false,
      fog: false,
    });
    const plane = new PlaneGeometry(SIZE, SIZE).rotateX(Math.PI / 2); // v grows with z, like the rows of the field
    this.mesh = new Mesh(plane, material);
    this.mesh.renderOrder = -8;
    material.side = 2;
  }

  setDark(dark: boolean): void {
    this.mesh.material.color.set(dark ? "#000000" : "#143244");
  }

  /** Starts a new frame around a figure; the cells stay fixed to the world so that the edge does not shimmer. */
  begin(x: number, z: number): void {
    const cx = Math.round(x / CELL) * CELL;
    const cz = Math.round(z / CELL) * CELL;
    this.mesh.position.set(cx, 0, cz);
    this.left = cx - SIZE / 2;
    this.back = cz - SIZE / 2;
    this.field.fill(0);
  }

  /** Darkens the ground under a ball. */
  add(x: number, y: number, z: number, radius: number): void {
    if (y >= REACH) return;
    const weight = (1 - Math.max(y, 0) / REACH) ** 2;
    const i = (x - this.left) / CELL - 0.5;
    const j = (z - this.back) / CELL - 0.5;
    const r = Math.max(radius / CELL, 0.5);
    for (let b = Math.max(0, Math.ceil(j - r)); b <= Math.min(CELLS - 1, j + r); b++) {
      for (let a = Math.max(0, Math.ceil(i - r)); a <= Math.min(CELLS - 1, i + r); a++) {
        const cell = b * CELLS + a;
        if (this.field[cell]! < weight) this.field[cell] = weight;
      }
    }
  }

  end(): void {
    for (let pass = 0; pass < 2; pass++) {
      blurRows(this.field, this.scratch, 1, CELLS);
      blurRows(this.scratch, this.field, CELLS, 1);
    }
    const out = this.texture.image.data as Uint8Array;
    for (let i = 0; i < this.field.length; i++) out[2 * i + 1] = 255 * OPACITY * Math.min(1, GAIN * this.field[i]!);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.texture.dispose();
  }
}

/** Box blur along one axis; outside the field is light. */
function blurRows(from: Float32Array, to: Float32Array, step: number, stride: number): void {
  for (let row = 0; row < CELLS; row++) {
    const start = row * stride;
    let sum = 0;
    for (let i = 0; i < BLUR; i++) sum += from[start + i * step]!;
    for (let i = 0; i < CELLS; i++) {
      if (i + BLUR < CELLS) sum += from[start + (i + BLUR) * step]!;
      if (i - BLUR - 1 >= 0) sum -= from[start + (i - BLUR - 1) * step]!;
      to[start + i * step] = sum / (2 * BLUR + 1);
    }
  }
}
