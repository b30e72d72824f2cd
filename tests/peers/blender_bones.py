"""Where Blender's own importers put the bones of an FBX or glTF file: run by import_check.py as

    blender --background --factory-startup --python blender_bones.py -- FILE ANSWER.json [ANIMATION]

Imports the file into an empty scene and writes as JSON the rate, and the time of each key frame with the place
of every bone's head in metres, Y up: {"fps": ..., "frames": N, "bones": {"armature/bone": [[x, y, z], ...]}}.
Of several animations the one that is named, or the longest.
"""

import json
import math
import sys

import bpy

from blender_check import mend_importers, to_file


def import_file(path):
    """@return frames of Blender in a second of the file, and the file's rate where it states one"""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    if path.endswith(".fbx"):
        bpy.ops.import_scene.fbx(filepath=path, ignore_leaf_bones=False)
        # The importer counts whole frames a second, whatever the file's rate.
        return scene.render.fps, scene.render.fps / scene.render.fps_base
    # Keys between frames are kept as they are; the finest rate leaves no rounding.
    scene.render.fps = 120
    bpy.ops.import_scene.gltf(filepath=path)
    return scene.render.fps, None


def chosen_action(name):
    actions = [a for a in bpy.data.actions if any(c.data_path.startswith("pose.bones") for c in a.fcurves)]
    if name:
        actions = [a for a in actions if name in a.name.split("|") or a.name.startswith(name + "_") or a.name == name]
    return max(actions, key=lambda a: a.frame_range[1] - a.frame_range[0])


def rate_of_keys(action, per_second):
    """Of most curves: the spacing of their keys."""
    votes = {}
    for curve in action.fcurves:
        times = [key.co[0] for key in curve.keyframe_points]
        steps = sorted(b - a for a, b in zip(times, times[1:]))
        if steps:
            rate = round(per_second / steps[len(steps) // 2], 2)
            votes[rate] = votes.get(rate, 0) + 1
    return max(votes, key=votes.get)


def main():
    mend_importers()
    words = sys.argv[sys.argv.index("--") + 1:]
    per_second, rate = import_file(words[0])
    scene = bpy.context.scene
    action = chosen_action(words[2] if len(words) > 2 else "")
    rate = rate or rate_of_keys(action, per_second)
    first, last = action.frame_range
    frames = round((last - first) / per_second * rate) + 1
    armatures = [thing for thing in bpy.data.objects if thing.type == "ARMATURE"]
    if len(armatures) == 1:
        armatures[0].animation_data_create().action = action
        for track in armatures[0].animation_data.nla_tracks:
            track.mute = True
    bones = {}
    for frame in range(frames):
        at = first + frame * per_second / rate
        scene.frame_set(math.floor(at + 1e-6), subframe=min(0.999999, max(0.0, at - math.floor(at + 1e-6))))
        for armature in armatures:
            for bone in armature.pose.bones:
                place = to_file(armature.matrix_world @ bone.head)
                bones.setdefault(armature.name + "/" + bone.name, []).append([round(x, 7) for x in place])
    with open(words[1], "w") as file:
        json.dump({"fps": rate, "frames": frames, "bones": bones}, file)


main()
