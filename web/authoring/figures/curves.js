// Fig 4.3 as SVG: a panel per constraint set, energy over frames.

const WIDTH = 250;
const HEIGHT = 130;
const LEFT = 46;
const TOP = 62;
const COLUMN = WIDTH + 54;
const ROW = HEIGHT + 64;
const PER_ROW = 3;
const METHODS = [
  ["arap", "ARAP", "#0072b2"],
  ["cartoon", "Cartoon", "#c04f00"],
];

export function curves(sets) {
  const width = PER_ROW * COLUMN + 8;
  const height = Math.ceil(sets.length / PER_ROW) * ROW + 38;
  const panels = sets.map((set, k) => panel(set, (k % PER_ROW) * COLUMN + LEFT, Math.floor(k / PER_ROW) * ROW + TOP));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="system-ui, sans-serif" font-size="11" fill="#485661">
<rect width="100%" height="100%" fill="#fff"/>
<text x="${LEFT}" y="18">Part of the drop that is left, by frame. <tspan fill="${METHODS[0][2]}">ARAP, 3 iterations a frame</tspan>; <tspan fill="${METHODS[1][2]}">cartoon, 2 iterations a frame</tspan>. Dashed: 30, 20 and 10 % left.</text>
${panels.join("\n")}
</svg>
`;
}

function panel(set, left, top) {
  const frames = set.arap.energy.length - 1;
  const x = (frame) => (left + (frame / frames) * WIDTH).toFixed(1);
  const y = (share) => (top + (1 - share) * HEIGHT).toFixed(1);
  const labels = METHODS.map(
    ([key, title, colour], m) =>
      `<text x="${left + WIDTH - 8}" y="${top + 20 + 16 * m}" text-anchor="end" fill="${colour}">${title}: N = ${set[key].needed.toFixed(1)}</text>`,
  );
  const lines = METHODS.map(([key, , colour]) => {
    const { energy, drops } = set[key];
    const low = energy.at(-1);
    const span = energy[0] - low || 1;
    const points = energy.map((e, f) => `${x(f)},${y((e - low) / span)}`).join(" ");
    const dashes = drops.map((frame, k) => `M${x(frame)} ${y([0.3, 0.2, 0.1][k])}V${top + HEIGHT}`).join("");
    return `<path d="${dashes}" stroke="${colour}" stroke-dasharray="3 2" fill="none"/><polyline points="${points}" fill="none" stroke="${colour}" stroke-width="1.6" stroke-linejoin="round"/>`;
  });
  const ticks = [0, 0.5, 1]
    .map((share) => `<text x="${left - 5}" y="${Number(y(share)) + 4}" text-anchor="end">${100 * share} %</text>`)
    .concat([0, 20, 40, 60].map((frame) => `<text x="${x(frame)}" y="${top + HEIGHT + 15}" text-anchor="middle">${frame}</text>`));
  return `<g><text x="${left}" y="${top - 9}" font-weight="600" fill="#17212b">${set.name}</text>
<rect x="${left}" y="${top}" width="${WIDTH}" height="${HEIGHT}" fill="none" stroke="#d2dce2"/>
${lines.join("")}${ticks.join("")}${labels.join("")}</g>`;
}
