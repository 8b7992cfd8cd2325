import type { FileKind, FilesPort } from "../app/ports";

const MODEL = ["model", "picture", "part"] as const;
const MOTION = ["motion", "skeleton"] as const;
const SONG = ["song"] as const;
const KINDS = { any: [...MODEL, ...MOTION, ...SONG, "project", "archive"], model: MODEL, motion: MOTION, song: SONG } as const;

export const files: FilesPort = {
  async pick(kind: FileKind) {
    const { accepted } = await import("../io/formats");
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.accept = accepted(KINDS[kind]);
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
