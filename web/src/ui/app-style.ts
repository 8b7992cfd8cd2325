import { css } from "lit";

/** Where each part of the page stands: a desk, a phone held upright, and one that lies on its side, which shows the dance alone. */
export const appStyle = css`
  :host { display: grid; height: 100%; overflow: hidden; grid-template: 48px minmax(0, 1fr) auto / auto minmax(0, 1fr) auto;
    color: var(--ink); --gap: var(--s2); }
  rigless-top-bar { grid-area: 1 / 1 / 2 / -1; z-index: 4; position: relative; }
  main { grid-area: 2 / 1 / 3 / -1; position: relative; background: var(--stage); overflow: hidden; min-height: 0; }
  .view3d { position: absolute; inset: 0; }
  .left { grid-area: 2 / 1; align-self: stretch; display: flex; align-items: flex-start; pointer-events: none; z-index: 2;
    min-height: 0; }
  .left > * { pointer-events: auto; }
  .panel { margin: var(--gap) 0; max-height: calc(100% - 2 * var(--gap)); display: flex; min-height: 0; }
  .panel > * { display: flex; min-height: 0; }
  rigless-inspector { grid-area: 2 / 3; align-self: start; z-index: 2; max-height: calc(100% - 2 * var(--gap)); overflow-y: auto; }
  .middle { grid-area: 2 / 2; position: relative; z-index: 2; pointer-events: none; display: grid; grid-template-rows: auto 1fr auto;
    min-width: 0; min-height: 0; }
  rigless-notices { justify-self: center; margin: var(--s2) var(--s1) 0; }
  rigless-intro { position: absolute; inset: 0; }
  .low { grid-row: 3; display: grid; justify-items: end; align-content: end; min-width: 0; }
  .low > :not(.foot), .foot > * { pointer-events: auto; }
  .foot { justify-self: stretch; display: flex; justify-content: space-between; align-items: end; container-type: inline-size; }
  @media (min-width: 720px) { @container (max-width: 390px) { rigless-status { display: none; } } }
  rigless-prompt { justify-self: stretch; margin-bottom: 0; }
  .dock { grid-area: 3 / 1 / 4 / -1; background: var(--desk); border-top: 1px solid var(--line); padding: 0 var(--s2) var(--s1);
    z-index: 3; min-width: 0; }
  @media (max-height: 740px) { :host { --gap: var(--s1); } }
  /* a panel takes the inspector's room where both would leave none */
  @media (max-width: 959px) { .left:has(.panel) ~ rigless-inspector { display: none; } }
  @media (max-height: 560px) { .left:has(.panel) ~ .middle rigless-view { display: none; } }
  @media (max-width: 719px) {
    :host { grid-template: 56px minmax(0, 1fr) auto auto auto / minmax(0, 1fr); }
    rigless-top-bar { grid-area: 1 / 1; }
    main, .middle { grid-area: 2 / 1; }
    rigless-notices { justify-self: stretch; margin: 8px 8px 0; }
    rigless-view { display: none; }
    .dock { grid-area: 3 / 1; padding: 0 12px 8px; }
    .sheet { grid-area: 4 / 1; background: var(--paper); border-top: 1px solid var(--line); overflow-y: auto; z-index: 3;
      max-height: max(180px, min(34vh, 100vh - 500px)); }
    .handle { display: block; width: 100%; height: 20px; border: 0; background: none; padding: 0; cursor: pointer; position: relative; }
    .handle::before { content: ""; position: absolute; inset: -12px 0; }
    .handle::after { content: ""; display: block; width: 40px; height: 4px; border-radius: 2px; background: var(--edge);
      margin: 0 auto; }
    rigless-rail { grid-area: 5 / 1; z-index: 3; }
    .panel { margin: 0; max-height: none; }
    .panel > * { display: block; flex: 1; min-width: 0; }
    rigless-inspector { max-height: none; overflow: visible; }
  }
  /* to watch: the stage, and playing */
  @media (max-height: 439px) and (orientation: landscape) {
    :host { grid-template: minmax(0, 1fr) auto / minmax(0, 1fr); }
    main { grid-area: 1 / 1; }
    .dock { grid-area: 2 / 1; padding: 0 var(--s2); }
    rigless-top-bar, .left, .middle, .left ~ rigless-inspector, .sheet, rigless-rail, rigless-timeline { display: none; }
  }
`;
