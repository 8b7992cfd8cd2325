// The scene under the figures: renderer, lights, ground, fog, and the travel of the figures under a camera that stays at the
// origin. "World" is a figure's own world; "scene" is what is drawn: world plus the figure's lane minus the travel.

import { Fog, Group, NeutralToneMapping, PerspectiveCamera, Scene, Vector3, VSMShadowMap, WebGLRenderer } from "three";
import { ContactShadow } from "./contact-shadow";
import { AZIMUTH, lanes, type Content } from "./framing";
import { Ground } from "./ground";
import { Lights } from "./lights";
import type { Quality } from "./quality";
import type { Theme } from "./theme";
import { Travel, Traveller } from "./travel";
import { PERSON_HEIGHT } from "../util/constants";

const HEADROOM = 0.06;
/** A person with swinging arms. */
export const HUMAN_WIDTH = 1.3;
const FOLLOW_SECONDS = 0.15;

/** One figure's place on the stage. */
class Lane {
  readonly group = new Group();
  readonly shadow = new ContactShadow();
  /** World to scene. */
  readonly offset = new Vector3();
  readonly traveller = new Traveller();
  /** How high it reaches, metres. */
  top = 0;
  /** 0: not on the stage. */
  width = 0;
  x = 0;
  xGoal = 0;

  constructor() {
    this.group.add(this.shadow.mesh);
  }
}

export class Scenery {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly model = new Lane();
  readonly human = new Lane();
  /** What stands beside the model: how much wider that makes its lane, and how far its middle is away; how much it is apart and deeper. */
  readonly beside = { width: 0, middle: 0, apart: 0, depth: 0, top: 0 };
  /** Both figures on one spot. */
  overlay = false;
  content: Content = { width: 2.7, height: PERSON_HEIGHT, depth: 1 };
  private readonly fog = new Fog("#ffffff");
  private readonly lights = new Lights();
  readonly ground = new Ground();
  private readonly travel: Travel;
  /** 1: both on one spot. */
  private together = 0;
  private placed = false;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly still: boolean,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
    this.travel = new Travel([this.model.traveller, this.human.traveller], still);
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = VSMShadowMap;
    this.renderer.shadowMap.autoUpdate = false; // it changes with the figures, not with the camera
    this.scene.fog = this.fog;
    this.scene.add(this.lights.group, this.ground.group, this.model.group, this.human.group);
  }

  setTheme(theme: Theme): void {
    this.scene.background = theme.stage;
    this.fog.color.copy(theme.stage);
    this.lights.setDark(theme.dark);
    this.ground.setTheme(theme);
    for (const lane of [this.model, this.human]) lane.shadow.setDark(theme.dark);
  }

  setOverlay(overlay: boolean): void {
    this.overlay = overlay;
    this.arrange();
  }

  /** Width in metres of a figure's lane; 0 takes it off the stage. */
  setWidth(lane: Lane, width: number): void {
    if (lane.width === 0) lane.traveller.ground.set(0, 0);
    lane.traveller.here = width > 0;
    lane.width = width;
    lane.top = 0;
    this.placed = false;
    this.arrange();
  }

  /** The next places are those of the clip's beginning, reached by its end. */
  beginAgain(): void {
    this.travel.beginAgain();
  }

  /** After figures moved: what the camera must keep in the picture, and the shadows to draw anew. */
  arrange(): void {
    const { model, human, beside } = this;
    const wide = model.width + beside.width;
    const both = model.width > 0 && human.width > 0;
    const side = both && !this.overlay;
    const abreast = lanes(human.width, wide);
    human.xGoal = side ? abreast.human : -beside.middle;
    model.xGoal = (side ? abreast.model : 0) - beside.middle;
    const [from, to] = [human.traveller.ground, model.traveller.ground];
    const apart = side ? Math.abs(from.x - to.x) : 0;
    const behind = (side ? Math.abs(from.y - to.y) : 0) + beside.depth;
    const width = (side ? abreast.width : Math.max(human.width, wide, 1)) + apart + beside.apart;
    const height = Math.max(PERSON_HEIGHT, model.top, human.top, beside.top) + HEADROOM;
    this.content = { width, height, depth: 1 + behind };
    this.lights.fitShadow(width + 0.8, height + 0.4, 2.2 + behind);
    this.travel.aim();
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Lets the stage follow the figures for some seconds; true while it has not caught up. Frozen, no figure moves. */
  follow(seconds: number, frozen: boolean): boolean {
    const snap = this.still || !this.placed;
    const ease = (from: number, to: number): number =>
      snap || Math.abs(to - from) < 0.001 ? to : to + (from - to) * Math.exp(-seconds / FOLLOW_SECONDS);
    const { together } = this;
    this.together = ease(together, Number(this.overlay));
    let moving = this.together !== together;
    if (!frozen) moving = this.travel.follow(seconds, snap, this.together) || moving;
    for (const lane of [this.model, this.human]) {
      const {
        x,
        traveller: { aside },
      } = lane;
      lane.x = ease(x, lane.xGoal);
      moving ||= lane.x !== x;
      // Lanes lie across the first view, so that both stand equally far from the eye.
      lane.offset.set(lane.x * Math.cos(AZIMUTH) + aside.x, 0, -lane.x * Math.sin(AZIMUTH) + aside.y);
      lane.group.position.copy(lane.offset);
    }
    if (moving) this.renderer.shadowMap.needsUpdate = true;
    this.placed = true;
    return moving;
  }

  rendererName(): string {
    const gl = this.renderer.getContext();
    const unmasked = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
    return String(gl.getParameter(unmasked ?? gl.RENDERER));
  }

  setQuality(quality: Quality): void {
    this.lights.setShadow(quality);
    this.ground.setShadow(quality.shadowMap > 0);
    this.renderer.shadowMap.needsUpdate = true;
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
  }

  /** Makes the shaders of what is to be seen, while the page goes on. */
  async compile(group: Group): Promise<void> {
    await this.renderer.compileAsync(group, new PerspectiveCamera(), this.scene);
  }

  /** `distance`: of the camera from its target; the fog begins behind it. */
  render(camera: PerspectiveCamera, distance: number): void {
    this.fog.near = distance + 0.3;
    this.fog.far = distance + 3.8;
    this.ground.update(this.travel.gone.x, this.travel.gone.y, distance, this.renderer.getPixelRatio());
    this.renderer.render(this.scene, camera);
  }

  dispose(): void {
    for (const lane of [this.model, this.human]) lane.shadow.dispose();
    this.lights.dispose();
    this.ground.dispose();
    this.renderer.dispose();
  }
}
