import { describe, expect, test } from "vitest";
import { Travel, Traveller } from "../../src/viewport/travel";

/** A human and a model that walk along z, the model slower, played frame by frame. */
function walking({ together = 0 } = {}) {
  const [human, model] = [new Traveller(), new Traveller()];
  human.here = model.here = true;
  const travel = new Travel([human, model], false);
  const show = (metres: number): void => {
    human.ground.set(0, metres);
    model.ground.set(0, 0.7 * metres);
    travel.aim();
    travel.follow(1 / 30, false, together);
  };
  const seen = () => ({ human: human.ground.y + human.aside.y, model: model.ground.y + model.aside.y, ground: travel.gone.y });
  return { travel, show, seen };
}

describe("a stage that travels", () => {
  test("stays with the figures while the ground goes by", () => {
    const { show, seen } = walking();
    for (let k = 0; k <= 100; k++) show(0.033 * k);
    expect(Math.abs(seen().human + seen().model) / 2).toBeLessThan(0.2); // follows softly
    expect(seen().ground).toBeGreaterThan(2);
  });

  test("a clip that begins again goes on: no figure jumps, nor does the ground", () => {
    const { travel, show, seen } = walking();
    for (let k = 0; k <= 100; k++) show(0.033 * k);
    const last = seen();
    travel.beginAgain();
    show(0);
    for (const what of ["human", "model", "ground"] as const) expect(Math.abs(seen()[what] - last[what]), what).toBeLessThan(0.1);
    expect(last.human - last.model).toBeGreaterThan(0.9);
    for (let k = 1; k <= 40; k++) show(0.033 * k);
    expect(seen().human - seen().model).toBeCloseTo(0.3 * 0.033 * 40, 1); // together again, but for this loop's own lead
    expect(seen().ground).toBeGreaterThan(last.ground + 0.8);
  });

  test("another moment of the clip is there at once", () => {
    const { show, seen } = walking();
    for (let k = 0; k <= 100; k++) show(0.033 * k);
    show(0);
    expect(seen()).toEqual({ human: 0, model: 0, ground: 0 });
  });

  test("where all stand on one spot, they do", () => {
    const { show, seen } = walking({ together: 1 });
    for (let k = 0; k <= 100; k++) show(0.033 * k);
    expect(seen().human).toBeCloseTo(seen().model, 6);
  });
});
