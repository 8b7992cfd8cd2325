import type { FileKind, FilesPort } from "../app/ports";

const ACCEPT: Readonly<Record<FileKind, string>> = {
  any: ".glb,.gltf,.bin,.obj,.mtl,.ply,.stl,.off,.png,.jpg,.jpeg,.webp,.bvh,.asf,.amc,.rigless,.zip,.json",
  model: ".glb,.gltf,.bin,.obj,.mtl,.ply,.stl,.off,.png,.jpg,.jpeg,.webp",
  motion: ".bvh,.asf,.amc",
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
