// Small files of the formats that three.js's loaders read, written by hand: a tetrahedron, a quarter of its own kind in each.

import { strToU8, zipSync, zlibSync } from "fflate";

import type { NamedFile } from "../../src/io/named-file";

/** One value of a binary FBX's node. */
type Value = number | bigint | string | { readonly letter: "d" | "i" | "l"; readonly items: readonly number[]; readonly packed?: boolean };

export interface FbxNode {
  readonly name: string;
  readonly values?: readonly Value[];
  readonly nodes?: readonly FbxNode[];
}

const CORNERS = [0, 0, 0, 100, 0, 0, 0, 100, 0, 0, 0, 100];
/** The last index of a polygon is turned over. */
const LOOPS = [0, 2, -2, 0, 1, -4, 0, 3, -3, 1, 2, -4];

/** A mesh on a node of some scale, with a material; what is given beside them. */
export function fbxScene({ objects = [], links = [], unit = 1, up = 1, mesh = true }: FbxOptions = {}): FbxNode[] {
  const own: FbxNode[] = mesh
    ? [
        {
          name: "Geometry",
          values: [10n, "Tetra\u0000\u0001Geometry", "Mesh"],
          nodes: [
            { name: "Vertices", values: [{ letter: "d", items: CORNERS, packed: true }] },
            { name: "PolygonVertexIndex", values: [{ letter: "i", items: LOOPS }] },
          ],
        },
        {
          name: "Model",
          values: [20n, "Head\u0000\u0001Model", "Mesh"],
          nodes: properties([["Lcl Translation", "Lcl Translation", 0, 50, 0]]),
        },
        {
          name: "Material",
          values: [30n, "Skin\u0000\u0001Material", ""],
          nodes: [{ name: "ShadingModel", values: ["phong"] }, ...properties([["DiffuseColor", "Color", 1, 0, 0]])],
        },
      ]
    : [];
  const connected = mesh ? [[10n, 20n], [20n, 0n], [30n, 20n], ...links] : links;
  return [
    {
      name: "GlobalSettings",
      nodes: properties([
        ["UpAxis", "int", up],
        ["UnitScaleFactor", "double", unit],
      ]),
    },
    { name: "Objects", nodes: [...own, ...objects] },
    {
      name: "Connections",
      nodes: connected.map(([from, to, role]) => ({
        name: "C",
        values: role === undefined ? ["OO", from as bigint, to as bigint] : ["OP", from as bigint, to as bigint, String(role)],
      })),
    },
  ];
}

interface FbxOptions {
  readonly objects?: readonly FbxNode[];
  readonly links?: readonly (readonly (bigint | string)[])[];
  readonly unit?: number;
  readonly up?: number;
  readonly mesh?: boolean;
}

function properties(rows: readonly (readonly [string, string, ...number[]])[]): FbxNode[] {
  const whole = (type: string): boolean => type === "int";
  return [
    {
      name: "Properties70",
      nodes: rows.map(([name, type, ...numbers]) => ({
        name: "P",
        values: [name, type, "", "A", ...numbers.map((x) => (whole(type) ? { letter: "i" as const, items: [x] } : x))].map((value) =>
          typeof value === "object" ? value.items[0] : value,
        ),
      })),
    },
  ];
}

export function binaryFbx(nodes: readonly FbxNode[], version = 7400): Uint8Array {
  const bytes: number[] = [...strToU8("Kaydara FBX Binary  "), 0, 0x1a, 0, ...u32(version)];
  for (const node of nodes) writeNode(bytes, node);
  bytes.push(...new Array<number>(13 + 200).fill(0)); // the footer, which is passed over
  return Uint8Array.from(bytes);
}

function writeNode(bytes: number[], { name, values = [], nodes = [] }: FbxNode): void {
  const at = bytes.length;
  bytes.push(...new Array<number>(12).fill(0), name.length, ...strToU8(name));
  const from = bytes.length;
  for (const value of values) bytes.push(...written(value));
  const size = bytes.length - from;
  for (const node of nodes) writeNode(bytes, node);
  if (nodes.length > 0) bytes.push(...new Array<number>(13).fill(0));
  bytes.splice(at, 12, ...u32(bytes.length), ...u32(values.length), ...u32(size));
}

function written(value: Value): number[] {
  if (typeof value === "bigint") return [76, ...raw(8, (view) => view.setBigInt64(0, value, true))];
  if (typeof value === "number") return [68, ...raw(8, (view) => view.setFloat64(0, value, true))];
  if (typeof value === "string") return [83, ...u32(strToU8(value).length), ...strToU8(value)];
  const { letter } = value;
  const items = value.items.flatMap((x) => {
    if (letter === "d") return raw(8, (view) => view.setFloat64(0, x, true));
    return letter === "l" ? raw(8, (view) => view.setBigInt64(0, BigInt(x), true)) : raw(4, (view) => view.setInt32(0, x, true));
  });
  const stored = value.packed ? [...zlibSync(Uint8Array.from(items))] : items;
  return [value.letter.charCodeAt(0), ...u32(value.items.length), ...u32(value.packed ? 1 : 0), ...u32(stored.length), ...stored];
}

function raw(size: number, write: (view: DataView) => void): number[] {
  const view = new DataView(new ArrayBuffer(size));
  write(view);
  return [...new Uint8Array(view.buffer)];
}

function u32(x: number): number[] {
  return raw(4, (view) => view.setUint32(0, x, true));
}

/** The same scene as text. */
export function textFbx(nodes: readonly FbxNode[], version = 7400): string {
  const line = ({ name, values = [], nodes: inside = [] }: FbxNode, indent: string): string => {
    const words = values.map((value) => {
      if (typeof value === "object") return "";
      if (typeof value !== "string") return String(value);
      const [called, kind] = value.split("\u0000\u0001");
      return kind === undefined ? `"${value}"` : `"${kind}::${called}"`;
    });
    const [array] = values.filter((value) => typeof value === "object");
    const head = `${indent}${name}: ${array ? `*${array.items.length}` : words.join(",")}`;
    const body = [...(array ? [`${indent}\ta: ${array.items.join(",")}`] : []), ...inside.map((node) => line(node, `${indent}\t`))];
    return body.length === 0 && !(array ?? inside.length) ? head : `${head} {\n${body.join("\n")}\n${indent}}`;
  };
  const header = `; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: ${version}\n}\n`;
  return header + nodes.map((node) => line(node, "")).join("\n") + "\n";
}

export function zipped(name: string, files: Readonly<Record<string, string | Uint8Array>>): NamedFile {
  const entries = Object.entries(files).map(([path, content]) => [path, typeof content === "string" ? strToU8(content) : content]);
  return { name, bytes: zipSync(Object.fromEntries(entries) as Record<string, Uint8Array>, { level: name.endsWith(".usdz") ? 0 : 6 }) };
}

const MODEL = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
const CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
const MATERIAL = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";

/** A mesh of a 3MF: a tetrahedron of this size. */
export function tetra3mf(size: number, triangle = ""): string {
  const corners = CORNERS.map((x) => (x / 100) * size);
  const vertices = [0, 1, 2, 3].map((v) => `<vertex x="${corners[3 * v]}" y="${corners[3 * v + 1]}" z="${corners[3 * v + 2]}"/>`);
  const faces = ["0 2 1", "0 1 3", "0 3 2", "1 2 3"].map((row) => {
    const [a, b, c] = row.split(" ");
    return `<triangle v1="${a}" v2="${b}" v3="${c}" ${triangle}/>`;
  });
  return `<mesh><vertices>${vertices.join("")}</vertices><triangles>${faces.join("")}</triangles></mesh>`;
}

export function threeMf(
  resources: string,
  build: string,
  more: Readonly<Record<string, string | Uint8Array>> = {},
  unit = "millimeter",
): NamedFile {
  return zipped("t.3mf", {
    "[Content_Types].xml": "<Types/>",
    "_rels/.rels": `<Relationships><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="${MODEL}"/></Relationships>`,
    ...more,
    "3D/3dmodel.model": model3mf(resources, build, unit),
  });
}

export function model3mf(resources: string, build: string, unit = "millimeter"): string {
  return `<?xml version="1.0" encoding="UTF-8"?><model unit="${unit}" xmlns="${CORE}" xmlns:p="${PRODUCTION}" xmlns:m="${MATERIAL}">
<resources>${resources}</resources><build>${build}</build></model>`;
}

/** A COLLADA file; `primitives` stand in its one mesh. */
export function dae({ asset = "", primitives = TRIANGLES, libraries = "", nodes = INSTANCE }: DaeOptions = {}): string {
  return `<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>${asset}</asset>${libraries}
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">${CORNERS.join(" ")}</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<source id="t"><float_array id="ta" count="8">0 0 1 0 0 .25 1 1</float_array>
<technique_common><accessor source="#ta" count="4" stride="2">
<param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
${primitives}</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">${nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
}

interface DaeOptions {
  readonly asset?: string;
  readonly primitives?: string;
  readonly libraries?: string;
  readonly nodes?: string;
}

const INPUTS = `<input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#t" offset="1" set="0"/>`;
const TRIANGLES = `<triangles count="4" material="m">${INPUTS}<p>0 0 2 2 1 1 0 0 1 1 3 3 0 0 3 3 2 2 1 1 2 2 3 3</p></triangles>`;
export const INSTANCE = `<node id="n" name="Body"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#mat"/></technique_common></bind_material></instance_geometry></node>`;
export const strips = (p: string): string => `<tristrips count="1" material="m">${INPUTS}<p>${p}</p></tristrips>`;
export const polygons = (vcount: string, p: string): string =>
  `<polylist count="1" material="m">${INPUTS}<vcount>${vcount}</vcount><p>${p}</p></polylist>`;

/** A Lambert material with a picture. */
export const painted = (picture: string): string =>
  `<library_images><image id="i"><init_from>${picture}</init_from></image></library_images>
<library_materials><material id="mat" name="Fur"><instance_effect url="#e"/></material></library_materials>
<library_effects><effect id="e"><profile_COMMON><newparam sid="sf"><surface type="2D"><init_from>i</init_from></surface></newparam>
<newparam sid="sm"><sampler2D><source>sf</source></sampler2D></newparam>
<technique sid="c"><lambert><diffuse>
<texture texture="sm" texcoord="UV"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>`;

/** A USD scene as text: a tetrahedron with a picture. */
export const usda = (header = 'upAxis = "Y"', points = "[(0,0,0),(1,0,0),(0,1,0),(0,0,1)]", counts = "[3,3,3,3]"): string => `#usda 1.0
(
    defaultPrim = "Root"
    metersPerUnit = 1
    ${header}
)

def Xform "Root"
{
    def Mesh "Body"
    {
        uniform bool doubleSided = 1
        int[] faceVertexCounts = ${counts}
        int[] faceVertexIndices = [0,2,1, 0,1,3, 0,3,2, 1,2,3]
        rel material:binding = </Root/Fur>
        point3f[] points = ${points}
        texCoord2f[] primvars:st = [(0,0),(1,0),(0,.25),(1,1)] (
            interpolation = "vertex"
        )
    }

    def Material "Fur"
    {
        token outputs:surface.connect = </Root/Fur/Surface.outputs:surface>

        def Shader "Surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor.connect = </Root/Fur/Picture.outputs:rgb>
            float inputs:roughness = 0.3
            float inputs:metallic = 0.2
            token outputs:surface
        }

        def Shader "Picture"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @tex/fur.png@
            float2 inputs:st.connect = </Root/Fur/Place.outputs:result>
            float3 outputs:rgb
        }

        def Shader "Place"
        {
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }
    }
}
`;
