import { describe, expect, test } from "vitest";
import { QualityGovernor } from "../../src/viewport/quality";

function run(waits: readonly number[]): number {
  const governor = new QualityGovernor();
  return waits.filter((wait) => governor.note(wait)).length;
}

describe("quality", () => {
  test("a machine that keeps up keeps everything", () => {
    const governor = new QualityGovernor();
    for (let i = 0; i < 600; i++) expect(governor.note(17)).toBe(false);
    expect(governor.quality).toEqual({ shadowMap: 1024, blurSamples: 12, maxPixelRatio: 2 });
  });

  test("a program that plays a graphics card begins without the sun's shadow", () => {
    expect(new QualityGovernor("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)))").quality.shadowMap).toBe(0);
    expect(new QualityGovernor("ANGLE (Intel, Mesa Intel(R) UHD Graphics 620)").quality.shadowMap).toBe(1024);
  });

  test("one long pause, as while a file is read, changes nothing", () => {
    expect(run([17, 17, 17, 17, 2000, 17, 17, 17, 17, 2000, 17, 17, 17])).toBe(0);
  });

  test("slow first frames are shaders, not the machine", () => {
    expect(run([900, 900, 17, 17, 17])).toBe(0);
  });

  test("a slow machine loses the shadow, then fine pixels, and then nothing more", () => {
    const governor = new QualityGovernor();
    let lowered = 0;
    for (let i = 0; i < 100; i++) lowered += Number(governor.note(200));
    expect(lowered).toBe(3);
    expect(governor.quality).toEqual({ shadowMap: 0, blurSamples: 0, maxPixelRatio: 1 });
  });

  test("where two frames take a second, the shadow goes at once", () => {
    const governor = new QualityGovernor();
    for (let i = 0; i < 4; i++) governor.note(500);
    expect(governor.quality.shadowMap).toBe(0);
    expect(governor.quality.maxPixelRatio).toBe(2);
  });
});
