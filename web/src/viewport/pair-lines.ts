// Lines under the marks: one per pair, the one that follows the pointer, the lead from where a dot was to the hand.

import { arcPath, type Point } from "./arc";

const SVG = "http://www.w3.org/2000/svg";

export interface PairLine {
  from: Point;
  to: Point;
  colour: string;
  kind: "pair" | "live";
}

export class PairLines {
  readonly element = document.createElementNS(SVG, "svg");
  private readonly paths: [SVGPathElement, SVGPathElement][] = [];
  private readonly lead = document.createElementNS(SVG, "line");
  private readonly probe = document.createElementNS(SVG, "circle");

  constructor() {
    this.element.setAttribute("aria-hidden", "true");
    this.lead.setAttribute("class", "lead");
    this.probe.setAttribute("class", "probe");
    this.probe.setAttribute("r", "5");
    this.element.append(this.lead, this.probe);
    this.setLead(null, null);
    this.setProbe(null);
  }

  /** Each line is drawn twice: a paper casing, then its colour. */
  setLines(lines: readonly PairLine[]): void {
    while (this.paths.length < lines.length) {
      const pair: [SVGPathElement, SVGPathElement] = [document.createElementNS(SVG, "path"), document.createElementNS(SVG, "path")];
      this.element.append(...pair);
      this.paths.push(pair);
    }
    this.paths.forEach(([casing, stroke], i) => {
      const line = lines[i];
      casing.style.display = stroke.style.display = line ? "" : "none";
      if (!line) return;
      const d = arcPath(line.from, line.to);
      casing.setAttribute("class", "casing");
      stroke.setAttribute("class", line.kind === "live" ? "pair live" : "pair");
      stroke.style.stroke = line.colour;
      casing.setAttribute("d", d);
      stroke.setAttribute("d", d);
    });
  }

  setLead(from: Point | null, to: Point | null): void {
    this.lead.style.display = from && to ? "" : "none";
    if (!from || !to) return;
    const set = (name: string, value: number): void => this.lead.setAttribute(name, value.toFixed(1));
    set("x1", from.x);
    set("y1", from.y);
    set("x2", to.x);
    set("y2", to.y);
  }

  /** A small pencil ring: what a click would pick. */
  setProbe(at: Point | null): void {
    this.probe.style.display = at ? "" : "none";
    if (!at) return;
    this.probe.setAttribute("cx", at.x.toFixed(1));
    this.probe.setAttribute("cy", at.y.toFixed(1));
  }
}
