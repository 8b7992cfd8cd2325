import { css, html } from "lit";
import { icon } from "../icons";

export interface Tile {
  name: string;
  /** What the pointer reads. */
  detail: string;
  /** A strip of FRAMES pictures side by side, or null. */
  picture: string | null;
  fallback: "model" | "motion" | "file";
  chosen: boolean;
  /** Chosen, and not there yet. */
  coming: boolean;
  choose: () => void;
}

/** Pictures to choose from; each moves while the pointer or the focus is on it. */
export function gallery(tiles: readonly Tile[]) {
  return html`<ul class="gallery">${tiles.map(
    (tile) => html`<li>
    <button class="tile" aria-pressed=${tile.chosen} aria-busy=${tile.coming} title=${tile.detail} @click=${tile.choose}>
      ${
        tile.picture
          ? html`<img src=${tile.picture} alt="" width="72" height="72" loading="lazy" decoding="async">`
          : html`<i>${icon(tile.fallback)}</i>`
      }
      <span>${tile.name}</span>${tile.coming ? html`<b></b>` : ""}</button></li>`,
  )}</ul>`;
}

/** As many pictures as authoring/figures/pictures.ts draws. */
const FRAMES = 8;

export const galleryStyle = css`
  .gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(76px, 1fr)); gap: 4px; }
  .tile { position: relative; display: grid; justify-items: center; gap: 2px; width: 100%; min-width: 0; padding: 4px 2px 6px; border: 0;
    border-radius: 12px; background: none; color: var(--ink); font: var(--t-small); cursor: pointer;
    transition: background var(--base), transform var(--bounce) var(--squash); }
  .tile:hover { background: var(--desk); }
  .tile:active { transform: scale(1.04, .92); }
  .tile[aria-pressed="true"] { background: var(--well); font-weight: 600; }
  .tile img, .tile i { display: grid; place-items: center; width: 72px; height: 72px; }
  .tile i { color: var(--ink-3); }
  .tile img { object-fit: cover; object-position: 0 0; }
  .tile span { max-width: 100%; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
  @media (max-width: 719px) {
    .gallery { display: flex; overflow-x: auto; margin: 0 -8px; padding: 3px 8px; scroll-padding: 8px; scroll-snap-type: x proximity; }
    .gallery li { flex: 0 0 84px; scroll-snap-align: start; }
  }
  @media (prefers-reduced-motion: no-preference) {
    .tile:is(:hover, :focus-visible) img { animation: perform 1s steps(${FRAMES}, jump-none) infinite; }
  }
  @keyframes perform { to { object-position: 100% 0; } }
  /* the ball of a job, once it has taken a moment */
  .tile b { position: absolute; left: 50%; top: 66px; width: 14px; height: 11px; margin-left: -7px; border-radius: 50%;
    background: var(--now); box-shadow: 0 0 0 1.5px var(--on-now); opacity: 0;
    animation: appear 0s .1s forwards, bounce .5s .1s ease-in-out infinite alternate; }
  @keyframes appear { to { opacity: 1; } }
  @keyframes bounce { from { translate: -22px; } to { translate: 22px; } }
`;
