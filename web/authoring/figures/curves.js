// Fig 4.3 as SVG: one panel per constraint set and method, energy over frames.

const WIDTH = 190;
const HEIGHT = 120;
const LEFT = 34;
const TOP = 44;
const COLUMN = WIDTH + 40;
const ROW = HEIGHT + 66;
const METHODS = [["arap", "ARAP, 3 iterations a frame", "#0072b2"], ["cartoon", "Cartoon, 2 iterations a frame", "#d55e00"]];

/** One row per constraint set, a column per method. */
export function curves(sets) {
  const perRow = 2;
  const rows = Math.ceil(sets.length / perRow);
  const width = perRow * METHODS.length * COLUMN + 10;
  const height = rows * ROW + 14;
  const panels = sets.flatMap((set, k) => METHODS.map(([key, title, colour], m) =>
    panel(set, set[key], title, colour, ((k % perRow) * METHODS.length + m) * COLUMN + LEFT, Math.floor(k / perRow) * ROW + TOP)));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="system-ui, sans-serif" font-size="10">
<rect width="100%" height="100%" fill="#fff"/>
${panels.join("\n")}
</svg>
`;
}

function panel(set, { energy, drops, needed }, title, colour, left, top) {
  const frames = energy.length - 1;
  const low = energy.at(-1);
  const span = energy[0] - low || 1;
  const x = (frame) => (left + (frame / frames) * WIDTH).toFixed(1);
  const y = (share) => (top + (1 - share) * HEIGHT).toFixed(1);
  const points = energy.map((e, f) => `${x(f)},${y((e - low) / span)}`).join(" ");
  const dashes = drops.map((frame) =>
    `<path d="M${x(frame)} ${top}V${top + HEIGHT}" stroke="#b3261e" stroke-dasharray="4 3" fill="none"/>`).join("");
  const axis = [0, 0.5, 1].map((share) => `<text x="${left - 4}" y="${Number(y(share)) + 3}" text-anchor="end" fill="#485661">${100 * share} %</text>`).join("")
    + [0, 20, 40, 60].map((frame) => `<text x="${x(frame)}" y="${top + HEIGHT + 13}" text-anchor="middle" fill="#485661">${frame}</text>`).join("");
  return `<g><text x="${left}" y="${top - 20}" font-weight="600" fill="#17212b">${set.name}</text>
<text x="${left}" y="${top - 7}" fill="${colour}">${title}; N = ${needed.toFixed(1)}</text>
<rect x="${left}" y="${top}" width="${WIDTH}" height="${HEIGHT}" fill="none" stroke="#d2dce2"/>
${dashes}<polyline points="${points}" fill="none" stroke="${colour}" stroke-width="1.6"/>
${axis}</g>`;
}
