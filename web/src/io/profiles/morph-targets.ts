import { glbBytes, writeGlb } from "../write-glb";
import type { Profile } from "../profile";

/** Core glTF 2.0, which every viewer reads. */
export const morphTargets: Profile = {
  id: "morph",
  name: "Exact morphs",
  words: "one morph target per kept frame",
  worksIn: "Blender and on the web; engines for games take few morph targets or none",
  extension: "glb",
  // Viewers on WebGL 2 keep morph targets as layers of one texture, and 256 layers are all that the standard promises.
  mostKept: 256,
  mostBytes: 200e6,
  bytes: glbBytes,
  write: async (input) => ({ bytes: writeGlb(input), likeness: null }),
};
