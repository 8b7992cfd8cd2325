// docs/figures/strangers.md, and what the human's own trunk does in the two dances.
import { placeJoints } from "../kit/skeleton.js";
import { REPERTOIRE } from "../motions/repertoire.js";

const MOTIONS = ["walk", "disco"];
const TRUNK = ["LeftUpLeg", "RightUpLeg", "Spine1", "LeftArm", "RightArm"];

/** Degrees peak to peak that hips and shoulders together turn about the vertical, in each dance. */
export function humanSwing() {
  const rest = trunkPlaces({ root: [0, 93, 0], local: {} });
  return MOTIONS.map((name) => {
    const turns = REPERTOIRE[name].make().map((pose) => turnSince(rest, trunkPlaces(pose)));
    return Math.max(...turns) - Math.min(...turns);
  });
}

function trunkPlaces(pose) {
  const { world } = placeJoints(pose);
  return TRUNK.map((name) => [world[name][0], world[name][2]]);
}

const mean = (places, k) => places.reduce((sum, place) => sum + place[k], 0) / places.length;

function turnSince(before, now) {
  let [sin, cos] = [0, 0];
  before.forEach((place, n) => {
    const [x, z, u, w] = [place[0] - mean(before, 0), place[1] - mean(before, 1), now[n][0] - mean(now, 0), now[n][1] - mean(now, 1)];
    sin += z * u - x * w;
    cos += x * u + z * w;
  });
  return (Math.atan2(sin, cos) * 180) / Math.PI;
}

const count = (n) => n.toLocaleString("en-US");
const right = (said, truth) => (truth ? (truth.split("|").includes(said) ? "yes" : `no, ${truth.replaceAll("|", " or ")}`) : "");

/** results: in the order of the sheets. */
export function strangersTable(results, human, sheets) {
  const rated = results.filter(({ rating, stale }) => rating !== null && !stale);
  const good = rated.filter(({ rating }) => rating >= 2);
  const verdict =
    rated.length === 0 ? "" : `${good.length} of ${rated.length} are good (${Math.round((100 * good.length) / rated.length)} %).\n\n`;
  const rows = results.map(({ name, what, repository, measures, up, front, truth, seconds, rating, note, refused, stale }) => {
    const cells = refused
      ? ["", "", `refused: ${refused.replaceAll("|", "/").replace(/^rigless: /, "")}`, "", "", "", ""]
      : [
          count(measures.triangles),
          count(measures.shells),
          `${up} ${right(up, truth?.up)}, ${front} ${right(front, truth?.front)}`.replaceAll(" ,", ","),
          measures.swing.map(Math.round).join(" / "),
          measures.volume?.map((v) => v.toFixed(2)).join(" to ") ?? "open",
          measures.stretch.toFixed(1),
          seconds.toFixed(1),
        ];
    return `| ${[name, what, repository ?? "", ...cells, rating === null ? "" : stale ? `(${rating})` : rating, note].join(" | ")} |`;
  });
  return `# Strangers

Written by \`node web/authoring/figures/strangers.js\`: models that nobody here made, and hostile ones, each baked with our walk and
disco by the command line, which guesses everything. \`strangers.json\` names their sources. A row of pictures is the rest pose with
the guessed points, six moments of the walk and six of the disco, from the front and from the model's left. Swing is how far the trunk
turns about the vertical, peak to peak, in walk and disco; the human's own is ${human.map((x) => x.toFixed(0)).join(" and ")} degrees.
Volume is its least and greatest part of rest, stretch the length that 999 of 1,000 edges stay below, seconds those of one bake.
Ratings are given by eyes (\`strangers/ratings.json\`): 3 delightful; 2 good: upright, the right way round, every limb answers its
human's, nothing torn, nothing spinning; 1 wrong in something; 0 broken; in
brackets when the dance has changed since.

${verdict}| name | what | repository | triangles | shells | up, front: right? | swing | volume | stretch | s | rating | note |
|---|---|---|---|---|---|---|---|---|---|---|---|
${rows.join("\n")}

${sheets.map((sheet) => `![](strangers/${sheet})`).join("\n")}
`;
}
