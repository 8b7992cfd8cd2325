import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import type { Job } from "../../app/jobs";
import { base } from "../styles";

/** Long work: its steps, its measure, and a way out. All else goes on meanwhile. */
@customElement("rigless-jobs")
export class JobCard extends SessionElement {
  protected readonly topics = ["jobs"] as const;

  static override styles = [
    base,
    css`
      :host { display: grid; gap: var(--s1); margin: 0 var(--s2); }
      .job { background: var(--paper); border-radius: var(--r-l); box-shadow: var(--lift-1); padding: var(--s2); width: 304px;
        max-width: calc(100vw - 16px); }
      h3 { font: var(--t-title); min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .top { display: flex; justify-content: space-between; align-items: center; gap: 8px; margin-bottom: 12px; }
      .progress { position: relative; height: 14px; border-radius: var(--r-full); background: var(--well); }
      .progress i { position: absolute; inset: 0 calc(100% - var(--p) * 100%) 0 0; border-radius: var(--r-full); background: var(--ink); }
      .progress b { position: absolute; left: calc(12px + var(--p) * (100% - 20px)); top: 50%; width: 24px; height: 18px;
        margin: -9px 0 0 -16px; border-radius: 50%; background: var(--now); box-shadow: 0 0 0 1.5px var(--on-now), 0 0 0 4px var(--paper); }
      .steps { margin-top: 12px; display: grid; gap: 4px; font: var(--t-small); color: var(--ink-2); }
      .steps li { display: grid; grid-template-columns: 20px 1fr auto; align-items: center; min-height: 20px; }
      .steps .ico { width: 14px; height: 14px; stroke-width: 2.5; }
      .is-now { color: var(--ink); font-weight: 600; }
      .dotnow { width: 9px; height: 9px; border-radius: 50%; background: var(--now); box-shadow: 0 0 0 1.5px var(--on-now);
        margin-left: 3px; }
      .todo { width: 9px; height: 9px; border-radius: 50%; box-shadow: inset 0 0 0 1.5px var(--edge); margin-left: 3px; }
      @media (max-width: 719px) { :host { margin: 0 8px; } }
    `,
  ];

  protected override render() {
    return this.session.jobs.shown.map((job) => this.renderJob(job));
  }

  private renderJob(job: Job) {
    const percent = job.done === null ? null : Math.round(job.done * 100);
    const whole = (job.step + (job.done ?? 0)) / job.steps.length;
    const mark = (k: number) => (k < job.step ? icon("tick") : k === job.step ? html`<i class="dotnow"></i>` : html`<i class="todo"></i>`);
    return html`<section class="job" aria-label=${job.title}>
      <div class="top"><h3>${job.title}</h3><button class="btn line" @click=${job.cancel}>Cancel</button></div>
      <div class="progress" role="progressbar" aria-label=${job.title} aria-valuemin="0" aria-valuemax="100"
        aria-valuenow=${Math.round(whole * 100)} style="--p:${whole}"><i></i><b></b></div>
      <ul class="steps">
        ${job.steps.map(
          (step, k) =>
            html`<li class=${k === job.step ? "is-now" : ""}>${mark(k)}<span>${step}${
              k === job.step && percent !== null ? `, ${percent} %` : ""
            }</span></li>`,
        )}
      </ul>
    </section>`;
  }
}
