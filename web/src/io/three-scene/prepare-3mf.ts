// The parts of a 3MF as its loader reads them, one XML after the other: each numbers its objects for itself, which the loader takes
// for one count, so that the same object would come again and again.

import { checkInstances } from "./check-instances";
import type { XmlDocument, XmlElement } from "./xml";

export class ThreeMfParts {
  /** Of the root model. */
  unit = "millimeter";
  /** Paths of parts to come: the loader takes the root model last. */
  private readonly coming: string[];
  private readonly holds = new Map<string, readonly string[]>();

  /** `paths`: all that the archive holds, in its order. */
  constructor(
    private readonly name: string,
    paths: readonly string[],
  ) {
    const root = paths.filter((path) => /^3D\/[^/]*\.model$/.test(path)).at(-1) ?? "";
    this.coming = [...paths.filter((path) => /^3D\/.*\/[^/]*\.model$/.test(path)), root];
  }

  /** Errors (ModelError): objects that hold themselves, or too many copies. */
  prepare(document: XmlDocument): void {
    const model = document.documentElement;
    if (model.nodeName !== "model") return;
    const path = `/${this.coming.shift() ?? ""}`;
    this.unit = model.getAttribute("unit") ?? this.unit;
    const called = (element: XmlElement): string => {
      const id = element.getAttribute("objectid") ?? "";
      return `${element.getAttributeNS("", "path") ?? path} ${id}`;
    };
    for (const object of model.getElementsByTagName("object")) {
      const inside = object.getElementsByTagName("component");
      for (const component of inside) component.setAttribute("objectid", called(component));
      object.setAttribute("id", `${path} ${object.getAttribute("id") ?? ""}`);
      if (inside.length > 0)
        this.holds.set(
          object.getAttribute("id") ?? "",
          inside.map((component) => component.getAttribute("objectid") ?? ""),
        );
    }
    const items = model.getElementsByTagName("item");
    for (const item of items) item.setAttribute("objectid", called(item));
    if (items.length > 0)
      this.holds.set(
        "the build",
        items.map((item) => item.getAttribute("objectid") ?? ""),
      );
    checkInstances(this.name, this.holds);
  }
}
