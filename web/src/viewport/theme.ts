// Colours of the page for the 3D stage. A probe element resolves light-dark() and var() whatever the property's registration.

import { Color } from "three";

export interface Theme {
  dark: boolean;
  stage: Color;
  grid: Color;
  gridMajor: Color;
  pencil: Color;
  pencilSoft: Color;
}

export function readTheme(host: ParentNode & Node): Theme {
  const probe = document.createElement("i");
  probe.hidden = true;
  host.append(probe);
  const read = (name: string, fallback: string): Color => {
    probe.style.color = `var(${name}, ${fallback})`;
    return new Color(getComputedStyle(probe).color);
  };
  const stage = read("--stage", "#e3ecf0");
  const theme: Theme = {
    dark: stage.getHSL({ h: 0, s: 0, l: 0 }).l < 0.5,
    stage,
    grid: read("--grid", "#bfd8e4"),
    gridMajor: read("--grid-major", "#98c1d4"),
    pencil: read("--pencil", "#166e94"),
    pencilSoft: read("--pencil-soft", "#c3e1ee"),
  };
  probe.remove();
  return theme;
}
