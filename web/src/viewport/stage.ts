// The scene under the figures: renderer, lights, ground, fog, and the travel of the figures under a camera that stays at the
// origin. "World" is a figure's own world; "scene" is what is drawn: world plus the figure's lane minus the travel.

import { Fog, Group, NeutralToneMapping, PerspectiveCamera, Scene, Vector2, Vector3, VSMShadowMap, WebGLRenderer } from "three";
import { ContactShadow } from "./contact-shadow";
import { AZIMUTH, lanes, type Content } from "./framing";
import { Ground } from "./ground";
import { Lights } from "./lights";
import type { Quality } from "./quality";
import type { Theme } from "./theme";

const FIGURE_HEIGHT = 1.7;
const HEADROOM = 0.06;
/** A person with swinging arms. */
export const HUMAN_WIDTH = 1.3;
const FOLLOW_SECONDS = 0.15;
/** Farther than a dancer moves between two frames: another moment was chosen. */
const JUMP = 1.2;
/** Within this time figures that ended a loop apart come together again. */
const REUNION_SECONDS = 0.25;

/** One figure's place on the stage. */
class Lane {
  readonly group = new Group();
  readonly shadow = new ContactShadow();
  /** World to scene. */
  readonly offset = new Vector3();
  /** Where the figure is in its world, x and z. */
  readonly ground = new Vector2();
  /** Where it was when the clip began again. */
  readonly before = new Vector2();
  /** How far from its place it is still drawn since then, x and z. */
  readonly slip = new Vector2();
  /** How far it is from the spot that both share, x and z; none of it is drawn where both stand on one spot. */
  readonly lead = new Vector2();
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

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly model = new Lane();
  readonly human = new Lane();
  /** Both figures on one spot. */
  overlay = false;
  content: Content = { width: 2.7, height: FIGURE_HEIGHT, depth: 1 };
  private readonly fog = new Fog("#ffffff");
  private readonly lights = new Lights();
  private readonly ground = new Ground();
  private readonly travel = new Vector2();
  private readonly goal = new Vector2();
  /** What was travelled in earlier turns of the loop. */
  private readonly travelled = new Vector2();
  private again = false;
  /** 1: both on one spot. */
  private together = 0;
  private placed = false;

  constructor(canvas: HTMLCanvasElement, private readonly still: boolean) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
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
    if (lane.width === 0) lane.ground.set(0, 0);
    lane.width = width;
    lane.top = 0;
    lane.slip.set(0, 0);
    this.placed = false;
    this.arrange();
  }

  /** The next places begin the clip anew. */
  beginAgain(): void {
    this.again = true;
    for (const lane of [this.model, this.human]) lane.before.copy(lane.ground);
  }

  /** After figures moved: what the camera must keep in the picture, and the shadows to draw anew. */
  arrange(): void {
    const { model, human } = this;
    const both = model.width > 0 && human.width > 0;
    const side = both && !this.overlay;
    const places = lanes(human.width, model.width);
    human.xGoal = side ? places.human : 0;
    model.xGoal = side ? places.model : 0;
    const apart = side ? Math.abs(human.ground.x - model.ground.x) : 0;
    const behind = side ? Math.abs(human.ground.y - model.ground.y) : 0;
    const width = (side ? places.width : Math.max(human.width, model.width, 1)) + apart;
    const height = Math.max(FIGURE_HEIGHT, model.top, human.top) + HEADROOM;
    this.content = { width, height, depth: 1 + behind };
    this.lights.fitShadow(width + 0.8, height + 0.4, 2.2 + behind);
    const goal = this.goal.clone();
    if (both) this.goal.addVectors(human.ground, model.ground).multiplyScalar(0.5);
    else this.goal.copy(model.width > 0 ? model.ground : human.ground);
    if (this.again) this.goOn(this.goal.clone().sub(goal));
    this.again = false;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Nothing that is seen moves by the stage's jump back to the clip's beginning. */
  private goOn(jump: Vector2): void {
    if (this.still) return;
    this.travel.add(jump);
    this.travelled.sub(jump);
    for (const lane of [this.model, this.human]) {
      if (lane.width > 0) lane.slip.add(lane.before).sub(lane.ground).add(jump);
    }
  }

  /** Lets the stage follow the figures for some seconds; true while it has not caught up. */
  follow(seconds: number, frozen: boolean): boolean {
    const ease = this.still || !this.placed ? 1 : 1 - Math.exp(-seconds / FOLLOW_SECONDS);
    const lag = this.travel.distanceTo(this.goal);
    if (!frozen) this.travel.lerp(this.goal, lag > JUMP || lag < 0.001 ? 1 : ease);
    let moving = !frozen && lag >= 0.001;
    const join = Number(this.overlay) - this.together;
    this.together += (Math.abs(join) < 0.001 ? 1 : ease) * join;
    moving ||= Math.abs(join) >= 0.001;
    for (const lane of [this.model, this.human]) {
      const gap = Math.abs(lane.xGoal - lane.x);
      lane.x += (gap < 0.001 ? 1 : ease) * (lane.xGoal - lane.x);
      const slips = !frozen && lane.slip.length() >= 0.001;
      if (!frozen) {
        lane.slip.multiplyScalar(slips ? Math.exp(-seconds / REUNION_SECONDS) : 0);
        lane.lead.subVectors(lane.ground, this.goal);
      }
      moving ||= gap >= 0.001 || slips;
      const aside = lane.slip.clone().multiplyScalar(1 - this.together).addScaledVector(lane.lead, -this.together).sub(this.travel);
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

  /** `distance`: of the camera from its target; the fog begins behind it. */
  render(camera: PerspectiveCamera, distance: number): void {
    this.fog.near = distance + 0.3;
    this.fog.far = distance + 3.8;
    this.ground.update(this.travel.x + this.travelled.x, this.travel.y + this.travelled.y, distance, this.renderer.getPixelRatio());
    this.renderer.render(this.scene, camera);
  }

  dispose(): void {
    for (const lane of [this.model, this.human]) lane.shadow.dispose();
    this.lights.dispose();
    this.ground.dispose();
    this.renderer.dispose();
  }
}
