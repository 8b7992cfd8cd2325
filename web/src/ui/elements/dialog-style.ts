import { css } from "lit";

/** What every dialog is on: paper above a veiled stage. */
export const dialogStyle = css`
  dialog { border: 0; color: var(--ink); background: var(--paper); border-radius: 20px; box-shadow: var(--lift-2);
    padding: var(--s2) var(--s3) var(--s3); width: 400px; max-width: calc(100vw - 32px); }
  dialog::backdrop { background: light-dark(rgb(227 236 240 / .82), rgb(16 23 29 / .78)); }
  h2 { font: var(--t-title); display: flex; justify-content: space-between; align-items: center; margin: 0 -8px 0 0; }
`;
