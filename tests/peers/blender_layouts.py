"""Writes one walking figure as FBX and GLB in the layouts that Blender's exporters offer: run by import_check.py as

    blender --background --factory-startup --python blender_layouts.py -- FOLDER
"""

import math
import pathlib
import sys

import bpy

from blender_check import mend_importers

# Bone, parent, head and tail in metres, Z up, facing -Y. The left half; the right one is its mirror image.
MIDDLE = [("Hips", None, (0, 0, 1.0), (0, 0, 1.08)), ("Spine", "Hips", (0, 0, 1.1), (0, 0, 1.2)),
          ("Spine1", "Spine", (0, 0.01, 1.22), (0, 0, 1.3)), ("Spine2", "Spine1", (0, 0, 1.34), (0, 0, 1.45)),
          ("Neck", "Spine2", (0, 0, 1.5), (0, 0, 1.56)), ("Head", "Neck", (0, -0.01, 1.58), (0, -0.02, 1.8))]
LEFT = [("UpLeg", "Hips", (0.09, 0, 0.95), (0.09, 0, 0.55)), ("Leg", "UpLeg", (0.09, 0, 0.53), (0.09, 0, 0.12)),
        ("Foot", "Leg", (0.09, 0.02, 0.1), (0.09, -0.1, 0.04)),
        ("ToeBase", "Foot", (0.09, -0.11, 0.03), (0.09, -0.18, 0.02)),
        ("Shoulder", "Spine2", (0.03, 0, 1.46), (0.15, 0, 1.46)),
        ("Arm", "Shoulder", (0.18, 0, 1.45), (0.45, 0, 1.45)), ("ForeArm", "Arm", (0.46, 0, 1.45), (0.7, 0, 1.45)),
        ("Hand", "ForeArm", (0.71, 0, 1.45), (0.79, 0, 1.45)),
        ("HandMiddle1", "Hand", (0.8, 0, 1.45), (0.85, 0, 1.45))]
SIDED = {name for name, *_ in LEFT}


def figure(scale, with_mesh):
    data = bpy.data.armatures.new("Figure")
    armature = bpy.data.objects.new("Figure", data)
    bpy.context.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    armature.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")

    def add(name, parent, head, tail, roll):
        bone = data.edit_bones.new(name)
        bone.head, bone.tail, bone.roll = [scale * c for c in head], [scale * c for c in tail], roll
        bone.parent = data.edit_bones[parent] if parent else None

    for number, (name, parent, head, tail) in enumerate(MIDDLE):
        add(name, parent, head, tail, 0.1 * number)
    for side, sign in (("Left", 1), ("Right", -1)):
        for number, (name, parent, head, tail) in enumerate(LEFT):
            above = side + parent if parent in SIDED else parent
            add(side + name, above, (sign * head[0], *head[1:]), (sign * tail[0], *tail[1:]), sign * 0.2 * number)
    bpy.ops.object.mode_set(mode="OBJECT")
    if with_mesh:
        bpy.ops.mesh.primitive_cube_add(size=0.4 * scale, location=(0, 0, 1.2 * scale))
        cube = bpy.context.active_object
        for bone in ("Spine", "Hips"):
            cube.vertex_groups.new(name=bone).add([0, 1, 2, 3] if bone == "Hips" else [4, 5, 6, 7], 1.0, "ADD")
        cube.modifiers.new("Skin", "ARMATURE").object = armature
        cube.parent = armature
    return armature


def animate(armature, name, frames, size, scale):
    """Every bone turns by its own angles, the hips walk."""
    armature.animation_data_create()
    armature.animation_data.action = bpy.data.actions.new(name)
    armature.animation_data.action.use_fake_user = True
    for number, bone in enumerate(armature.pose.bones):
        bone.rotation_mode = "QUATERNION"
        for frame in range(frames):
            turn = 2 * math.pi * frame / 24 + number
            angles = (size * math.sin(turn), 0.5 * size * math.cos(turn), 0.3 * size * math.sin(2 * turn))
            half = [0.5 * angle for angle in angles]
            bone.rotation_quaternion = (math.sqrt(1 - sum(math.sin(h) ** 2 for h in half)), *map(math.sin, half))
            bone.keyframe_insert("rotation_quaternion", frame=frame + 1)
            if bone.name == "Hips":
                bone.location = [scale * c for c in (0.02 * frame, 0.03 * math.sin(turn), 0.01 * frame)]
                bone.keyframe_insert("location", frame=frame + 1)


# Name, ending, frames a second, of the scene (its fps and base), what the exporter is told, and how the
# scene is made.
FBX = {"use_selection": False, "bake_anim_use_nla_strips": False, "bake_anim_use_all_actions": False,
       "bake_anim_simplify_factor": 0.0}
LAYOUTS = [
    ("plain", "fbx", (30, 1), {}, {}),
    ("no_leaves", "fbx", (30, 1), {"add_leaf_bones": False}, {}),
    ("film", "fbx", (24, 1), {}, {}),
    ("pal", "fbx", (25, 1), {"add_leaf_bones": False}, {}),
    ("ntsc", "fbx", (30, 1.001), {}, {}),
    ("sixty", "fbx", (60, 1), {}, {"with_mesh": True}),
    ("fast", "fbx", (120, 1), {"add_leaf_bones": False}, {}),
    ("odd_rate", "fbx", (50, 1), {}, {}),
    ("z_up", "fbx", (30, 1), {"axis_forward": "Y", "axis_up": "Z"}, {}),
    ("z_up_minus_y", "fbx", (30, 1), {"axis_forward": "-Y", "axis_up": "Z"}, {"with_mesh": True}),
    ("x_forward", "fbx", (30, 1), {"axis_forward": "X", "axis_up": "Y"}, {}),
    ("x_up", "fbx", (30, 1), {"axis_forward": "Y", "axis_up": "X"}, {}),
    ("units_scale", "fbx", (30, 1), {"apply_scale_options": "FBX_SCALE_UNITS"}, {}),
    ("all_scale", "fbx", (30, 1), {"apply_scale_options": "FBX_SCALE_ALL"}, {}),
    ("custom_scale", "fbx", (30, 1), {"apply_scale_options": "FBX_SCALE_CUSTOM"}, {}),
    ("global_scale", "fbx", (30, 1), {"global_scale": 0.01}, {}),
    ("no_unit_scale", "fbx", (30, 1), {"apply_unit_scale": False}, {}),
    ("centimetre_scene", "fbx", (30, 1), {}, {"unit": 0.01}),
    ("millimetre_scene", "fbx", (30, 1), {"apply_scale_options": "FBX_SCALE_UNITS"}, {"unit": 0.001}),
    ("inches", "fbx", (30, 1), {}, {"unit": 0.0254}),
    ("bone_axes", "fbx", (30, 1), {"primary_bone_axis": "X", "secondary_bone_axis": "Z"}, {}),
    ("baked_space", "fbx", (30, 1), {"bake_space_transform": True}, {}),
    ("root_node", "fbx", (30, 1), {"armature_nodetype": "ROOT"}, {}),
    ("two_takes", "fbx", (30, 1), {"bake_anim_use_all_actions": True}, {"second": 40}),
    ("thinned", "fbx", (30, 1), {"bake_anim_simplify_factor": 1.0}, {}),
    ("moved_armature", "fbx", (30, 1), {}, {"object": (0.5, -0.2, 0.1)}),
    ("plain", "glb", (30, 1), {}, {}),
    ("skinned", "glb", (60, 1), {}, {"with_mesh": True}),
    ("ntsc", "glb", (30, 1.001), {}, {}),
    ("z_up", "glb", (24, 1), {"export_yup": False}, {}),
    ("two_takes", "glb", (25, 1), {}, {"second": 40}),
]


def write(folder, name, ending, rate, told, made):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = rate
    scale = 1 / made.get("unit", 1.0)
    scene.unit_settings.scale_length = made.get("unit", 1.0)
    frames = 36
    scene.frame_start, scene.frame_end = 1, frames
    armature = figure(scale, made.get("with_mesh", False))
    if "object" in made:
        armature.location, armature.rotation_euler = made["object"], (0, 0, 0.7)
    if "second" in made:
        animate(armature, "Spin", made["second"], 0.5, scale)
        scene.frame_end = made["second"]
    animate(armature, "Walk", frames, 0.3, scale)
    path = str(folder / ("%s.%s" % (name, ending)))
    if ending == "fbx":
        bpy.ops.export_scene.fbx(filepath=path, **{**FBX, **told})
    else:
        bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", **told)


def main():
    mend_importers()
    folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
    folder.mkdir(parents=True, exist_ok=True)
    for layout in LAYOUTS:
        write(folder, *layout)


if __name__ == "__main__":
    main()
