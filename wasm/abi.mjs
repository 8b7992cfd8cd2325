// node wasm/abi.mjs [FOLDER]: writes what TypeScript knows of the boundary, web/src/engine/abi.ts and web/src/util/constants.ts,
// from abi.h, the exported functions and the core's own enums and constants; into FOLDER instead of web/src if one is named.
// Prints the number by which a module and its TypeScript know that they were made from the same description.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const read = (path) => readFileSync(join(root, path), "utf8");
const code = (text) => text.replace(/\/\/.*/g, "");

function only(found, what) {
  if (found.length !== 1) throw new Error(`abi.mjs: ${what} is told ${found.length} times, not once`);
  return found[0];
}

// ---- what the C++ says

const core = readdirSync(join(root, "include/rigless"), { recursive: true })
  .filter((file) => file.endsWith(".h"))
  .map((file) => code(read(join("include/rigless", file))))
  .join("\n");

function enumerators(name) {
  const body = only([...core.matchAll(new RegExp(`enum class ${name}\\b[^{;]*\\{([^}]*)\\}`, "g"))], `enum ${name}`)[1];
  return body
    .split(",")
    .map((part) => part.trim())
    .filter((part) => part !== "")
    .map((part, n) => {
      const [, one, number] = /^(\w+)(?: = (\d+))?$/.exec(part) ?? [];
      if (one === undefined || Number(number ?? n) !== n) throw new Error(`abi.mjs: ${name} does not count from 0 one by one: ${part}`);
      return one;
    });
}

/** A number, or another constant. */
function constant(name) {
  const said = only([...core.matchAll(new RegExp(`inline constexpr \\w+ ${name} = ([^;]+);`, "g"))], `constant ${name}`)[1];
  return Number.isNaN(Number(said)) ? constant(said) : Number(said);
}

const doubles = (type) => (type === "Vector" ? 3 : 1);

function describe() {
  const text = read("wasm/abi.h");
  const enums = [...text.matchAll(/^using (\w+) = rigless::(\w+);$/gm)].map(([, name, of]) => ({ name, names: enumerators(of) }));
  const constants = [...text.matchAll(/^inline constexpr double (\w+) = rigless::(?:detail::)?(\w+);(?: +\/\/ (.*))?$/gm)].map(
    ([, name, of, comment = ""]) => ({ name, comment, value: constant(of) }),
  );
  const structs = [...text.matchAll(/((?:^\/\/ .*\n)*)^struct (\w+) \{\n([^}]*)^\};$/gm)]
    .filter(([, , , body]) => !body.includes("double value;") && !body.includes("template"))
    .map(([, comment, name, body]) => ({
      name,
      comment: comment
        .replace(/^\/\/ /gm, "")
        .trim()
        .replaceAll("\n", " "),
      fields: body
        .trim()
        .split("\n")
        .map((line) => field(name, line.trim())),
    }));
  const functions = ["surface", "motion", "performance", "memory", "shape_analysis", "solid", "skin"].flatMap((file) => exported(`wasm/${file}.cpp`));
  return { enums, constants, structs, functions };
}

function field(struct, line) {
  const [, type, name, comment = ""] = /^(Number|Flag|Vector|NameOf<\w+>) (\w+);(?: +\/\/ (.*))?$/.exec(line) ?? [];
  if (name === undefined) throw new Error(`abi.mjs: ${struct} has a line that is no field: ${line}`);
  return { name, type, comment };
}

function exported(path) {
  const text = read(path);
  const found = [...code(text).matchAll(/RIGLESS_EXPORT\s+([\w:]+(?: [\w:]+)*[\s*]+?)(\w+)\(([^)]*)\)\s*\{/g)];
  if (found.length !== code(text).split("RIGLESS_EXPORT").length - 1)
    throw new Error(`abi.mjs: ${path} exports a function that cannot be read`);
  return found.map(([, type, name, parameters]) => ({
    path,
    name,
    type: type.trim(),
    parameters: parameters
      .split(",")
      .map((one) => one.trim())
      .filter(Boolean)
      .map((one) => {
        const [, parameterType, parameter] = /^(.*?)(\w+)$/s.exec(one);
        return { name: parameter, type: parameterType.trim() };
      }),
  }));
}

// ---- the same in TypeScript

const description = describe();
const said = JSON.stringify(description, (key, value) => (key === "comment" ? undefined : value));
const hash = (createHash("sha256").update(said).digest().readUInt32LE() >>> 2) + 2 ** 30;

const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const lower = (name) => name[0].toLowerCase() + name.slice(1);
const upper = (name) => name.replace(/(?<=[a-z])(?=[A-Z])/g, "_").toUpperCase();

const SCALARS = { void: "void", double: "number", float: "number", "std::int32_t": "number", "std::uint8_t": "number" };
const ARRAYS = { float: "Float32Array", double: "Float64Array", "std::int32_t": "Integers", "std::uint8_t": "Uint8Array", char: "Uint8Array", void: "void" };

function typeOf(type) {
  const [, pointed] = /^(?:const )?([\w:]+)\*$/.exec(type.replaceAll(" *", "*")) ?? [];
  if (pointed !== undefined) {
    const to = ARRAYS[pointed] ?? description.structs.find(({ name }) => name === pointed)?.name;
    if (to === undefined) throw new Error(`abi.mjs: ${type} cannot cross the boundary`);
    return to === "void" ? "Pointer" : `Pointer<${to}>`;
  }
  if (type === "ObjectHandle") return "Handle";
  if (type === "PackedStatus") return type;
  if (SCALARS[type] === undefined) throw new Error(`abi.mjs: ${type} cannot cross the boundary`);
  return SCALARS[type];
}

function fieldType(type) {
  if (type === "Vector") return "[number, number, number]";
  return { Number: "number", Flag: "boolean" }[type] ?? type.slice("NameOf<".length, -1);
}

function decode(type, at) {
  if (type === "Vector") return `[n[${at}], n[${at + 1}], n[${at + 2}]]`;
  if (type === "Flag") return `n[${at}] !== 0`;
  return type === "Number" ? `n[${at}]` : `${upper(type.slice("NameOf<".length, -1))}_NAMES[n[${at}]]`;
}

function encode(type, value) {
  if (type === "Vector") return `...${value}`;
  if (type === "Flag") return `Number(${value})`;
  return type === "Number" ? value : `${upper(type.slice("NameOf<".length, -1))}_NAMES.indexOf(${value})`;
}

/** Whether a function takes it, and so TypeScript writes it; the others are answers. */
const asked = (name) => description.functions.some(({ parameters }) => parameters.some(({ type }) => type === `const ${name}*`));

/** A comment of abi.h. */
const doc = (said, indent = "") => (said ? `${indent}/** ${said[0].toUpperCase()}${said.slice(1).replace(/\.?$/, ".")} */\n` : "");

/** As the formatter wants it: in one line if that is short enough. */
const fitting = (...texts) => texts.find((text) => text.split("\n").every((line) => line.length <= 140));

function askedText({ name, fields }) {
  const values = fields.map(({ name: field, type }) => encode(type, `one.${camel(field)}`));
  const head = `export const write${name} = (one: ${name}): number[] => [`;
  return fitting(`${head}${values.join(", ")}];`, `${head}\n${values.map((value) => `  ${value},\n`).join("")}];`);
}

function rowText({ name, fields }) {
  let at = 0;
  const parts = fields.map(({ name: field, type }) => {
    const part = `${camel(field)}: ${decode(type, at)}`;
    at += doubles(type);
    return part;
  });
  const head = `export const ${lower(name)}Row: Row<${name}> = {`;
  const line = `({ ${parts.join(", ")} })`;
  const lines = `({\n${parts.map((part) => `    ${part},\n`).join("")}  })`;
  return fitting(
    `${head} doubles: ${at}, read: (n) => ${line} };`,
    ...[line, lines].map((read) => `${head}\n  doubles: ${at},\n  read: (n) => ${read},\n};`),
  );
}

function structText(struct) {
  const { name, comment, fields } = struct;
  const members = fields.flatMap(({ name: field, type, comment: said }) => [`${doc(said, "  ")}  ${camel(field)}: ${fieldType(type)};`]);
  const text = ["export interface " + name + " {", ...members, "}", "", asked(name) ? askedText(struct) : rowText(struct), ""].join("\n");
  return doc(comment) + text;
}

function functionText({ name, type, parameters }) {
  const said = parameters.map((one) => `${camel(one.name)}: ${typeOf(one.type)}`);
  const lines = said.map((one) => `    ${one},\n`).join("");
  return fitting(`  ${name}(${said.join(", ")}): ${typeOf(type)};`, `  ${name}(\n${lines}  ): ${typeOf(type)};`);
}

function moduleText(name, paths) {
  const functions = description.functions.filter(({ path }) => paths.includes(path)).map(functionText);
  return [`export interface ${name} {`, "  memory: WebAssembly.Memory;", "  _initialize(): void;", ...functions, "}", ""].join("\n");
}

function enumText({ name, names }) {
  const head = `export const ${upper(name)}_NAMES = [`;
  const strings = names.map((one) => `"${one}"`);
  const list = fitting(`${head}${strings.join(", ")}] as const;`, `${head}\n${strings.map((one) => `  ${one},\n`).join("")}] as const;`);
  return `${list}\nexport type ${name} = (typeof ${upper(name)}_NAMES)[number];\n`;
}

const note = (what) => `// ${what} Made by wasm/abi.mjs from wasm/abi.h: change that.\n`;

/** The enums that structs are written and read with: their types, and the names where a field is decoded or encoded. */
const told = description.enums.filter(({ name }) => description.structs.some(({ fields }) => fields.some(({ type }) => type === `NameOf<${name}>`)));
const imported = told.flatMap(({ name }) => [`${upper(name)}_NAMES`, `type ${name}`]);
const names = fitting(
  `import { ${imported.join(", ")} } from "../util/constants";\n`,
  `import {\n${imported.map((one) => `  ${one},\n`).join("")}} from "../util/constants";\n`,
);

const memory = "wasm/memory.cpp";
const abi = [
  note("The boundary to the core."),
  names,
  `/** A module that answers another number to abi() was built from another description. */\nexport const ABI = ${hash};\n`,
  `/** 0: ok; otherwise error * 2^32 + where. */
export type PackedStatus = number;
/** Index and generation; 0 is none. */
export type Handle = number;
export type Integers = Int32Array | Uint32Array;

declare const pointed: unique symbol;
/** Where the core keeps something. */
export type Pointer<T = unknown> = number & { readonly [pointed]?: T };

/** How a struct is read from its doubles. */
export interface Row<T> {
  doubles: number;
  read(n: Float64Array): T;
}
`,
  ...description.structs.map(structText),
  moduleText("RiglessExports", [memory, "wasm/surface.cpp", "wasm/motion.cpp", "wasm/performance.cpp"]),
  moduleText("ShapeAnalysisExports", [memory, "wasm/shape_analysis.cpp", "wasm/solid.cpp"]),
  moduleText("SkinExports", [memory, "wasm/skin.cpp"]),
].join("\n");
const constants = [
  note("Numbers and names that the core knows too."),
  ...description.constants.map(({ name, comment, value }) => `${doc(comment)}export const ${name.toUpperCase()} = ${value};\n`),
  ...description.enums.map(enumText),
].join("\n");

function write(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  if (!existsSync(path) || readFileSync(path, "utf8") !== text) writeFileSync(path, text);
}

const folder = process.argv[2] ?? join(root, "web/src");
write(join(folder, "engine/abi.ts"), abi);
write(join(folder, "util/constants.ts"), constants);
console.log(hash);
