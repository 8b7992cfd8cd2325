import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { editingOf, SAID_ROLES, type SaidRole } from "../../app/motion-editing";
import { figure } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { type Option, select } from "./select";

const UNITS: readonly (readonly [name: string, metres: number])[] = [
  ["Metres", 1],
  ["Feet", 0.3048],
  ["0.45 inches (CMU)", 0.0254 / 0.45],
  ["Inches", 0.0254],
  ["Centimetres", 0.01],
  ["Millimetres", 0.001],
];

const UPS = { "+y": "Y", "+z": "Z", "-y": "Y, head down", "-z": "Z, head down" } as const;
const RATES = [24, 25, 30, 50, 60, 90, 100, 120, 240] as const;

/** What a motion's file is, where the guess is wrong. */
@customElement("rigless-file-facts")
export class FileFacts extends SessionElement {
  protected readonly topics = ["document", "solve", "pairing"] as const;

  static override styles = [
    base,
    panel,
    css`
      summary { display: flex; align-items: center; min-height: var(--hit); cursor: pointer; font: var(--t-strong);
        border-radius: var(--r-m); list-style: none; }
      summary::-webkit-details-marker { display: none; }
      summary::after { content: "+"; margin-left: auto; padding: 0 8px; font: var(--t-title); color: var(--ink-3); }
      [open] > summary::after { content: "–"; }
      .facts { display: grid; gap: 8px; padding: 4px 0; }
      .facts p { font: var(--t-small); color: var(--ink-2); }
      .role { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 4px; }
      .role [aria-pressed="true"] { background: var(--ink); color: var(--on-ink); }
      .pair { grid-template-columns: 72px minmax(0, 1fr); }
    `,
  ];

  protected override render() {
    const { motion } = this.session.context;
    if (!motion) return nothing;
    const editing = editingOf(this.session);
    const { file = {} } = editing.said;
    const { tall } = editing;
    const { metresPerUnit: unit, fps: own } = motion.source;
    const rates = [...new Set([...RATES, ...(file.fps ? [file.fps] : [])])];
    const sizes = UNITS.map(([name, metres]): Option => [`${metres}`, `${name}: ${length((tall * metres) / unit)} tall`]);
    return html`<details><summary>Does the human look wrong?</summary><div class="facts">
      <button class="btn line" @click=${() => editing.turn()}>${icon("turn")}Turn by a quarter</button>
      ${select(
        "Size in",
        `${file.metresPerUnit ?? ""}`,
        [["", file.metresPerUnit === undefined ? `Found: ${length(tall)} tall` : "As found"], ...sizes],
        (value) => editing.correct({ metresPerUnit: value === "" ? undefined : Number(value) }),
      )}
      ${select("Up is", file.up ?? "", [["", "As found"], ...Object.entries(UPS)], (value) =>
        editing.correct({ up: value in UPS ? (value as keyof typeof UPS) : undefined }),
      )}
      ${select(
        "Frames",
        `${file.fps ?? ""}`,
        [["", `Found: ${figure(own)} a second`], ...rates.map((rate): Option => [`${rate}`, `${rate} a second`])],
        (value) => editing.setRate(value === "" ? null : Number(value), own),
      )}
      <p>${editing.waiting ? `Click the ${editing.waiting} of the human.` : "Which of its joints is which, or click it on the human:"}</p>
      ${SAID_ROLES.map((role) => this.renderRole(role, editing.said.file?.joints?.[role] ?? ""))}
    </div></details>`;
  }

  private renderRole(role: SaidRole, said: string) {
    const editing = editingOf(this.session);
    const names = (this.session.context.motion?.joints ?? []).map(({ name }): Option => [name, name]);
    const found = said === "" ? (editing.jointOf(role) ?? "none found") : "As found";
    const waits = editing.waiting === role;
    const label = role[0].toUpperCase() + role.slice(1);
    return html`<div class="role">${select(label, said, [["", found], ...names], (value) =>
      editing.setJoint(role, value === "" ? null : value),
    )}<button class="btn icon" aria-pressed=${waits} title="Click it on the human" aria-label="Click the ${role} on the human"
        @click=${() => editing.waitFor(waits ? null : role)}>${icon("points")}</button></div>`;
  }
}

/** "1.75 m", "17 cm" */
const length = (metres: number): string =>
  metres < 0.1 ? `${figure(100 * metres, metres < 0.01 ? 1 : 0)} cm` : `${figure(metres, metres < 10 ? 2 : 0)} m`;
