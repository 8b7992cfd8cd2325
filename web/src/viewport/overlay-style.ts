// The marks over the stage. Sizes and states of design tokens; each variable has a fallback so that the viewport also runs alone.

const css = `
:host { display: block; position: absolute; inset: 0; isolation: isolate; overflow: hidden; touch-action: none; user-select: none;
  -webkit-user-select: none;
  --mark: 20px; --mark-human: 15px; --area: 32px; font-family: var(--font, system-ui, sans-serif); }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; outline: none; }
svg { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; overflow: hidden; }
.marks { position: absolute; inset: 0; pointer-events: none; }
.point { position: absolute; left: 0; top: 0; width: var(--area); height: var(--area); margin: calc(var(--area) / -2); padding: 0;
  border: 0;
  background: none; display: grid; place-items: center; pointer-events: auto; cursor: inherit; outline: none; touch-action: none;
  will-change: transform; z-index: 2; -webkit-tap-highlight-color: transparent; }
.point[hidden] { display: none; }
.point .mark { width: var(--mark); height: var(--mark); border-radius: 50%; background: var(--c); color: var(--on-c); display: grid;
  place-items: center;
  font: 700 11.5px/1 var(--font, system-ui, sans-serif); font-variant-numeric: tabular-nums;
  box-shadow: 0 0 0 1.7px var(--ring, #fff), 0 0 0 2.5px rgb(23 33 43 / .55);
  transition: scale var(--base, 160ms) var(--ease, ease), background-color var(--base, 160ms); }
.point.square .mark { border-radius: 5px; }
.point.human .mark { width: var(--mark-human); height: var(--mark-human); font-size: 9.5px; }
.point.hover .mark { scale: 1.2; }
.point.behind { z-index: 1; }
.point.behind .mark { background: color-mix(in srgb, var(--c) 35%, transparent); color: var(--ink, #17212b); --ring: rgb(255 255 255 / .5);
  box-shadow: 0 0 0 1.7px var(--ring), 0 0 0 2.5px rgb(23 33 43 / .3); }
.point.unpaired .mark { background: var(--paper, #fff); color: var(--ink, #17212b); --ring: var(--paper, #fff); }
.point.unpaired.behind .mark { background: color-mix(in srgb, var(--paper, #fff) 35%, transparent); }
.point.suggested .mark { background: color-mix(in srgb, var(--paper, #fff) 70%, transparent); color: var(--pencil, #166e94);
  box-shadow: none;
  outline: 1.5px dashed var(--pencil, #166e94); }
.point.twin .mark { outline: 1.5px dashed var(--pencil, #166e94); outline-offset: 4px; }
.point.on { z-index: 4; }
.point.on .mark { box-shadow: 0 0 0 1.7px var(--ring, #fff), 0 0 0 2.5px rgb(23 33 43 / .55), 0 0 0 7px var(--now, #ffd233),
  0 0 0 8.5px #17212b; }
.point.human.on .mark { box-shadow: 0 0 0 1.7px var(--ring, #fff), 0 0 0 2.5px rgb(23 33 43 / .55), 0 0 0 5px var(--now, #ffd233),
  0 0 0 6.2px #17212b; }
.point:focus-visible:not(.pressed) { z-index: 5; }
.point:focus-visible:not(.pressed) .mark {
  box-shadow: 0 0 0 2px var(--paper, #fff), 0 0 0 4px var(--ink, #17212b), 0 0 0 7px var(--now, #ffd233); }
.point.pulse::before, .point.pulse::after { content: ""; position: absolute; width: 28px; height: 28px; border-radius: 50%;
  border: 1.5px solid var(--ink, #17212b);
  opacity: 0; animation: ring 1.6s var(--ease, ease-out) 3; pointer-events: none; }
.point.pulse::after { animation-delay: .25s; }
@keyframes ring { from { scale: .8; opacity: .6; } to { scale: 2; opacity: 0; } }
.tag { position: absolute; left: 0; top: 0; z-index: 6; min-height: 24px; padding: 2px 8px; box-sizing: border-box; border-radius: 6px;
  white-space: pre;
  background: var(--ink, #17212b); color: var(--on-ink, #fff); font: var(--t-strong, 600 13px/20px system-ui, sans-serif);
    font-variant-numeric: tabular-nums; pointer-events: none; }
.tag[hidden] { display: none; }
.casing { fill: none; stroke: var(--paper, #fff); stroke-width: 5; stroke-linecap: round; }
.pair { fill: none; stroke-width: 2.5; stroke-linecap: round; }
.pair.live { stroke-dasharray: 7 6; }
.lead { fill: none; stroke: var(--pencil, #166e94); stroke-width: 2; stroke-linecap: round; stroke-dasharray: .1 5; }
.probe { fill: var(--paper, #fff); stroke: var(--pencil, #166e94); stroke-width: 1.5; }
@media (pointer: coarse) { :host { --mark: 24px; --mark-human: 18px; --area: 44px; } }
@media (prefers-reduced-motion: reduce) { .point.pulse::before { animation: none; opacity: .5; } .point .mark { transition: none; } }
`;

/** A constructed sheet, because a strict content-security-policy forbids style elements. */
export function overlayStyle(): CSSStyleSheet {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  return sheet;
}
