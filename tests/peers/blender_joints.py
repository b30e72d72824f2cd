"""Where Blender has the bones of a character that moves: run by character_check.py as

    blender --background --factory-startup --python blender_joints.py -- FILE.glb RATE_HZ ANSWER.json

Writes {"frames": N, "moved_m": of the surface, "bones": {bone: [[x, y, z] of each frame]}}, metres, Y up.
"""

import json
import math
import sys

import bpy

from blender_check import import_file, mend_importers, place_of, skinned_meshes


def main():
    mend_importers()
    path, rate, answer = sys.argv[sys.argv.index("--") + 1:][:3]
    import_file(path, float(rate))
    scene = bpy.context.scene
    keys = [action.frame_range for action in bpy.data.actions]
    first, last = min(key[0] for key in keys), max(key[1] for key in keys)
    scene.frame_end = round(last)
    meshes = skinned_meshes()
    for thing in list(bpy.data.objects):
        if thing.type == "MESH":
            bpy.data.objects.remove(thing)  # every frame would bend it
    frames = round((last - first) / scene.render.fps * float(rate)) + 1
    step = (last - first) / max(1, frames - 1)
    armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
    bones = {bone.name: [] for bone in armature.pose.bones}
    for frame in range(frames):
        at = first + frame * step
        scene.frame_set(math.floor(at + 1e-6), subframe=max(0.0, at - math.floor(at + 1e-6)))
        for name, places in bones.items():
            places.append(list(place_of(armature, name)))
    with open(answer, "w") as file:
        json.dump({"frames": frames, "meshes": len(meshes), "bones": bones,
                   "moved_m": max((mesh["moved_m"] for mesh in meshes), default=0)}, file)


if __name__ == "__main__":
    main()
