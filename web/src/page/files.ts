import type { FileKind, FilesPort } from "../app/ports";
import { accepted } from "../io/formats";

const MODEL = ["model", "picture", "part"] as const;
const MOTION = ["motion", "skeleton"] as const;

const ACCEPT: Readonly<Record<FileKind, string>> = {
  any: accepted([...MODEL, ...MOTION, "project", "archive"]),
  model: accepted(MODEL),
  motion: accepted(MOTION),
};

export const files: FilesPort = {
  pick(kind) {
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.accept = ACCEPT[kind];
    return new Promise((resolve) => {
      input.addEventListener("change", () => resolve([...(input.files ?? [])]));
      input.addEventListener("cancel", () => resolve([]));
      input.click();
    });
  },

  download(name, bytes, type) {
    const url = URL.createObjectURL(new Blob([bytes], { type }));
    const link = document.createElement("a");
    link.href = url;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  },
};
