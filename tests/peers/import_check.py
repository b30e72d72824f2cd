#!/usr/bin/env python3
"""Compares what is read of FBX and glTF files with what Blender's own importers make of them.

    tests/peers/import_check.py --points build/release/bin/abrazo_file_points [FILE...] [--animation NAME] [--keep DIR]

Without files Blender writes one figure in many layouts (blender_layouts.py) and those are compared. Every
bone of every frame must be within 1 mm, at the same rate and with as many frames. Ends with 77, which ctest
counts as skipped, when Blender is not installed.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LIMIT_M = 1e-3
SKIPPED = 77


def blender(program, script, *words):
    # Blender looks along PATH for the Python that it belongs to: its own comes first.
    path = os.pathsep.join([str(pathlib.Path(program).parent), os.environ.get("PATH", "")])
    beside = "import sys; sys.path.insert(0, %r)" % str(HERE)
    done = subprocess.run([program, "--background", "--factory-startup", "--python-expr", beside, "--python",
                           HERE / script, "--", *words], capture_output=True, text=True,
                          env={**os.environ, "PATH": path})
    if "No module named 'numpy'" in done.stdout + done.stderr:
        print("skipped: Blender's Python has no numpy, which its importers need")
        sys.exit(SKIPPED)
    return done.stdout[-3000:] + done.stderr


def plain(name):
    """A bone's name without its armature, as both sides have it."""
    return name.split("/")[-1].split(":")[-1]


def largest_distance(ours, theirs):
    """Over all bones that both have: metres, and where."""
    worst, where = 0.0, ""
    for name, places in theirs.items():
        for frame, (a, b) in enumerate(zip(ours[name], places)):
            distance = math.dist(a, b) if None not in a else math.inf
            if not distance <= worst:
                worst, where = distance, "%s in frame %d" % (name, frame)
    return worst, where


def compare(options, file):
    """A row of the table, and whether all is well."""
    name = [options.animation] if options.animation else []
    with tempfile.TemporaryDirectory() as temporary:
        answer = pathlib.Path(temporary) / "bones.json"
        said = blender(options.blender, "blender_bones.py", file, answer, *name)
        if not answer.exists():
            return "%s: Blender did not come to an answer:\n%s" % (file.name, said), False
        theirs = json.loads(answer.read_text())
    done = subprocess.run([options.points, file, *name], capture_output=True, text=True)
    if done.returncode != 0:
        return "%s: %s" % (file.name, done.stderr.strip()), False
    ours = json.loads(done.stdout)
    points = {plain(point): places for point, places in ours["points"].items()}
    bones = {plain(bone): places for bone, places in theirs["bones"].items()}
    lost = sorted(set(bones) - set(points))
    worst, where = largest_distance(points, {bone: bones[bone] for bone in bones if bone in points})
    good = worst <= LIMIT_M and ours["frames"] == theirs["frames"] and not lost
    good = good and abs(ours["fps"] - theirs["fps"]) <= 1e-3 * theirs["fps"]
    row = "%-22s %8.4f mm  %8.3f fps (%g)  %4d frames (%d)  %2d bones%s%s" % (
        file.name, 1e3 * worst, ours["fps"], theirs["fps"], ours["frames"], theirs["frames"], len(bones),
        ", lost " + ", ".join(lost) if lost else "", "" if good else "  WRONG " + where)
    return row + "".join("\n    " + warning for warning in ours["warnings"]), good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", required=True, type=pathlib.Path)
    parser.add_argument("--animation", default="")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    options.blender = shutil.which("blender")
    if not options.blender:
        print("skipped: Blender is not installed")
        return SKIPPED
    with tempfile.TemporaryDirectory() as temporary:
        files = options.files
        if not files:
            folder = options.keep or pathlib.Path(temporary)
            said = blender(options.blender, "blender_layouts.py", folder)
            files = sorted(folder.glob("*.fbx")) + sorted(folder.glob("*.glb"))
            if not files:
                sys.exit("Blender wrote nothing:\n" + said)
        failed = False
        for file in files:
            row, good = compare(options, file)
            print(row, flush=True)
            failed = failed or not good
    return 1 if failed else 0


sys.exit(main())
