"""A dance as FBX, for Unity, Unreal and Roblox, by Blender:

    blender --background --python-exit-code 1 --python examples/blender/glb_to_fbx.py -- dance.glb dance.fbx

Joints, weights, materials and all clips go along, pictures are packed into the file.
"""

import sys

import bpy
import numpy

if not hasattr(numpy, "bool"):  # Blender 3.4 asks for a name that numpy has given up
    numpy.bool = bool

try:
    source, target = sys.argv[sys.argv.index("--") + 1 :]
except ValueError:
    sys.exit("usage: blender --background --python glb_to_fbx.py -- dance.glb dance.fbx")

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=source)
for object in bpy.data.objects:  # clips are called after their objects too; tracks keep the file's names
    for track in object.animation_data.nla_tracks if object.animation_data else []:
        for strip in track.strips:
            strip.action.name = track.name
bpy.ops.export_scene.fbx(
    filepath=target,
    add_leaf_bones=False,  # or every joint gets an end that nobody made
    bake_anim_use_nla_strips=False,
    bake_anim_use_all_actions=True,
    bake_anim_simplify_factor=0,
    path_mode="COPY",
    embed_textures=True,
)
