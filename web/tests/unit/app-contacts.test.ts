import { expect, test } from "vitest";
import { Contacts } from "../../src/app/contacts";
import { runsOf } from "../../src/app/runs";
import { FLIGHTS } from "../../src/app/selection";
import { dancingContext } from "./app-support";

test("rows come from the motion until somebody says otherwise, and go back to it", async () => {
  const { context } = await dancingContext();
  const contacts = new Contacts(context);
  const points = context.document.points.length;
  const rows = contacts.rows;
  const edge = rows.find(({ id }) => id === "left-edge");
  expect(edge?.runs).toEqual(runsOf(context.performance!, 4, points));
  expect(edge).toMatchObject({ name: "Left edge", number: 5, edited: false });
  expect(rows.map(({ id }) => id)).not.toContain("top");
  context.selection.select("top");
  expect(contacts.rows.map(({ id }) => id)).toContain("top");

  const gesture = Symbol("run");
  contacts.say("left-edge", [[2, 5]], gesture);
  contacts.say("left-edge", [[2, 6]], gesture);
  expect(contacts.rows.find(({ id }) => id === "left-edge")).toMatchObject({ runs: [[2, 6]], edited: true });
  context.history.undo();
  expect(contacts.rows.find(({ id }) => id === "left-edge")).toEqual(edge);
  context.history.redo();
  contacts.reset("left-edge");
  expect(contacts.rows.find(({ id }) => id === "left-edge")).toEqual(edge);
});

test("flights are a row of their own", async () => {
  const { context } = await dancingContext();
  const contacts = new Contacts(context);
  contacts.say(FLIGHTS, [[3, 9]]);
  expect(contacts.rows.at(-1)).toEqual({ id: FLIGHTS, name: "In the air", number: null, runs: [[3, 9]], edited: true });
  contacts.reset(FLIGHTS);
  expect(contacts.rows.find(({ id }) => id === FLIGHTS)?.edited ?? false).toBe(false);
});
