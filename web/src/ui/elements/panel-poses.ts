import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { Example } from "../../app/poses";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { stem } from "../../util/words";

@customElement("rigless-panel-poses")
export class PosesPanel extends SessionElement {
  protected readonly topics = ["document", "frame", "thumbnails", "solve"] as const;

  static override styles = [
    base,
    panel,
    css`
      .row { display: flex; align-items: center; gap: 4px; border-radius: var(--r-m); }
      .row.now { background: var(--well); }
      .item { grid-template-columns: 40px 1fr; min-height: 48px; flex: 1; min-width: 0; padding: 0 4px; }
      .item small { display: block; }
      .thumb { width: 40px; height: 40px; }
      @media (hover: hover) { .row:not(:hover, :focus-within) .update { opacity: 0; } }
    `,
  ];

  protected override render() {
    const { poses, document, actions } = this.session;
    const { examples } = document;
    const { addPose } = actions;
    return html`<section class="panel" aria-label="Poses">
      <h2>Poses <button class="btn line" ?disabled=${!addPose.enabled()} @click=${() => addPose.run()}>Add</button></h2>
      ${
        examples.length === 0
          ? html`<p class="note">Stop at a frame, drag a dot and let go: that is a pose. Two are enough to start.</p>`
          : nothing
      }
      <ul>${[...poses.here, ...examples.filter((pose) => !poses.isHere(pose))].map((pose) => this.renderPose(pose))}</ul>
    </section>`;
  }

  private renderPose(pose: Example) {
    const { session } = this;
    const here = session.poses.isHere(pose);
    const frame = here ? session.poses.frameOf(pose) : pose.source.frame;
    const now = here && frame === session.player.frame;
    const picture = session.thumbnails.of(pose);
    return html`<li class="row ${now ? "now" : ""}">
      <button class="item" ?disabled=${!here} @click=${() => session.poses.goTo(pose.id)}>
        <span class="thumb">${picture ? html`<img src=${picture} alt="" />` : ""}</span>
        <span>Frame ${frame}<small>${stem(pose.source.motion)}</small></span></button>
      ${
        here && !now
          ? html`<button class="btn update" title="Take the shape at frame ${session.player.frame} instead"
              @click=${() => session.poses.update(pose.id)}>Update</button>`
          : nothing
      }
      <button class="btn icon" aria-label="Delete the pose at frame ${frame}"
        @click=${() => session.poses.remove(pose.id)}>${icon("bin")}</button>
    </li>`;
  }
}
