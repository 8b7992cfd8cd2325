import { createRequire } from "node:module";
import { expect, it } from "vitest";

import { ModelError } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { laidOn, TRIANGLE, triangle } from "../support/gltf";

interface Encoder {
  SetEncodingMethod(method: number): void;
  EncodeMeshToDracoBuffer(mesh: unknown, out: unknown): number;
}
interface Encoding {
  Encoder: new () => Encoder;
  MeshBuilder: new () => {
    AddFacesToMesh(mesh: unknown, faces: number, index: Uint32Array): void;
    AddFloatAttributeToMesh(mesh: unknown, kind: number, count: number, width: number, values: Float32Array): number;
  };
  Mesh: new () => unknown;
  DracoInt8Array: new () => { GetValue(at: number): number };
  POSITION: number;
  TEX_COORD: number;
  MESH_SEQUENTIAL_ENCODING: number;
}
const { createEncoderModule } = createRequire(import.meta.url)("draco3dgltf") as {
  createEncoderModule(options: object): Promise<Encoding>;
};

/** A triangle with a place in the picture, as Draco packs it. */
async function packed() {
  const draco = await createEncoderModule({});
  const [encoder, builder, mesh, out] = [new draco.Encoder(), new draco.MeshBuilder(), new draco.Mesh(), new draco.DracoInt8Array()];
  builder.AddFacesToMesh(mesh, 1, Uint32Array.of(0, 1, 2));
  const POSITION = builder.AddFloatAttributeToMesh(mesh, draco.POSITION, 3, 3, Float32Array.from(TRIANGLE));
  const TEXCOORD_0 = builder.AddFloatAttributeToMesh(mesh, draco.TEX_COORD, 3, 2, Float32Array.of(0, 0, 1, 0, 0, 1));
  encoder.SetEncodingMethod(draco.MESH_SEQUENTIAL_ENCODING);
  const size = encoder.EncodeMeshToDracoBuffer(mesh, out);
  const bytes = Uint8Array.from({ length: size }, (_, i) => out.GetValue(i));

  const { maker, primitive } = triangle();
  const accessors = maker.packer.json().accessors!;
  accessors.length = 0;
  accessors.push({ componentType: 5126, count: 3, type: "VEC3" }, { componentType: 5126, count: 3, type: "VEC2" });
  primitive.attributes = { POSITION: 0, TEXCOORD_0: 1 };
  primitive.extensions = {
    KHR_draco_mesh_compression: { bufferView: maker.packer.view(bytes), attributes: { POSITION, TEXCOORD_0 } },
    VENDOR_x: {},
  };
  maker.json.extensionsUsed = ["KHR_draco_mesh_compression"];
  maker.json.extensionsRequired = ["KHR_draco_mesh_compression"];
  return { maker, bytes };
}

it("opens what is packed by Draco, and nothing of the packing is left", async () => {
  const model = await readModel([(await packed()).maker.glb()]);
  expect([...model.positions]).toEqual(TRIANGLE.map((x) => expect.closeTo(x, 3)));
  expect(laidOn(model, "TEXCOORD_0", 2)).toEqual([0, 0, 1, 0, 0, 1].map((x) => expect.closeTo(x, 3)));
  const { json } = model.document;
  expect([json.extensionsUsed, json.extensionsRequired]).toEqual([undefined, undefined]);
  expect(json.meshes![0].primitives[0].extensions).toEqual({ VENDOR_x: {} });
});

it("says that what Draco cannot unpack is broken", async () => {
  const { maker, bytes } = await packed();
  bytes.fill(255, 12);
  await expect(readModel([maker.glb()])).rejects.toThrow(
    new ModelError("t.glb is a broken glTF file: what is packed in mesh 0 cannot be unpacked."),
  );
});
