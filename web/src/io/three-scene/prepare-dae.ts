// What the loader of COLLADA believes is checked before it, and what it does not know is put in words that it does.

import { ModelError } from "../named-file";
import { checkInstances } from "./check-instances";
import { type XmlDocument, XmlElement } from "./xml";

/** Errors (ModelError): no COLLADA; nodes that hold themselves; more corners than indices. */
export function prepareCollada(name: string, document: XmlDocument): void {
  const root = document.documentElement;
  if (root.nodeName !== "COLLADA") throw new ModelError(`${name} holds no COLLADA scene.`);
  checkNodes(name, root);
  for (const counts of root.getElementsByTagName("vcount")) checkCounts(name, counts);
  if (!root.children.some(({ nodeName }) => nodeName === "asset")) root.append(new XmlElement("asset", {}));
  addScene(root);
  dropDangling(root);
  for (const unit of root.getElementsByTagName("unit")) {
    const meters = Number(unit.getAttribute("meter") ?? 1);
    unit.setAttribute("meter", String(meters > 0 && Number.isFinite(meters) ? meters : 1));
  }
  for (const kind of ["tristrips", "trifans"]) {
    for (const element of root.getElementsByTagName(kind)) toTriangles(element, kind === "tristrips");
  }
}

/** A file without one shows the first that it has. */
function addScene(root: XmlElement): void {
  if (root.children.some(({ nodeName }) => nodeName === "scene")) return;
  const id = root.getElementsByTagName("visual_scene")[0]?.getAttribute("id");
  const scene = new XmlElement("scene", {});
  if (id) scene.append(new XmlElement("instance_visual_scene", { url: `#${id}` }));
  root.append(scene);
}

/** What names something that is not there: the loader would end by it. */
function dropDangling(root: XmlElement): void {
  const ids = new Set<string>();
  const naming: XmlElement[] = [];
  root.visit((element) => {
    const id = element.getAttribute("id");
    if (id !== null) ids.add(id);
    if (element.nodeName.startsWith("instance_")) naming.push(element);
  });
  for (const element of naming) {
    const target = element.getAttribute("url") ?? element.getAttribute("target") ?? "";
    if (target.startsWith("#") && !ids.has(target.slice(1))) element.remove();
  }
}

/** Nodes may hold each other by name. */
function checkNodes(name: string, root: XmlElement): void {
  const holds = root.getElementsByTagName("node").flatMap((node) => {
    const id = node.getAttribute("id");
    const inside = node.getElementsByTagName("instance_node").map((instance) => (instance.getAttribute("url") ?? "").slice(1));
    return id && inside.length > 0 ? [[id, inside] as const] : [];
  });
  checkInstances(name, new Map(holds));
}

/** Polygons and weights: each corner takes a digit and a blank of the indices at least. */
function checkCounts(name: string, counts: XmlElement): void {
  const indices = counts.parentElement?.children.filter(({ nodeName }) => nodeName === "p" || nodeName === "v") ?? [];
  const room = indices.reduce((sum, { textContent }) => sum + textContent.length + 1, 0);
  let corners = 0;
  for (const word of counts.textContent.split(/\s+/)) corners += Number(word) > 0 ? Number(word) : 0;
  if (2 * corners <= room) return;
  throw new ModelError(`${name} promises ${corners.toLocaleString("en-US")} corners, more than it holds.`);
}

/** Strips and fans, which the loader leaves out, become the triangles that they are. */
function toTriangles(element: XmlElement, strips: boolean): void {
  const inputs = element.children.filter(({ nodeName }) => nodeName === "input");
  const stride = 1 + Math.max(...inputs.map((input) => Number(input.getAttribute("offset")) || 0));
  const out: string[] = [];
  for (const row of element.children.filter(({ nodeName }) => nodeName === "p")) {
    const words = row.textContent.trim().split(/\s+/);
    const corner = (k: number): string[] => words.slice(k * stride, (k + 1) * stride);
    for (let k = 2; (k + 1) * stride <= words.length; k++) {
      const [a, b] = strips ? (k % 2 === 0 ? [k - 2, k - 1] : [k - 1, k - 2]) : [0, k - 1];
      out.push(...corner(a), ...corner(b), ...corner(k));
    }
  }
  const indices = new XmlElement("p", {});
  indices.text = out.join(" ");
  const material = element.getAttribute("material");
  const triangles = new XmlElement("triangles", { count: String(out.length / (3 * stride)), ...(material !== null && { material }) });
  for (const child of [...inputs, indices]) triangles.append(child);
  const siblings = element.parentElement?.children ?? [];
  siblings[siblings.indexOf(element)] = triangles;
}
