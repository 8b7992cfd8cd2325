import { html } from "lit";
import { customElement } from "lit/decorators.js";
import type { Axis } from "../../document/types";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { count } from "../../util/words";
import { gallery, galleryStyle } from "./gallery";

const AXES: readonly Axis[] = ["+y", "+z", "+x", "-y", "-z", "-x"];

@customElement("rigless-panel-model")
export class ModelPanel extends SessionElement {
  protected readonly topics = ["document", "solve", "coming"] as const;
  static override styles = [base, panel, galleryStyle];

  protected override render() {
    const { session } = this;
    const { mesh } = session.document;
    const { cast, report } = session;
    const character = cast.present?.character;
    return html`<section class="panel" aria-label="Model">
      <h2>Model <button class="btn line" @click=${() => session.pickFiles("model")}>Open</button></h2>
      ${gallery(
        cast.list.map((performer) => ({
          name: performer.name,
          detail: performer.character ? `${performer.name}, ${count(performer.character.vertices, "vertex", "vertices")}` : performer.file,
          picture: performer.character && session.builtins.picture(performer.character),
          fallback: performer.character ? "model" : "file",
          chosen: cast.isOnStage(performer),
          coming: session.coming === performer.file,
          choose: () => session.usePerformer(performer),
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
        <button class="btn line" title="Now it looks along ${mesh.facing} of its file" @click=${() => session.turnModel()}>${icon("turn")}Turn to face forward</button>
        <label class="pair">Up axis <select .value=${mesh.up} @change=${(event: Event) => session.setUp((event.target as HTMLSelectElement).value as Axis)}>
          ${AXES.map((axis) => html`<option value=${axis} ?selected=${axis === mesh.up}>${axis.toUpperCase()}</option>`)}</select></label>
      </div>
    </section>`;
  }
}
