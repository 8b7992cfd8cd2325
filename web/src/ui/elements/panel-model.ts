import { html } from "lit";
import { customElement } from "lit/decorators.js";
import type { Axis } from "../../document/types";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { count } from "../words";

const AXES: readonly Axis[] = ["+y", "+z", "+x", "-y", "-z", "-x"];

@customElement("rigless-panel-model")
export class ModelPanel extends SessionElement {
  protected readonly topics = ["document", "solve"] as const;
  static override styles = [base, panel];

  protected override render() {
    const { session } = this;
    const { mesh } = session.document;
    const report = session.report;
    return html`<section class="panel" aria-label="Model">
      <h2>Model <button class="btn line" @click=${() => session.pickFiles("model")}>Open</button></h2>
      <ul>
        ${[session.builtins.model].map((model) => html`<li><button class="item" aria-pressed=${mesh.file === model.file} @click=${() => session.openBuiltin()}>
          ${icon("model")}<span>${model.name}</span><small>built in</small></button></li>`)}
        ${session.builtins.model.file === mesh.file ? "" : html`<li><button class="item" aria-pressed="true">
          ${icon("file")}<span>${session.modelName}</span><small></small></button></li>`}
      </ul>
      ${report ? html`<p class="note">${count(report.vertices, "vertex", "vertices")}, ${count(report.faces, "triangle")}${
        report.shells > 1 ? `, ${count(report.shells, "piece")}` : ""}${report.volume === null ? ", open surface" : ""}</p>` : ""}
      <div class="more">
        <button class="btn line" title="Now it looks along ${mesh.facing} of its file" @click=${() => session.turnModel()}>${icon("turn")}Turn to face forward</button>
        <label class="pair">Up axis <select .value=${mesh.up} @change=${(event: Event) => session.setUp((event.target as HTMLSelectElement).value as Axis)}>
          ${AXES.map((axis) => html`<option value=${axis} ?selected=${axis === mesh.up}>${axis.toUpperCase()}</option>`)}</select></label>
      </div>
    </section>`;
  }
}
