// A flat blue pencil shape behind the figures, drawn only where none of them is, with a dashed edge.

import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
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
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        vec2 out_ = (projectionMatrix * modelViewMatrix * vec4(normal, 0.0)).xy;
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

  private readonly geometry = new BufferGeometry();

  /** `faces`: F x 3 over solver vertices; their smooth normals lead the edge outwards without a gap. */
  constructor(faces: Uint32Array) {
    this.geometry.setIndex(new BufferAttribute(faces, 1));
    const edge = new Mesh(this.geometry, this.edge);
    const fill = new Mesh(this.geometry, this.fill);
    const materials: Material[] = [this.edge, this.fill];
    for (const material of materials) {
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

  /** V x 3, which stay the caller's. */
  write(vertices: Float32Array): void {
    this.geometry.setAttribute("position", new BufferAttribute(vertices, 3));
    this.geometry.computeVertexNormals();
  }

  setTheme(theme: Theme): void {
    this.fill.color.copy(theme.pencilSoft);
    this.edge.uniforms["color"]!.value.copy(theme.pencil);
  }

  setViewSize(width: number, height: number): void {
    this.edge.uniforms["view"]!.value.set(width, height);
  }

  dispose(): void {
    this.geometry.dispose();
    this.fill.dispose();
    this.edge.dispose();
  }
}
