"""Writes humanoid characters with Blender's exporter, rigged as other programs rig them: run by character_check.py as

    blender --background --factory-startup --python blender_characters.py -- FOLDER [CHARACTER.glb]

Of the figure of blender_layouts.py, or of a character with Mixamo's names, without its animations:

    mixamo.glb    its arms hang at rest
    numbered.glb  a sixth larger; its bones have numbers for names
    turned.glb    as numbered.glb, smaller, looking the other way, as a VRM 0.x does

names.json has each file's own name of every bone of Mixamo.
"""

import json
import math
import pathlib
import sys

import bpy
from mathutils import Matrix, Vector

from blender_check import mend_importers
from blender_layouts import figure


def plain(name):
    return name.split(":")[-1]


def base(character):
    """The armature of the figure in an empty scene, without animations."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if character:
        bpy.ops.import_scene.gltf(filepath=character)
    else:
        figure(1.0, True)
    for thing in bpy.data.objects:
        thing.animation_data_clear()
    for action in list(bpy.data.actions):
        bpy.data.actions.remove(action)
    armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
    for bone in armature.pose.bones:
        bone.matrix_basis = Matrix.Identity(4)
    return armature


def meshes_of(armature):
    return [thing for thing in bpy.data.objects if thing.type == "MESH" and thing.find_armature() == armature]


def make_active(thing, mode):
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode=mode)


def hang_arms(armature, degrees):
    """Another rest pose, of bones and meshes."""
    bpy.context.view_layer.update()
    for name, sign in (("LeftArm", 1), ("RightArm", -1)):
        bone = next(b for b in armature.pose.bones if plain(b.name) == name)
        into = armature.matrix_world
        forward = into.inverted().to_3x3() @ Vector((0, -1, 0))
        turn = Matrix.Rotation(sign * math.radians(degrees), 4, forward.normalized()).inverted()
        place = Matrix.Translation(bone.head)
        bone.matrix = place @ turn @ place.inverted() @ bone.matrix
        bpy.context.view_layer.update()
    for mesh in meshes_of(armature):
        make_active(mesh, "OBJECT")
        modifier = next(m for m in mesh.modifiers if m.type == "ARMATURE")
        bpy.ops.object.modifier_apply(modifier=modifier.name)
        mesh.modifiers.new("Skin", "ARMATURE").object = armature
    make_active(armature, "POSE")
    bpy.ops.pose.armature_apply()
    bpy.ops.object.mode_set(mode="OBJECT")


def number_bones(armature):
    """@return {Mixamo's name: the new one}"""
    names = {}
    for number, bone in enumerate(armature.data.bones):
        names[plain(bone.name)] = "b%03d" % number
    for bone in armature.data.bones:
        bone.name = names[plain(bone.name)]  # and Blender renames the weights of the meshes
    return names


def place(armature, scale, degrees):
    top = armature
    while top.parent:
        top = top.parent
    top.matrix_world = Matrix.Rotation(math.radians(degrees), 4, "Z") @ Matrix.Scale(scale, 4) @ top.matrix_world
    bpy.context.view_layer.update()


def main():
    mend_importers()
    words = sys.argv[sys.argv.index("--") + 1:]
    folder, character = pathlib.Path(words[0]), words[1] if len(words) > 1 else ""
    names = {}
    for file, scale, degrees in (("mixamo.glb", 1, 0), ("numbered.glb", 7 / 6, 0), ("turned.glb", 0.9, 180)):
        armature = base(character)
        if file == "mixamo.glb":
            hang_arms(armature, 50)
            names[file] = {plain(bone.name): bone.name for bone in armature.data.bones}
        else:
            names[file] = number_bones(armature)
        place(armature, scale, degrees)
        bpy.ops.export_scene.gltf(filepath=str(folder / file), export_format="GLB")
    (folder / "names.json").write_text(json.dumps(names))


if __name__ == "__main__":
    main()
