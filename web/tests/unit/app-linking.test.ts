import { deflateSync } from "fflate";
import { expect, test } from "vitest";
import type { LinkState } from "../../src/app/linking";
import type { Session } from "../../src/app/session";
import * as commands from "../../src/document/commands";
import { TETRAHEDRON } from "../support/files";
import { dancingSession, file, said, TestShelf, testPorts } from "./app-support";

const PAGE = "https://rigless.example/";

async function linkOf(session: Session): Promise<LinkState> {
  await session.saving.openExport();
  const { exporting } = session.saving;
  exporting?.choose("link");
  await exporting?.link.make(PAGE);
  return exporting?.link.state ?? { kind: "making" };
}

async function addressOf(session: Session): Promise<string> {
  const state = await linkOf(session);
  if (state.kind !== "made") throw new Error(`no link: ${JSON.stringify(state)}`);
  return state.address;
}

async function opened(address: string, shelf = new TestShelf()) {
  const ports = { ...testPorts(shelf) };
  let link = address.slice(PAGE.length + 1);
  Object.assign(ports, {
    address: {
      get link() {
        return link;
      },
      forget: () => (link = ""),
    },
  });
  const { session } = await dancingSession(ports);
  return { session, ports, left: () => link };
}

test("a project of a character of ours opens from its link as it was", async () => {
  const { session } = await dancingSession();
  session.settings.rename("Spiky");
  session.history.apply(commands.setSettings({ energy: 0.4 }));
  session.player.seek(7);
  session.poses.add();
  session.player.seek(19);
  session.poses.add();
  session.history.apply(commands.removeExample(session.document.examples[1].id));
  const address = await addressOf(session);
  expect(address.length).toBeLessThan(1500);

  const { session: theirs, left } = await opened(address);
  expect(theirs.document).toEqual(session.document);
  expect(theirs.selection.intro).toBe(false);
  expect(said(theirs.context)).toEqual(["Spiky came with a link."]);
  expect(theirs.context.notices.all[0].text).toContain("Make it yours");
  expect(theirs.performance?.frames).toBe(30);
  expect(theirs.keeping).toBeNull();
  expect(left()).not.toBe("");
  theirs.settings.rename("Mine"); // with the first change it is
  expect(left()).toBe("");
  await expect.poll(() => theirs.keeping?.present).not.toBeNull();
});

test("poses are told by clip and frame: without their joints the link is shorter", async () => {
  const { session } = await dancingSession();
  session.player.seek(7);
  session.poses.add();
  const named = await addressOf(session);
  const { examples } = session.document;
  const last = examples.at(-1)!;
  const moved = { ...last, joints: { ...last.joints, Hips: [0.25, 0, 0] as const } };
  session.history.apply(commands.replaceExample(moved));
  const told = await addressOf(session);
  expect(told.length).toBeGreaterThan(named.length + 500);
  expect((await opened(told)).session.document).toEqual(session.document);
});

test("a link wins over what is kept, which stays kept", async () => {
  const { session } = await dancingSession();
  session.settings.rename("Sent");
  const address = await addressOf(session);
  const shelf = new TestShelf();
  const { session: own } = await dancingSession(testPorts(shelf));
  own.settings.rename("Own");
  await own.keeping?.flush();
  shelf.claims.clear();
  const { session: theirs } = await opened(address, shelf);
  expect(theirs.document.name).toBe("Sent");
  theirs.settings.rename("Sent on");
  await expect.poll(() => [...shelf.kept.values()].map(({ name }) => name).sort()).toEqual(["Own", "Sent on"]);
});

test("an own model has none, and neither has what is too long", async () => {
  const { session } = await dancingSession();
  for (let frame = 0; frame < 30; frame++) {
    session.player.seek(frame);
    session.poses.add();
  }
  expect(await linkOf(session)).toEqual({ kind: "none", why: expect.stringMatching(/so many poses .* [5-9],\d{3} characters/) });
  await session.opening.files([file("tetra.obj", TETRAHEDRON)]);
  expect(await linkOf(session)).toEqual({ kind: "none", why: expect.stringContaining("this model is your own") });
});

const packed = (json: string): string => Buffer.from(deflateSync(new TextEncoder().encode(json))).toString("base64url");

test.each([
  ["dance=", /missing/],
  ["dance=abc", /missing/],
  [`dance=${packed("{}")}`, /missing/],
  [`dance=${packed('[2,"cactus",null]')}`, /newer/],
  [`dance=${packed('[1,"unicorn",null]')}`, /character/],
  [`dance=${packed('[1,"cactus",5]')}`, /missing/],
  [`dance=${packed('[1,"cactus",[{"settings":[{"volume":9}]}]]')}`, /settings\.volume/],
  [`dance=${packed('[1,"cactus",[{"motion":[{"files":["../secret.bvh"]}]}]]')}`, /motion that is not here/],
])("%s is refused, and the cactus dances", async (link, why) => {
  const { session } = await opened(`${PAGE}#${link}`);
  expect(session.document.name).toBe("Cactus");
  expect(said(session.context)).toEqual(["This link cannot be opened."]);
  expect(session.context.notices.all[0].text).toMatch(why);
});

test("another word behind the # is no link", async () => {
  const { session } = await opened(`${PAGE}#help`);
  expect(said(session.context)).toEqual([]);
  expect(session.document.name).toBe("Cactus");
});
