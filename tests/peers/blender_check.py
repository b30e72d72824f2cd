"""What Blender makes of a file that Abrazo wrote: run by export_check.py as

    blender --background --factory-startup --python blender_check.py -- FILE CSV ANSWER.json

FILE is the .glb or .bvh, CSV the same motion as world positions (`frame,time,root_x,...` or
`active.root_x,...`). Imports the file into an empty scene and writes what was found as JSON: the largest
distance of a joint from where the CSV has it, over all bodies, joints and frames.
"""

import builtins
import csv
import json
import math
import sys

import bpy
import numpy
from mathutils import Vector


def mend_importers():
    """Debian's Blender runs on a newer Python and NumPy than its importers were written for."""
    if "bool" not in numpy.__dict__:
        numpy.bool = bool
    plain_open = builtins.open
    builtins.open = lambda file, mode="r", *more, **named: plain_open(file, mode.replace("U", ""), *more,
                                                                      **named)


def read_csv(path):
    """{body: {joint: [(x, y, z) per frame]}}, and the rate; the body of a lone one is ''."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    bodies = {}
    for column, name in enumerate(rows[0]):
        if column < 2 or not name.endswith("_x"):
            continue
        body, _, joint = name[:-2].rpartition(".")
        places = [tuple(float(value) for value in row[column:column + 3]) for row in rows[1:]]
        bodies.setdefault(body, {})[joint] = places
    rate = 1 / (float(rows[2][1]) - float(rows[1][1])) if len(rows) > 2 else 1.0
    return bodies, rate


def import_file(path, rate):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    # Blender counts in frames: with the motion's own rate every key falls on one.
    scene.render.fps = max(1, round(rate))
    scene.render.fps_base = scene.render.fps / rate
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    else:
        bpy.ops.import_anim.bvh(filepath=path, update_scene_fps=True, update_scene_duration=True,
                                use_fps_scale=False, frame_start=0)


def to_file(place):
    """Blender's Z up as glTF and BVH have it: Y up."""
    return Vector((place.x, place.z, -place.y))


def armature_of(body, joints):
    """The armature that has the joints of a body. A BVH with two roots is one armature with both."""
    for armature in bpy.data.objects:
        if armature.type != "ARMATURE":
            continue
        names = {bone.name for bone in armature.pose.bones}
        if all((body + ":" if body else "") + joint in names for joint in joints):
            return armature
    return None


def place_of(armature, name):
    bone = armature.pose.bones[name]
    return to_file(armature.matrix_world @ bone.head)


def compare(bodies, start, step):
    scene = bpy.context.scene
    worst, where, total, count = 0.0, "", 0.0, 0
    frames = len(next(iter(next(iter(bodies.values())).values())))
    armatures = {}
    for body, joints in bodies.items():
        armatures[body] = armature_of(body, joints)
        if armatures[body] is None:
            raise RuntimeError("no armature has the joints of '%s'" % body)
    for frame in range(frames):
        at = start + frame * step
        scene.frame_set(math.floor(at + 1e-6), subframe=max(0.0, at - math.floor(at + 1e-6)))
        for body, joints in bodies.items():
            for joint, places in joints.items():
                name = (body + ":" if body else "") + joint
                distance = (place_of(armatures[body], name) - Vector(places[frame])).length
                total, count = total + distance, count + 1
                if not distance <= worst:
                    worst, where = distance, "%s in frame %d" % (name, frame)
    return {"worst_m": worst, "worst_at": where, "mean_m": total / count, "compared": count}


def skinned_meshes():
    """Each mesh with its armature: how its vertices are bound, and how far they go along."""
    scene, found = bpy.context.scene, []
    for mesh in bpy.data.objects:
        if mesh.type != "MESH":
            continue
        modifiers = [m for m in mesh.modifiers if m.type == "ARMATURE" and m.object]
        unbound = sum(1 for v in mesh.data.vertices if not v.groups)
        uneven = sum(1 for v in mesh.data.vertices if abs(sum(g.weight for g in v.groups) - 1) > 1e-3)

        def corner():
            shape = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
            return [mesh.matrix_world @ v.co for v in shape.data.vertices]

        scene.frame_set(0)
        before = corner()
        scene.frame_set(int(scene.frame_end))
        after = corner()
        found.append({
            "name": mesh.name, "vertices": len(before), "triangles": len(mesh.data.polygons),
            "is_bound": bool(modifiers), "unbound_vertices": unbound, "uneven_vertices": uneven,
            "smooth": sum(p.use_smooth for p in mesh.data.polygons) > 0.95 * len(mesh.data.polygons),
            "materials": [m.name for m in mesh.data.materials if m],
            "moved_m": max((a - b).length for a, b in zip(before, after)),
        })
    return found


def main():
    mend_importers()
    path, truth, answer = sys.argv[sys.argv.index("--") + 1:][:3]
    bodies, rate = read_csv(truth)
    import_file(path, rate)
    scene = bpy.context.scene
    actions = list(bpy.data.actions)
    count = len(next(iter(next(iter(bodies.values())).values())))
    first = min(action.frame_range[0] for action in actions)
    last = max(action.frame_range[1] for action in actions)
    # The importer of glTF counts whole frames a second: keys of another rate fall between frames.
    per_second = scene.render.fps / (1 if path.endswith(".glb") else scene.render.fps_base)
    frames = round((last - first) / per_second * rate) + 1
    step = (last - first) / max(1, frames - 1)
    found = {
        "blender": bpy.app.version_string,
        "rate_hz": per_second / step if step > 0 else per_second,
        "armatures": sum(1 for thing in bpy.data.objects if thing.type == "ARMATURE"),
        "actions": len(actions),
        "frames": frames,
        "csv_frames": count,
        "csv_rate_hz": rate,
    }
    found.update(compare(bodies, first, step))
    found["meshes"] = skinned_meshes() if path.endswith(".glb") else []
    if any(not math.isfinite(found[key]) for key in ("worst_m", "mean_m")):
        found["worst_m"] = 1e9
    with open(answer, "w") as file:
        json.dump(found, file, indent=1)


if __name__ == "__main__":
    main()
