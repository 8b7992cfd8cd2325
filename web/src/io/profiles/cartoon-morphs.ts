import { GLB_BYTES, type Profile } from "../profile";
import { morphNormals } from "../morph-normals";
import { MOST_TARGETS, morphsBytes, writeMorphs } from "../write-morphs";

/** Of the work, what finding the targets takes. */
const FINDING = 0.6;

/** Core glTF 2.0 with the fewest morph targets that hold all of the squash. */
export const cartoonMorphs: Profile = {
  id: "cartoon",
  name: "Cartoon morphs",
  words: "few morph targets that are mixed, for squash that bones cannot hold",
  worksIn: "Blender, Unity, Unreal, Godot and on the web",
  extension: "glb",
  mostKept: null,
  mostBytes: GLB_BYTES,
  bytes: morphsBytes,
  write: async (input, { buildMorphs, signal, onProgress }) => {
    const call = (from: number, to: number) => ({
      ...(signal && { signal }),
      onProgress: (done: number) => onProgress?.(from + (to - from) * done),
    });
    const frames = input.clips.flatMap((clip) => clip.frames.map(({ positions }) => positions));
    const morphs = await buildMorphs({ positions: input.rest, frames, targets: MOST_TARGETS }, call(0, FINDING));
    const { targets, off } = await morphNormals(input, morphs, call(FINDING, 1));
    const { rms, worst } = morphs;
    return { bytes: writeMorphs(input, morphs, targets), likeness: { rms, worst, normals: off, targets: targets.length } };
  },
};
