import { describe, expect, it } from "vitest";

import { ModelError } from "../../src/io/named-file";
import { type Model, readModel } from "../../src/io/read-model";
import { asset, fixture } from "../support/files";
import { laidOn } from "../support/gltf";

/** Places in the picture from 0 to 1: those of quantised files are brought there by KHR_texture_transform. */
function uvsOf(model: Model): number[] {
  const [{ mesh, primitive }] = model.drawn.instances;
  const material = model.document.json.materials![model.document.json.meshes![mesh].primitives[primitive].material!];
  const { extensions } = material.pbrMetallicRoughness!.baseColorTexture!;
  const { scale = [1, 1], offset = [0, 0] } = (extensions?.["KHR_texture_transform"] ?? {}) as { scale?: number[]; offset?: number[] };
  return laidOn(model, "TEXCOORD_0", 2)!.map((x, i) => x * scale[i % 2] + offset[i % 2]);
}

/** For each drawn vertex of `a`, the distance to the nearest of `b` in space and, of those there, in the picture. */
function farthest(a: Model, b: Model): { place: number; picture: number } {
  let [place, picture] = [0, 0];
  const [pa, pb, ua, ub] = [a.drawn.positions, b.drawn.positions, uvsOf(a), uvsOf(b)];
  for (let i = 0; i < pa.length / 3; i++) {
    let [d, e] = [Infinity, Infinity];
    for (let j = 0; j < pb.length / 3; j++) {
      const away = Math.hypot(pa[3 * i] - pb[3 * j], pa[3 * i + 1] - pb[3 * j + 1], pa[3 * i + 2] - pb[3 * j + 2]);
      d = Math.min(d, away);
      if (away < 1e-3) e = Math.min(e, Math.hypot(ua[2 * i] - ub[2 * j], ua[2 * i + 1] - ub[2 * j + 1]));
    }
    [place, picture] = [Math.max(place, d), Math.max(picture, e)];
  }
  return { place, picture };
}

describe("models packed by meshopt", () => {
  // Written by gltfpack 1.3: -cc, and -cz -ce khr.
  it.each(["cactus-gltfpack-ext.glb", "cactus-gltfpack-khr.glb"])("%s opens with its picture", async (name) => {
    const plain = await readModel([asset("cactus/cactus.glb")]);
    const packed = await readModel([fixture(name)]);
    expect(packed.positions).toHaveLength(plain.positions.length);
    expect(packed.faces).toHaveLength(plain.faces.length);
    expect(packed.document.images[0]?.mime).toBe("image/png");
    const { place, picture } = farthest(packed, plain);
    expect(place).toBeLessThan(2e-4);
    expect(picture).toBeLessThan(1e-3);
    expect(packed.notes).toEqual([]);
  });

  it("says that a broken one is broken", async () => {
    const { name, bytes } = fixture("cactus-gltfpack-ext.glb");
    const broken = bytes.slice();
    broken.fill(255, bytes.length - 4000);
    const error: unknown = await readModel([{ name, bytes: broken }]).catch((caught: unknown) => caught);
    expect(error).toBeInstanceOf(ModelError);
    expect((error as ModelError).message).toMatch(
      /^cactus-gltfpack-ext\.glb is a broken glTF file: what is packed in buffer view \d cannot be unpacked\.$/,
    );
  });

  it("half a mesh shown twice, once mirrored, is the same on both sides", async () => {
    const { positions } = await readModel([asset("characters/dinosaur/dinosaur.glb")]);
    const at = (v: number) => positions.subarray(3 * v, 3 * v + 3);
    const places = new Set(Array.from({ length: positions.length / 3 }, (_, v) => at(v).join()));
    expect(
      [...places].filter((place) => !places.has(place.startsWith("-") ? place.slice(1) : place.startsWith("0,") ? place : "-" + place)),
    ).toEqual([]);
  });
});
