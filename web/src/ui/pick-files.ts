const ACCEPT = {
  any: ".glb,.gltf,.bin,.obj,.mtl,.ply,.stl,.off,.png,.jpg,.jpeg,.webp,.bvh,.asf,.amc,.rigless,.zip,.json",
  model: ".glb,.gltf,.bin,.obj,.mtl,.ply,.stl,.off,.png,.jpg,.jpeg,.webp",
  motion: ".bvh,.asf,.amc",
} as const;

export type FileKind = keyof typeof ACCEPT;

/** Asks for files; none if the person thinks better of it. */
export function pickFiles(kind: FileKind): Promise<File[]> {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  input.accept = ACCEPT[kind];
  return new Promise((resolve) => {
    input.addEventListener("change", () => resolve([...(input.files ?? [])]));
    input.addEventListener("cancel", () => resolve([]));
    input.click();
  });
}

/** Offers bytes as a download. */
export function download(name: string, bytes: Uint8Array<ArrayBuffer>, type: string): void {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
