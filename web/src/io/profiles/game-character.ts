import { GLB_BYTES, type Profile } from "../profile";
import { skinnedBytes, writeSkinned } from "../write-skinned";

/** So many every engine takes. */
const MOST_JOINTS = 64;

/** Core glTF 2.0 as engines expect a character to be. */
export const gameCharacter: Profile = {
  id: "game",
  name: "Game character",
  words: "a skeleton of its own, for games",
  worksIn: "Blender, Unity, Unreal, Godot and on the web",
  extension: "glb",
  mostKept: null,
  mostBytes: GLB_BYTES,
  bytes: skinnedBytes,
  write: async (input, { buildSkin, ...call }) => {
    const frames = input.clips.flatMap((clip) => clip.frames.map(({ positions }) => positions));
    const skin = await buildSkin({ positions: input.rest, faces: input.faces, frames, joints: MOST_JOINTS }, call);
    const { rms, worst, normals, centres } = skin;
    return {
      bytes: writeSkinned(input, skin),
      likeness: {
        rms,
        worst,
        normals,
        joints: centres.length / 3,
        ...(skin.mix.length > 0 && { targets: skin.ways.length / input.rest.length }),
      },
    };
  },
};
