// A flat blue pencil shape behind the figures, drawn only where none of them is, with a dashed edge.

import {
  BackSide,
  Color,
  DoubleSide,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  ShaderMaterial,
  Vector2,
} from "three";
import type { Shape } from "../stage/port";
import type { GhostBody } from "./body";
import type { Theme } from "./theme";

export class Ghost {
  readonly group = new Group();
  private readonly fill = new MeshBasicMaterial({ transparent: true, opacity: 0.85 });
  private readonly edge = new ShaderMaterial({
    transparent: true,
    side: BackSide,
    uniforms: { color: { value: new Color() }, view: { value: new Vector2(1, 1) } },
    vertexShader: `
      uniform vec2 view;
      void main() {
        #include <beginnormal_vertex>
        #include <begin_vertex>
        gl_Position = projectionMatrix * modelViewMatrix * vec4(transformed, 1.0);
        vec2 out_ = (projectionMatrix * modelViewMatrix * vec4(normalize(objectNormal), 0.0)).xy;
        gl_Position.xy += normalize(out_ * view + 1e-6) * 3.0 / view * gl_Position.w;
      }`,
    fragmentShader: `
      uniform vec3 color;
      void main() {
        if (fract(dot(gl_FragCoord.xy, vec2(0.052, 0.099))) > 0.56) discard;
        gl_FragColor = vec4(color, 1.0);
        #include <colorspace_fragment>
      }`,
  });

  /** The body's smooth normals lead the edge outwards without a gap. */
  constructor(private readonly body: GhostBody) {
    const edge = new Mesh(body.geometry, this.edge);
    const fill = new Mesh(body.geometry, this.fill);
    const materials: Material[] = [this.edge, this.fill];
    for (const material of materials) {
      body.dress(material);
      material.depthTest = material.depthWrite = material.toneMapped = false;
      material.stencilWrite = true;
      material.stencilRef = 1;
      material.stencilFunc = NotEqualStencilFunc;
    }
    // The fill marks its own pixels first (once each, it is see-through), then the edge takes what is left around it.
    this.fill.stencilZPass = ReplaceStencilOp;
    this.fill.side = DoubleSide;
    fill.renderOrder = -5;
    edge.renderOrder = -4;
    fill.frustumCulled = edge.frustumCulled = false;
    this.group.add(fill, edge);
  }

  /** The shape stays the caller's. */
  write(shape: Shape): void {
    this.body.write(shape);
  }

  setTheme(theme: Theme): void {
    this.fill.color.copy(theme.pencilSoft);
    this.edge.uniforms["color"]!.value.copy(theme.pencil);
  }

  setViewSize(width: number, height: number): void {
    this.edge.uniforms["view"]!.value.set(width, height);
  }

  dispose(): void {
    this.body.dispose();
    this.fill.dispose();
    this.edge.dispose();
  }
}
