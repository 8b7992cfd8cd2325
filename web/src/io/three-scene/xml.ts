// As much of a DOM as three.js's loaders of COLLADA and 3MF ask for, over saxes. Neither a worker nor Node has one, and a whole
// DOM takes 14 seconds and 800 MB for a 3MF of 200,000 triangles, this one 1.5 seconds and 200 MB.

import { SaxesParser } from "saxes";

import { CUT_SHORT, ModelError } from "../named-file";

/** Loaders walk by recursion. */
const DEEPEST = 500;

export class XmlElement {
  readonly nodeType = 1;
  readonly children: XmlElement[] = [];
  parentElement: XmlElement | null = null;
  /** Of this element alone. */
  text = "";

  constructor(
    readonly nodeName: string,
    private readonly values: Record<string, string>,
  ) {}

  append(child: XmlElement): void {
    child.parentElement = this;
    this.children.push(child);
  }

  /** Without text: loaders pass it over. */
  get childNodes(): readonly XmlElement[] {
    return this.children;
  }

  remove(): void {
    const siblings = this.parentElement?.children ?? [];
    const at = siblings.indexOf(this);
    if (at >= 0) siblings.splice(at, 1);
  }

  /** All below this one, in the order of the file. */
  visit(each: (element: XmlElement) => void): void {
    for (const child of this.children) {
      each(child);
      child.visit(each);
    }
  }

  get attributes(): { name: string; value: string }[] {
    return Object.entries(this.values).map(([name, value]) => ({ name, value }));
  }

  get textContent(): string {
    return this.children.length === 0 ? this.text : this.text + this.children.map((child) => child.textContent).join("");
  }

  getAttribute(name: string): string | null {
    return this.values[name] ?? null;
  }

  setAttribute(name: string, value: string): void {
    this.values[name] = value;
  }

  hasAttribute(name: string): boolean {
    return this.values[name] !== undefined;
  }

  /** By its name without prefix: two namespaces of one file do not share names. */
  getAttributeNS(_namespace: string, name: string): string | null {
    return Object.entries(this.values).find(([key]) => localName(key) === name)?.[1] ?? null;
  }

  getElementsByTagName(name: string): XmlElement[] {
    return this.inside((element) => element.nodeName === name);
  }

  getElementsByTagNameNS(_namespace: string, name: string): XmlElement[] {
    return this.inside((element) => localName(element.nodeName) === name);
  }

  querySelector(selector: string): XmlElement | null {
    return this.querySelectorAll(selector)[0] ?? null;
  }

  /** "name", "ancestor name" or '[attribute="value"]'. */
  querySelectorAll(selector: string): XmlElement[] {
    const [, key, value] = /^\[(\w+)="(.*)"\]$/.exec(selector) ?? [];
    if (key !== undefined) return this.inside((element) => element.values[key] === value);
    const names = selector.split(" ");
    const last = names.at(-1);
    return this.inside((element) => localName(element.nodeName) === last && element.stands(names.slice(0, -1)));
  }

  /** Whether elements of these names stand around it, the last one nearest. */
  private stands(names: readonly string[]): boolean {
    let missing = names.length;
    for (let above = this.parentElement; above && missing > 0; above = above.parentElement) {
      if (localName(above.nodeName) === names[missing - 1]) missing--;
    }
    return missing === 0;
  }

  private inside(is: (element: XmlElement) => boolean): XmlElement[] {
    const found: XmlElement[] = [];
    this.visit((element) => {
      if (is(element)) found.push(element);
    });
    return found;
  }
}

/** Of no element's kind: it holds the root. */
export class XmlDocument extends XmlElement {
  constructor(readonly documentElement: XmlElement) {
    super("#document", {});
    this.children.push(documentElement);
  }
}

/** Entities that a file declares for itself are left alone. Errors (ModelError): it is no XML, with the line; too deep. */
export function parseXml(name: string, text: string): XmlDocument {
  let root: XmlElement | null = null;
  const open: XmlElement[] = [];
  const parser = new SaxesParser({ position: true, xmlns: false });
  parser.on("opentag", (tag) => {
    const element = new XmlElement(tag.name, tag.attributes);
    open.at(-1)?.append(element);
    root ??= element;
    if (open.push(element) > DEEPEST) throw new ModelError(`${name} puts more than ${DEEPEST} elements into each other.`);
  });
  parser.on("closetag", () => open.pop());
  const add = (words: string): void => {
    const element = open.at(-1);
    if (element) element.text += words;
  };
  parser.on("text", add);
  parser.on("cdata", add);
  parser.on("error", (error) => {
    throw new ModelError(
      `${name} is broken in line ${parser.line}: ${error.message.replace(/^\d+:\d+: /, "").replace(/\.$/, "")}. ${CUT_SHORT}`,
    );
  });
  parser.write(text).close();
  if (!root) throw new ModelError(`${name} holds no XML.`);
  return new XmlDocument(root);
}

function localName(name: string): string {
  return name.slice(name.indexOf(":") + 1);
}
