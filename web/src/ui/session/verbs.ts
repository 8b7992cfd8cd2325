export const VERBS = [
  { id: "model", name: "Model" },
  { id: "motion", name: "Motion" },
  { id: "points", name: "Points" },
  { id: "poses", name: "Poses" },
] as const;

export type Verb = (typeof VERBS)[number]["id"];
