// Small pictures of poses. They are drawn into a corner of the stage's own canvas and copied out before anyone sees it, which
// keeps its tone mapping and smooth edges; the caller draws the stage again in the same task.

import { Fog, Group, PerspectiveCamera, Scene, Vector3, type WebGLRenderer } from "three";
import { AZIMUTH, FIELD_OF_VIEW } from "./framing";
import { Lights } from "./lights";
import type { Shape } from "../stage/port";
import type { ModelFigure } from "./model-figure";

export class ThumbnailPainter {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 50);
  private readonly lights = new Lights();
  private readonly holder = new Group();
  private readonly canvas = document.createElement("canvas");
  private figure: ModelFigure | null = null;

  constructor(private readonly renderer: WebGLRenderer) {
    this.scene.fog = new Fog("#ffffff", 1e3, 1e4); // of the stage's kind and out of sight: shaders are the same
    this.scene.add(this.lights.group, this.holder);
  }

  setModel(figure: ModelFigure | null): void {
    this.holder.clear();
    this.figure = figure;
    if (figure) this.holder.add(...figure.copy());
  }

  setDark(dark: boolean): void {
    this.lights.setDark(dark);
  }

  /** A data URL of a square with a clear ground, `size` CSS pixels wide at the screen's own density; "" without a model. */
  draw(shape: Shape, size: number): string {
    const { figure } = this;
    if (!figure?.body.takes(shape)) return "";
    const stands = figure.shape;
    figure.setShape(shape);
    this.aim(figure.body.outline(shape));
    const picture = this.picture(size);
    figure.setShape(stands);
    return picture;
  }

  dispose(): void {
    this.lights.dispose();
  }

  private picture(size: number): string {
    const { renderer, canvas } = this;
    const ratio = renderer.getPixelRatio();
    const pixels = Math.round(size * ratio);
    const source = renderer.domElement;
    const drawn = Math.min(2 * pixels, source.width, source.height); // twice as fine, then averaged
    renderer.setClearColor(0, 0);
    renderer.setViewport(0, 0, drawn / ratio, drawn / ratio);
    renderer.setScissor(0, 0, drawn / ratio, drawn / ratio);
    renderer.setScissorTest(true);
    renderer.render(this.scene, this.camera);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, source.width / ratio, source.height / ratio);
    canvas.width = canvas.height = pixels;
    const context = canvas.getContext("2d");
    if (!context) return "";
    context.imageSmoothingQuality = "high";
    context.drawImage(source, 0, source.height - drawn, drawn, drawn, 0, 0, pixels, pixels);
    return canvas.toDataURL();
  }

  /** From the stage's side, so near that the whole pose just fits. */
  private aim(vertices: Float32Array): void {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = new Vector3(-Infinity, -Infinity, -Infinity);
    const point = new Vector3();
    for (let v = 0; v < vertices.length; v += 3) {
      point.fromArray(vertices, v);
      low.min(point);
      high.max(point);
    }
    const centre = low.clone().add(high).multiplyScalar(0.5);
    const half = 0.5 * Math.max(high.y - low.y, high.x - low.x, 0.1);
    const distance = (1.06 * half) / Math.tan((FIELD_OF_VIEW * Math.PI) / 360) + 0.5 * (high.z - low.z);
    this.camera.position.setFromSphericalCoords(distance, Math.PI / 2 - 0.1, AZIMUTH + 0.15).add(centre);
    this.camera.lookAt(centre);
  }
}
