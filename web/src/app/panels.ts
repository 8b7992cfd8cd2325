export const PANELS = [
  { id: "model", name: "Model" },
  { id: "motion", name: "Motion" },
  { id: "points", name: "Points" },
  { id: "poses", name: "Poses" },
] as const;

export type PanelName = (typeof PANELS)[number]["id"];
