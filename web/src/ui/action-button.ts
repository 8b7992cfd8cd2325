import { html, nothing } from "lit";
import type { TemplateResult } from "lit";
import { ifDefined } from "lit/directives/if-defined.js";
import { capsOf, labelOf, shortcutsOf, titleOf } from "../app/actions";
import type { Action } from "../app/actions";

export interface ButtonLook {
  /** Its classes; "btn" if left out. */
  class?: string;
  /** A drawing or a number: then the label is for assistive technology alone. */
  drawing?: TemplateResult;
  /** Instead of the action's label, for assistive technology. */
  says?: string;
  pressed?: boolean;
  /** Before and after the words. */
  before?: TemplateResult;
  after?: TemplateResult;
}

/** A button of an action, with its words, its keys and whether it can be pressed. */
export function actionButton(action: Action, look: ButtonLook = {}): TemplateResult {
  const { class: kind = "btn", drawing, says, pressed, before, after } = look;
  const label = labelOf(action);
  const title = drawing || action.title || action.keys.length > 0 ? titleOf(action) : undefined;
  return html`<button
    class=${kind}
    title=${ifDefined(title)}
    aria-label=${drawing ? (says ?? label) : nothing}
    aria-pressed=${pressed ?? nothing}
    aria-keyshortcuts=${shortcutsOf(action) ?? nothing}
    ?disabled=${!action.enabled()}
    @click=${() => action.run()}
  >${before ?? nothing}${drawing ?? label}${after ?? nothing}</button>`;
}

/** The caps of an action's keys. */
export function caps(action: Action): TemplateResult[] {
  return capsOf(action).map((cap) => html`<kbd>${cap}</kbd>`);
}
