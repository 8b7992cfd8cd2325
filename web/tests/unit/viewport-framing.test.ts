import { describe, expect, test } from "vitest";
import { arcControls, arcPath, arcPoint } from "../../src/viewport/arc";
import {
  ELEVATION,
  frame,
  freeRectangle,
  lanes,
  NEAREST,
  pixelsPerMetre,
  TARGET_HEIGHT,
  turned,
  type View,
} from "../../src/viewport/framing";

const content = { width: 2.7, height: 1.75, depth: 1 };
const desktop: View = { width: 1280, height: 456, insets: { left: 104, top: 80, right: 288, bottom: 48 } };
const phone: View = { width: 390, height: 350, insets: { left: 8, top: 72, right: 8, bottom: 40 } };

/** Where a point above the target's spot on the ground lands, in pixels from the top: the same camera, worked out independently. */
function screenY(view: View, metresUp: number): number {
  const { distance, shiftY } = frame(view, content);
  const eye = { y: TARGET_HEIGHT + distance * Math.sin(ELEVATION), z: distance * Math.cos(ELEVATION) };
  const down = eye.y - metresUp;
  const depth = eye.z * Math.cos(ELEVATION) + down * Math.sin(ELEVATION);
  const below = down * Math.cos(ELEVATION) - eye.z * Math.sin(ELEVATION);
  return view.height / 2 + shiftY + below * pixelsPerMetre(view.height, depth);
}

describe("framing", () => {
  test.each([
    ["desktop", desktop],
    ["phone", phone],
  ])("%s: feet at 85 %% of the free height, heads inside it", (_, view) => {
    const free = freeRectangle(view);
    expect(screenY(view, 0)).toBeCloseTo(free.y + 0.85 * free.height, 1);
    expect(screenY(view, content.height)).toBeGreaterThan(free.y);
  });

  test.each([
    ["desktop", desktop],
    ["phone", phone],
  ])("%s: both figures fit between the sides of the free rectangle, in its middle", (_, view) => {
    const free = freeRectangle(view);
    const { distance, shiftX } = frame(view, content);
    expect(content.width * pixelsPerMetre(view.height, distance - content.depth / 2)).toBeLessThanOrEqual(0.92 * free.width + 1e-6);
    expect(view.width / 2 + shiftX).toBeCloseTo(free.x + free.width / 2, 6);
  });

  test("an open stage is seen from 5.2 m", () => {
    const view = { width: 1280, height: 456, insets: { left: 0, top: 0, right: 0, bottom: 0 } };
    expect(frame(view, content).distance).toBe(NEAREST);
  });

  test("from its side a box is as wide as it was deep, and between two views wider than either", () => {
    const aside = turned(content, Math.PI / 2);
    expect(aside.width).toBeCloseTo(content.depth, 9);
    expect(aside.depth).toBeCloseTo(content.width, 9);
    expect(turned(content, -0.3).width).toBeGreaterThan(content.width);
    expect(turned(content, Math.PI).width).toBeCloseTo(content.width, 9);
  });

  test("figures that walk apart make the camera step back", () => {
    expect(frame(desktop, { ...content, width: 6 }).distance).toBeGreaterThan(frame(desktop, content).distance);
  });

  test("cards that cover nearly everything are ignored", () => {
    expect(freeRectangle({ width: 400, height: 300, insets: { left: 200, top: 0, right: 180, bottom: 0 } })).toEqual({
      x: 0,
      y: 0,
      width: 400,
      height: 300,
    });
  });

  test("lanes do not touch and are centred together", () => {
    const { human, model, width } = lanes(1.3, 2.4);
    expect(model - human).toBeGreaterThan((1.3 + 2.4) / 2);
    expect(human - 1.3 / 2).toBeCloseTo(-width / 2, 9);
    expect(model + 2.4 / 2).toBeCloseTo(width / 2, 9);
  });
});

describe("pair lines", () => {
  const a = { x: 100, y: 200 };
  const b = { x: 340, y: 260 };

  test("begin and end on their dots", () => {
    expect(arcPoint(a, b, 0)).toEqual(a);
    expect(arcPoint(a, b, 1)).toEqual(b);
    expect(arcPath(a, b)).toMatch(/^M100\.0 200\.0C.* 340\.0 260\.0$/);
  });

  test("rise over the chord by a sixth of its width, never more than 64 px", () => {
    expect((a.y + b.y) / 2 - arcPoint(a, b, 0.5).y).toBeCloseTo(40, 6);
    const far = { x: 2000, y: 200 };
    expect(200 - arcPoint(a, far, 0.5).y).toBeCloseTo(64, 6);
  });

  test("a vertical line stays straight", () => {
    for (const control of arcControls(a, { x: 100, y: 400 })) expect(control.x).toBe(100);
    expect(arcPoint(a, { x: 100, y: 400 }, 0.5)).toEqual({ x: 100, y: 300 });
  });
});
