// MTL, an OBJ's materials, as those of glTF.

import type { GltfMaterial, GltfSampler } from "../gltf/document";
import { linear } from "./color";
import { isNormalMap } from "./picture";
import type { PictureShelf } from "./picture-shelf";

/** Materials by name. */
export function readMtl(text: string, shelf: PictureShelf): Map<string, GltfMaterial> {
  const blocks = new Map<string, Statement[]>();
  let block: Statement[] = [];
  for (const line of text.split(/\r\n|\r|\n/)) {
    const [, key, value] = /^\s*(\S+)(.*)$/.exec(line) ?? [];
    if (key === undefined || value === undefined || key.startsWith("#")) continue;
    if (key === "newmtl") blocks.set(value.trim(), (block = []));
    else block.push({ key: key.toLowerCase(), value: value.trim() });
  }
  return new Map([...blocks].map(([name, statements]) => [name, materialOf(name, statements, shelf)]));
}

interface Statement {
  readonly key: string;
  readonly value: string;
}

function materialOf(name: string, statements: readonly Statement[], shelf: PictureShelf): GltfMaterial {
  const value = (...keys: string[]): string | undefined => statements.find(({ key }) => keys.includes(key))?.value;
  const numbers = (...keys: string[]): number[] => {
    const found = (value(...keys) ?? "").split(/\s+/).map(Number);
    return found.every(Number.isFinite) && value(...keys) ? found : [];
  };
  const picture = (...keys: string[]): MtlPicture | null => pictureIn(value(...keys));
  const textureOf = (map: MtlPicture | null) => map && shelf.texture(map.name, map.sampler, map.frame);

  const map = picture("map_kd");
  const kd = numbers("kd");
  const dissolve = numbers("d")[0] ?? (numbers("tr").length ? 1 - numbers("tr")[0] : 1);
  // A body that cannot be seen is a mistake of its writer: some take d for Tr.
  const alpha = dissolve > 0 && dissolve < 1 ? dissolve : 1;
  // Beside a picture the colour is what the writer happened to have, .8 or black.
  const color = !map && kd.length === 3 ? kd.map((c) => linear(Math.min(Math.max(c, 0), 1))) : [1, 1, 1];
  const emitted = numbers("ke").map((c) => linear(Math.min(Math.max(c, 0), 1)));
  const emissiveMap = textureOf(picture("map_ke"));
  const specularMap = textureOf(picture("map_ks"));
  const normalMap = textureOf(normalIn(picture("norm", "map_kn")) ?? normalIn(picture("map_bump", "bump"), true));
  const baseColorTexture = textureOf(map);
  const cutOut = alpha < 1 ? "BLEND" : map && picture("map_d")?.name === map.name ? "MASK" : null;
  const rough = numbers("pr")[0] ?? (numbers("ns").length ? 1 - Math.sqrt(Math.min(Math.max(numbers("ns")[0], 0), 1000) / 1000) : 1);
  return {
    name,
    pbrMetallicRoughness: {
      ...((color.some((c) => c !== 1) || alpha < 1) && { baseColorFactor: [...color, alpha] }),
      ...(baseColorTexture && { baseColorTexture }),
      metallicFactor: Math.min(Math.max(numbers("pm")[0] ?? 0, 0), 1),
      roughnessFactor: Math.min(Math.max(rough, 0), 1),
    },
    ...(normalMap && { normalTexture: normalMap }),
    ...(emissiveMap && { emissiveTexture: emissiveMap, emissiveFactor: [1, 1, 1] }),
    ...(!emissiveMap && emitted.length === 3 && emitted.some((c) => c > 0) && { emissiveFactor: emitted }),
    ...(cutOut && { alphaMode: cutOut }),
    doubleSided: true, // nobody knows how the faces are wound
    ...(specularMap && { extensions: { KHR_materials_specular: { specularColorTexture: specularMap } } }),
  };
}

interface MtlPicture {
  readonly name: string;
  readonly sampler: GltfSampler | null;
  readonly frame: { readonly offset: readonly [number, number]; readonly scale: readonly [number, number] } | null;
}

/** Numbers that may stand behind an option; -texres and those not listed have one word. */
const OPTIONS: Readonly<Record<string, number>> = { "-o": 3, "-s": 3, "-t": 3, "-mm": 2 };

/** Options such as "-s 1 1 1" stand before the name, which may hold blanks. */
function pictureIn(value: string | undefined): MtlPicture | null {
  const words = value?.split(/\s+/) ?? [];
  const options = new Map<string, string[]>();
  let at = 0;
  while (/^-[a-z]/i.test(words[at] ?? "") && at + 1 < words.length) {
    const option = words[at++].toLowerCase();
    const given: string[] = [];
    const most = OPTIONS[option] ?? 1;
    while (given.length < most && at + 1 < words.length && (most === 1 || Number.isFinite(Number(words[at])))) given.push(words[at++]);
    options.set(option, given);
  }
  const name = words.slice(at).join(" ");
  if (name === "") return null;
  const [su, sv] = [0, 1].map((k) => Number(options.get("-s")?.[k] ?? 1));
  const [ou, ov] = [0, 1].map((k) => Number(options.get("-o")?.[k] ?? 0));
  const moved = su !== 1 || sv !== 1 || ou !== 0 || ov !== 0;
  return {
    name,
    sampler: options.get("-clamp")?.[0] === "on" ? { wrapS: 33071, wrapT: 33071 } : null,
    frame: moved ? { offset: [ou, 1 - sv - ov], scale: [su, sv] } : null, // v is turned down
  };
}

/** A bump map is a height map by its letter, and a normal map where its name says so. */
function normalIn(map: MtlPicture | null, bump = false): MtlPicture | null {
  return map && (!bump || isNormalMap(map.name)) ? map : null;
}
