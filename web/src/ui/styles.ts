import { css } from "lit";

/** What every element starts from: box sizes, focus, buttons, keys, badges. */
export const base = css`
  *, *::before, *::after { box-sizing: border-box; }
  h1, h2, h3, p, ul, ol, dl, dd, fieldset { margin: 0; padding: 0; border: 0; }
  ul, ol { list-style: none; }
  svg { display: block; }
  [hidden] { display: none !important; }
  .ico { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.75; stroke-linecap: round; stroke-linejoin: round;
    flex: none; }
  .vh { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
  .grow { flex: 1; }
  .sub { font: var(--t-small); color: var(--ink-3); }

  /* paper gap, ink ring, yellow halo: reads on every surface */
  :focus { outline: none; }
  :focus-visible { box-shadow: var(--frame, 0 0 transparent), 0 0 0 2px var(--paper), 0 0 0 4px var(--ink),
    0 0 0 7px var(--now) !important; position: relative; z-index: 2; }

  .btn { display: inline-flex; align-items: center; justify-content: center; gap: var(--s1); min-height: var(--hit);
    min-width: var(--hit); padding: 0 12px; border: 0; border-radius: var(--r-m); background: transparent; color: var(--ink);
    font: var(--t-strong); white-space: nowrap; cursor: pointer;
    transition: background var(--fast), transform var(--bounce) var(--squash); }
  .btn:hover { background: var(--well); }
  .btn:active { transform: scale(1.04, .92); }
  .btn.icon { padding: 0; width: var(--hit); flex: none; }
  .btn.line { --frame: inset 0 0 0 var(--stroke) var(--edge); box-shadow: var(--frame); }
  .btn.primary { background: var(--ink); color: var(--on-ink); padding: 0 16px; }
  .btn.primary:hover { background: var(--ink-2); }
  .btn.pencil { color: var(--pencil); box-shadow: inset 0 0 0 var(--stroke) var(--pencil); }
  .btn[disabled] { color: var(--ink-3); opacity: .55; cursor: default; background: none; transform: none; }
  .btn.primary[disabled] { background: var(--well); }
  kbd { font: var(--t-micro); color: var(--ink-2); padding: 0 5px; border-radius: 4px; box-shadow: inset 0 0 0 1px var(--edge);
    min-width: 18px; text-align: center; }
  .primary kbd { color: inherit; box-shadow: inset 0 0 0 1px currentColor; opacity: .8; }
  @media (pointer: coarse), (max-width: 719px) { kbd { display: none; } }

  .pt { display: inline-grid; place-items: center; width: 18px; height: 18px; border-radius: 50%; font: 700 11px/1 var(--font);
    flex: none; background: var(--c); color: var(--on-c); box-shadow: inset 0 0 0 1px color-mix(in oklab, var(--c), var(--ink) 40%); }
  .pt.square { border-radius: 4px; }
  .pt.now { box-shadow: 0 0 0 2px var(--paper), 0 0 0 4px var(--now); }
  .pt.weak { background: var(--paper); color: var(--ink); box-shadow: inset 0 0 0 1.5px var(--edge); }

  .thumb { display: block; background: var(--paper); border-radius: var(--r-s); box-shadow: inset 0 0 0 1px var(--line); overflow: hidden; }
  .thumb img { display: block; width: 100%; height: 100%; object-fit: contain; }
`;

/** A card that floats on the stage with a title and rows: the lists beside the rail. */
export const panel = css`
  .panel { background: var(--paper); border-radius: var(--r-l); box-shadow: var(--lift-1); padding: var(--s1); width: 264px;
    max-height: 100%; overflow-y: auto; }
  .panel > h2 { font: var(--t-title); padding: 4px 4px 8px 8px; display: flex; justify-content: space-between; align-items: center;
    min-height: var(--hit); gap: 8px; }
  .item { display: grid; grid-template-columns: 22px 1fr auto; gap: 8px; align-items: center; width: 100%;
    min-height: max(36px, var(--hit)); padding: 0 8px; border: 0; border-radius: var(--r-m); background: none; color: var(--ink);
    font: var(--t-strong); text-align: left; cursor: pointer; }
  .item small { font: var(--t-small); color: var(--ink-3); }
  .item:hover { background: var(--desk); }
  .item[aria-pressed="true"] { background: var(--well); }
  .item[aria-pressed="true"] small { color: var(--ink-2); }
  .keys { display: flex; flex-wrap: wrap; gap: 4px 12px; padding: 8px 8px 4px; font: var(--t-small); color: var(--ink-2);
    border-top: 1px solid var(--line); margin-top: 8px; }
  .note { padding: 4px 8px 8px; font: var(--t-small); color: var(--ink-2); }
  .more { display: grid; gap: 8px; padding: 8px; border-top: 1px solid var(--line); margin-top: 8px; }
  .pair { display: grid; grid-template-columns: 64px 1fr; gap: 8px; align-items: center; font: var(--t-small); color: var(--ink-2); }
  .pair input, .pair select { min-height: var(--hit); min-width: 0; width: 100%; padding: 0 8px; border: 0; border-radius: var(--r-m);
    background: var(--paper); color: var(--ink); font: var(--t-body); --frame: inset 0 0 0 var(--stroke) var(--edge);
    box-shadow: var(--frame); }
  @media (pointer: coarse), (max-width: 719px) { .pair input, .pair select { font-size: 16px; } }
  .row-acts { display: flex; flex-wrap: wrap; gap: 4px; }
  @media (max-width: 719px) {
    .panel { width: auto; border-radius: 0; box-shadow: none; padding: 0 8px 8px; max-height: none; overflow: visible; }
    .keys { display: none; }
  }
`;
