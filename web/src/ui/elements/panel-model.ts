import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { type Axis, ModelSettings } from "../../app/model-settings";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { count } from "../../util/words";
import "./duet";
import { gallery, galleryStyle } from "./gallery";
import { shelf, shelfStyle } from "./shelf";
import "./switch";

const AXES: readonly Axis[] = ["+y", "+z", "+x", "-y", "-z", "-x"];

const SOLID = "A solid inside moves it, whatever it is made of";
const SURFACE = "Its own surface is solved, as suits one closed piece";

@customElement("rigless-panel-model")
export class ModelPanel extends SessionElement {
  protected readonly topics = ["document", "solve", "coming", "kept"] as const;
  static override styles = [base, panel, galleryStyle, shelfStyle];

  protected override render() {
    const { session } = this;
    const { cast, opening } = session;
    const { mesh } = session.document;
    const { report } = session.context.workspace;
    const solid = mesh.solve === "solid";
    const character = cast.present?.character;
    return html`<section class="panel" aria-label="Model">
      <h2>Model <button class="btn line" @click=${() => opening.pick("model")}>Open</button></h2>
      ${gallery(
        cast.list.map((performer) => ({
          name: performer.name,
          detail: performer.character ? `${performer.name}, ${count(performer.character.vertices, "vertex", "vertices")}` : performer.file,
          picture: performer.character && session.builtins.picture(performer.character),
          fallback: performer.character ? "model" : "file",
          chosen: cast.isOnStage(performer),
          coming: opening.coming === performer.file,
          choose: () => void opening.usePerformer(performer),
        })),
      )}
      ${
        report
          ? html`<p class="note">${count(report.vertices, "vertex", "vertices")}, ${count(report.faces, "triangle")}${
              report.shells > 1 ? `, ${count(report.shells, "piece")}` : ""
            }${report.volume === null ? ", open surface" : ""}${character ? html`<br>${character.credit}` : ""}</p>`
          : ""
      }
      <div class="more">
        <button class="btn line" title="Now it looks along ${mesh.facing} of its file" @click=${() => this.settings.turn()}>
          ${icon("turn")}Turn to face forward</button>
        <label class="pair">Up axis <select .value=${mesh.up} @change=${this.setUp}>
          ${AXES.map((axis) => html`<option value=${axis} ?selected=${axis === mesh.up}>${axis.toUpperCase()}</option>`)}</select></label>
      </div>
      <rigless-switch label="Carry it by a solid" effect=${solid ? SOLID : SURFACE}
        .on=${solid} @switch=${this.setSolid}></rigless-switch>
      <rigless-duet .session=${session}></rigless-duet>
      ${session.keeping ? shelf(session.keeping) : ""}
    </section>`;
  }

  private get settings(): ModelSettings {
    return new ModelSettings(this.session.context);
  }

  private readonly setSolid = (event: CustomEvent<boolean>): void => this.settings.setSolve(event.detail ? "solid" : "surface");

  private readonly setUp = (event: Event): void => this.settings.setUp((event.target as HTMLSelectElement).value as Axis);
}
