// Checks a value against a JSON Schema (draft 2020-12), the keywords that project-schema.json uses, and says what is wrong in
// plain words. A general validator would compile code, which a strict content-security-policy forbids, and speak of schemas.

export interface Schema {
  readonly type?: string | readonly string[];
  readonly const?: unknown;
  readonly enum?: readonly unknown[];
  readonly required?: readonly string[];
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly additionalProperties?: boolean | Schema;
  readonly items?: Schema;
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly minLength?: number;
  readonly minimum?: number;
  readonly maximum?: number;
  readonly default?: unknown;
  readonly $ref?: string;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

/** Every keyword that this file interprets; a schema with another one would be checked by half. */
export const KEYWORDS = [
  "type",
  "const",
  "enum",
  "required",
  "properties",
  "additionalProperties",
  "items",
  "minItems",
  "maxItems",
  "minLength",
  "minimum",
  "maximum",
  "default",
  "anyOf", // at the root, where the version chooses
  "$ref",
  "$defs",
  "$schema",
  "title",
] as const;

type Json = Readonly<Record<string, unknown>>;

/** What is wrong with a value at a path, or null: "settings.volume should be a number from 0 to 3, but it is 9." */
export function findFault(value: unknown, schema: Schema, root: Schema, path = ""): string | null {
  const rule = resolve(schema, root);
  if (!fits(value, rule)) return `${path || "It"} should be ${wanted(rule, root)}, but it is ${actual(value)}.`;
  if (Array.isArray(value)) return listFault(value, rule, root, path);
  if (isObject(value)) return objectFault(value, rule, root, path);
  return null;
}

/** A copy of a faultless value with the schema's defaults where it says nothing. */
export function withDefaults(value: unknown, schema: Schema, root: Schema): unknown {
  const rule = resolve(schema, root);
  if (!isObject(value) || !rule.properties) return value;
  const known = Object.entries(rule.properties);
  return Object.fromEntries(
    known.flatMap(([key, inner]) => {
      const own = Object.hasOwn(value, key) ? value[key] : resolve(inner, root).default;
      return own === undefined ? [] : [[key, withDefaults(own, inner, root)] as const];
    }),
  );
}

function resolve(schema: Schema, root: Schema): Schema {
  if (schema.$ref === undefined) return schema;
  const { $ref, ...beside } = schema;
  const target = root.$defs?.[$ref.replace("#/$defs/", "")];
  if (!target) throw new Error(`The schema has no ${$ref}.`);
  return { ...resolve(target, root), ...beside };
}

/** The value itself, without what it holds. */
function fits(value: unknown, rule: Schema): boolean {
  if ("const" in rule) return value === rule.const;
  if (rule.enum) return rule.enum.includes(value);
  const types = rule.type === undefined ? [] : [rule.type].flat();
  if (types.length > 0 && !types.some((type) => isOf(value, type))) return false;
  if (typeof value === "number") return value >= (rule.minimum ?? -Infinity) && value <= (rule.maximum ?? Infinity);
  if (typeof value === "string") return value.length >= (rule.minLength ?? 0);
  return true;
}

function isOf(value: unknown, type: string): boolean {
  switch (type) {
    case "null":
      return value === null;
    case "array":
      return Array.isArray(value);
    case "object":
      return isObject(value);
    case "integer":
      return Number.isInteger(value);
    case "number":
      return Number.isFinite(value);
    default:
      return typeof value === type;
  }
}

function isObject(value: unknown): value is Json {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A list of fixed length is told as one thing: "three numbers, but its second is null". */
function listFault(list: readonly unknown[], rule: Schema, root: Schema, path: string): string | null {
  const { items, minItems = 0, maxItems = Infinity } = rule;
  if (list.length < minItems || list.length > maxItems) return `${path} should be ${wanted(rule, root)}, but it has ${list.length}.`;
  if (!items) return null;
  const inner = resolve(items, root);
  for (const [k, item] of list.entries()) {
    if (minItems === maxItems && !fits(item, inner)) {
      return `${path} should be ${wanted(rule, root)}, but its ${ORDINALS[k] ?? `number ${k + 1}`} is ${actual(item)}.`;
    }
    const fault = findFault(item, items, root, `${path}[${k}]`);
    if (fault) return fault;
  }
  return null;
}

function objectFault(object: Json, rule: Schema, root: Schema, path: string): string | null {
  const missing = rule.required?.find((key) => !Object.hasOwn(object, key));
  if (missing !== undefined) return `${member(path, missing)} is missing.`;
  for (const [key, value] of Object.entries(object)) {
    const known = rule.properties && Object.hasOwn(rule.properties, key) ? rule.properties[key] : rule.additionalProperties;
    const where = member(path, key);
    if (known === false) return `${where} is not a field that Rigless knows.`;
    const fault = typeof known === "object" ? findFault(value, known, root, where) : null;
    if (fault) return fault;
  }
  return null;
}

const ORDINALS = ["first", "second", "third", "fourth"];
const NOUNS: Readonly<Record<string, string>> = { number: "numbers", integer: "whole numbers", string: "texts", array: "lists" };
const NUMBERS = ["no", "one", "two", "three", "four"];

/** "three numbers", "a number from 0 to 3", "+x, -x, +y, -y, +z or -z" */
function wanted(rule: Schema, root: Schema): string {
  if ("const" in rule) return actual(rule.const);
  if (rule.enum) return `${rule.enum.slice(0, -1).join(", ")} or ${String(rule.enum.at(-1))}`;
  return [rule.type ?? []]
    .flat()
    .map((type) => wantedType(type, rule, root))
    .join(" or ");
}

function wantedType(type: string, rule: Schema, root: Schema): string {
  const { minimum, maximum, minItems, maxItems, minLength } = rule;
  switch (type) {
    case "number":
    case "integer": {
      const noun = type === "integer" ? "a whole number" : "a number";
      return minimum === undefined ? noun : `${noun} from ${minimum} to ${maximum}`;
    }
    case "string":
      return minLength ? "a text that is not empty" : "a text";
    case "array": {
      const inner = rule.items ? resolve(rule.items, root) : {};
      const noun = NOUNS[String(inner.type)] ?? "objects";
      if (minItems !== undefined && minItems === maxItems) return `${NUMBERS[minItems] ?? minItems} ${noun}`;
      return minItems ? `a list of ${minItems} to ${maxItems} ${noun}` : `a list of ${noun}`;
    }
    case "boolean":
      return "true or false";
    case "object":
      return "an object";
    default:
      return type;
  }
}

function actual(value: unknown): string {
  if (typeof value === "string") return value.length > 40 ? `a text of ${value.length} letters` : JSON.stringify(value);
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (isObject(value)) return "an object";
  return String(value);
}

/** points.top, points["left hand"] */
function member(path: string, key: string): string {
  if (!/^[\w$-]+$/.test(key)) return `${path}[${JSON.stringify(key.slice(0, 60))}]`;
  return path ? `${path}.${key}` : key;
}
