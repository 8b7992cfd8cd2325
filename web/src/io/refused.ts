// Files that people have models or motions in and that Rigless does not read, each with the way from there.

import { wordList } from "./format";
import { listed } from "./formats";
import { baseName, extension } from "./named-file";

interface Refused {
  readonly extensions: readonly string[];
  /** What such a file is. */
  readonly is: string;
  /** What to do with it. */
  readonly way: string;
}

const REFUSED: readonly Refused[] = [
  { extensions: ["blend"], is: "a Blender file", way: "In Blender choose File > Export > glTF 2.0, and drop the .glb." },
  { extensions: ["max"], is: "a 3ds Max file", way: "In 3ds Max choose File > Export, and save it as FBX." },
  { extensions: ["ma", "mb"], is: "a Maya file", way: "In Maya choose File > Export All, and save it as FBX." },
  { extensions: ["c4d"], is: "a Cinema 4D file", way: "In Cinema 4D choose File > Export > FBX." },
  { extensions: ["skp"], is: "a SketchUp file", way: "In SketchUp choose File > Export > 3D Model, and save it as DAE or GLB." },
  { extensions: ["ztl", "zpr"], is: "a ZBrush file", way: "In ZBrush choose ZPlugin > FBX ExportImport." },
  { extensions: ["bbmodel"], is: "a Blockbench file", way: "In Blockbench choose File > Export > Export glTF Model." },
  { extensions: ["vox"], is: "a voxel model", way: "In MagicaVoxel choose Export > ply or obj." },
  { extensions: ["pmx", "pmd"], is: "a MikuMikuDance model", way: "Open it in Blender with MMD Tools, and save it as glTF 2.0 (.glb)." },
  {
    extensions: ["abc", "3ds", "lwo", "x3d", "wrl", "x", "ms3d", "md2", "mdl", "dxf"],
    is: "a model of a format that we do not read",
    way: "Open it in Blender, where need be with an add-on, and save it as glTF 2.0 (.glb).",
  },
  {
    extensions: ["step", "stp", "iges", "igs", "sldprt", "sldasm", "f3d", "f3z", "ipt", "catpart", "x_t", "3dm", "dwg", "fcstd"],
    is: "a CAD file: surfaces without a mesh",
    way: "Export it from your CAD program as a mesh: 3MF, OBJ or STL.",
  },
  {
    extensions: ["splat", "ksplat", "spz", "sog"],
    is: "a cloud of Gaussian splats without a surface",
    way: "Make a mesh of it in the program that it comes from, and save that as GLB.",
  },
  {
    extensions: ["las", "laz", "e57", "pcd", "xyz", "pts"],
    is: "a cloud of points without a surface",
    way: "Make a mesh of it, in MeshLab or CloudCompare for example, and save that as PLY.",
  },
  {
    extensions: ["c3d", "trc", "tak", "trb"],
    is: "the path of markers, without a skeleton",
    way: "Open it in Mokka, OpenSim or your capture program, solve a skeleton for it, and save that as BVH or FBX.",
  },
  {
    extensions: ["npz", "npy", "pkl"],
    is: "a motion as arrays of numbers, as SMPL and AMASS have them",
    way: "Open it in Blender with the SMPL-X add-on, and save it as FBX or BVH.",
  },
  {
    extensions: ["mp4", "mov", "avi", "webm", "mkv", "gif"],
    is: "a film",
    way: "Have a program for motion capture from films make a BVH or an FBX of it.",
  },
  {
    extensions: ["vmd"],
    is: "a MikuMikuDance motion",
    way: "Open it in Blender with MMD Tools, on its model, and save it as glTF 2.0 (.glb).",
  },
  { extensions: ["anim"], is: "a motion of Unity or Maya", way: "Save it with its skeleton as FBX." },
  { extensions: ["unitypackage", "prefab"], is: "a Unity package", way: "Drop the FBX or GLB that it was made of." },
  { extensions: ["uasset", "umap"], is: "an Unreal asset", way: "In Unreal choose Asset Actions > Export, and save it as GLB or FBX." },
  { extensions: ["rar", "7z", "tar", "gz"], is: "an archive that we do not open", way: "Unpack it, and drop what was in it." },
];

/** The sentence for a file that is nothing that Rigless opens. */
export function refusal(path: string): string {
  const known = REFUSED.find(({ extensions }) => extensions.includes(extension(path)));
  if (known) return `${baseName(path)} is ${known.is}. ${known.way}`;
  return `${baseName(path)} is nothing that Rigless opens. Models: ${listed("model")}. Motions: ${listed("motion")}.`;
}

/** That of a model that was asked for by name. */
export function noModel(paths: readonly string[]): string {
  const [first] = paths;
  if (paths.length === 1 && REFUSED.some(({ extensions }) => extensions.includes(extension(first)))) return refusal(first);
  return `${wordList(paths.map(baseName), "and") || "Nothing"} is not a model that we read (${listed("model")}).`;
}
