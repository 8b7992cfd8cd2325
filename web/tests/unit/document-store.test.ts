import { expect, it } from "vitest";

import {
  addExample,
  addPoint,
  freeId,
  newDocument,
  pairPoint,
  removeExample,
  removePoint,
  replaceExample,
  setPoint,
  renameProject,
  setMesh,
  setMotion,
  setSettings,
  turnMesh,
} from "../../src/document/commands";
import { pairMirror } from "../../src/document/pair-mirror";
import { clipOf, merged, removePin, setContacts, setFlights, setPin } from "../../src/document/clips";
import { type Command, DocumentStore } from "../../src/document/store";
import type { ProjectDocument } from "../../src/document/types";

const start: ProjectDocument = [
  addPoint({ id: "p1", name: "top", position: [0, 1, 0], joint: "head" }),
  addPoint({ id: "p2", name: "side", position: [1, 0, 0], joint: null }),
  addExample({ id: "e1", source: { motion: "a.bvh", frame: 3 }, joints: { root: [0, 0, 0] }, points: { p1: [0, 2, 0], p2: [2, 0, 0] } }),
].reduce((document, command) => command(document), newDocument("bean", { file: "bean.obj", facing: "+z", up: "+y" }, { files: ["a.bvh"] }));

const steps: Command[] = [
  renameProject("bean 2"),
  turnMesh("-x", "+z"),
  setPoint("p1", { name: "crown" }),
  pairPoint("p2", "joint_4", { joint_4: "left hand", joint_5: "right hand" }),
  replaceExample({ ...start.examples[0], joints: { joint_9: [0, 0, 0] } }, { joint_9: "hips" }),
  addPoint({ id: "p3", name: "foot", position: [0, 0, 0], joint: null }),
  setSettings({ volume: 2.5 }),
  pairMirror("p1", "p2"),
  setPin({ id: "n1", point: "p1", frame: 4, kind: "place", position: [0, 2, 0] }),
  setContacts("p2", [[0, 9]]),
  setFlights([[9, 12]]),
  removePoint("p1"),
  setMotion({ files: ["b.asf", "b.amc"] }),
  removeExample("e1"),
  setMesh({ file: "cow.obj", facing: "+z", up: "+y" }),
];

it("undo as often as there were steps gives the start, redo the end, exactly", () => {
  const store = new DocumentStore(start);
  const seen = [start, ...steps.map((step) => (store.apply(step), store.document))];
  expect(new Set(seen).size).toBe(steps.length + 1);
  const snapshots = seen.map((document) => structuredClone(document));
  for (let n = steps.length - 1; n >= 0; n--) {
    store.undo();
    expect(store.document).toBe(seen[n]);
  }
  expect(store.canUndo).toBe(false);
  for (let n = 1; n <= steps.length; n++) {
    store.redo();
    expect(store.document).toBe(seen[n]);
  }
  expect(store.canRedo).toBe(false);
  expect(seen).toEqual(snapshots); // no command wrote into a document
});

it("roles are kept of the joints that are named, and go with them", () => {
  const paired = pairPoint("p2", "joint_4", { joint_4: "left hand", joint_5: "right hand" })(start);
  expect(paired.joints).toEqual({ joint_4: "left hand" });
  expect(pairPoint("p2", "joint_4", { joint_4: "left hand" })(paired)).toBe(paired);
  const pose = { ...start.examples[0], id: "e2", joints: { joint_5: [0, 0, 0], joint_6: [1, 0, 0] } } as const;
  expect(addExample(pose, { joint_5: "right hand" })(paired).joints).toEqual({ joint_4: "left hand", joint_5: "right hand" });
  expect(pairPoint("p2", null)(paired)).not.toHaveProperty("joints");
  expect(setMesh({ file: "cow.obj", facing: "+z", up: "+y" })(paired)).not.toHaveProperty("joints");
  expect(pairPoint("p2", "lhand")(start)).not.toHaveProperty("joints");
});

it("documents share what did not change", () => {
  const next = setPoint("p1", { name: "crown" })(start);
  expect(next.points[1]).toBe(start.points[1]);
  expect(next.examples).toBe(start.examples);
});

it("one gesture is one step", () => {
  const store = new DocumentStore(start);
  const drag = Symbol();
  for (let n = 1; n <= 40; n++) store.apply(setSettings({ volume: n / 20 }), drag);
  store.apply(setSettings({ smoothness: 1 }), Symbol());
  store.undo();
  expect(store.document.settings).toEqual({ ...start.settings, volume: 2 });
  store.undo();
  expect(store.document).toBe(start);
});

it("a gesture that goes on after an undo is a new step", () => {
  const store = new DocumentStore(start);
  const drag = Symbol();
  store.apply(setSettings({ volume: 2 }), drag);
  store.undo();
  store.apply(setSettings({ volume: 3 }), drag);
  store.undo();
  expect(store.document).toBe(start);
});

it("a cancelled gesture leaves no trace", () => {
  const store = new DocumentStore(start);
  store.apply(renameProject("other"));
  store.undo();
  const drag = Symbol();
  store.apply(setSettings({ volume: 2 }), drag);
  store.apply(setSettings({ volume: 3 }), drag);
  store.cancel(drag);
  expect(store.document).toBe(start);
  expect(store.canUndo).toBe(false);
  store.redo();
  expect(store.document.name).toBe("other");
  store.cancel(drag);
  expect(store.document.name).toBe("other");
});

it("what changes nothing is no step", () => {
  const store = new DocumentStore(start);
  let calls = 0;
  store.subscribe(() => calls++);
  const nothing = [
    renameProject("bean"),
    setPoint("p1", { name: "top" }),
    setPoint("nobody", { name: "x" }),
    pairPoint("p1", "head"),
    removePoint("nobody"),
    removeExample("nobody"),
    setSettings({ volume: 1 }),
    addPoint({ ...start.points[0], name: "again" }),
    turnMesh("+z", "+y"),
  ];
  for (const command of nothing) store.apply(command);
  store.undo();
  store.redo();
  expect(store.document).toBe(start);
  expect(store.canUndo).toBe(false);
  expect(calls).toBe(0);
});

it("a removed point leaves the examples too", () => {
  expect(removePoint("p1")(start).examples[0].points).toEqual({ p2: [2, 0, 0] });
});

it("another model forgets places on the old one; turning keeps them", () => {
  expect(setMesh({ file: "cow.obj", facing: "+z", up: "+y" })(start)).toMatchObject({ points: [], examples: [] });
  expect(turnMesh("-z", "+y")(start).points).toBe(start.points);
});

it("listeners hear each change once, with what was before, until they end it", () => {
  const store = new DocumentStore(start);
  const heard: [string, string][] = [];
  const end = store.subscribe((document, previous) => heard.push([previous.name, document.name]));
  store.apply(renameProject("a"));
  store.undo();
  store.redo();
  store.replace(start);
  end();
  store.apply(renameProject("b"));
  expect(heard).toEqual([
    ["bean", "a"],
    ["a", "bean"],
    ["bean", "a"],
    ["a", "bean"],
  ]);
});

it("another project cannot be undone into the old one", () => {
  const store = new DocumentStore(start);
  store.apply(renameProject("a"));
  store.replace(start);
  expect([store.canUndo, store.canRedo]).toEqual([false, false]);
});

it("a free id is one that nobody has", () => {
  expect(freeId(start.points, "p")).toBe("p3");
  expect(freeId(removePoint("p1")(start).points, "p")).toBe("p3");
});

it("pins replace each other at one frame, runs that touch become one, and a point that goes is forgotten everywhere", () => {
  const pin = { id: "n1", point: "p1", frame: 4, kind: "place", position: [0, 2, 0] } as const;
  const commands = [
    pairMirror("p1", "p2"),
    setPin(pin),
    setPin({ ...pin, id: "n2", position: [0, 3, 0] }),
    setPin({ id: "n3", point: "p2", frame: 2, kind: "still" }),
    setContacts("p1", [
      [5, 9],
      [0, 5],
      [20, 30],
    ]),
    setContacts("p2", []),
    setFlights([[10, 20]]),
  ];
  const said = commands.reduce((document, command) => command(document), start);
  expect(said.points.map(({ mirror }) => mirror)).toEqual(["p2", "p1"]);
  expect(clipOf(said)).toEqual({
    pins: [
      { id: "n3", point: "p2", frame: 2, kind: "still" },
      { ...pin, id: "n2", position: [0, 3, 0] },
    ],
    contacts: {
      p1: [
        [0, 9],
        [20, 30],
      ],
      p2: [],
    },
    flights: [[10, 20]],
  });
  expect(clipOf({ ...said, motion: { files: ["other.bvh"] } })).toEqual({});
  expect(clipOf({ ...said, motion: { files: ["folder/a.bvh"] } })).toBe(clipOf(said));
  const gone = removePoint("p1")(said);
  expect(gone.points).toEqual([start.points[1]]);
  expect(clipOf(gone)).toEqual({ pins: [{ id: "n3", point: "p2", frame: 2, kind: "still" }], contacts: { p2: [] }, flights: [[10, 20]] });
  const motions = [setContacts("p2", null), setFlights(null), removePin("n3")].reduce((document, command) => command(document), gone);
  expect(clipOf(motions)).toEqual({ pins: [], contacts: {} });
  expect(removePin("n3")(motions)).toBe(motions);
  expect(
    merged([
      [3, 4],
      [1, 1],
      [4, 6],
    ]),
  ).toEqual([[3, 6]]);
});

it("what is said of a motion is found by the file that moves, whichever way round its skeleton is named", () => {
  const clips = { "m.amc": { mirror: true } };
  for (const files of [["s.asf", "m.amc"], ["m.amc", "s.asf"], ["a/m.amc"]])
    expect(clipOf({ motion: { files }, clips })).toEqual({ mirror: true });
});
