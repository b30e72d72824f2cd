#!/usr/bin/env python3
"""Gives characters of another program a recorded pair and asks Blender, and three.js, where their joints are.

    tests/peers/character_check.py --abrazo build/release/bin/abrazo --points build/release/bin/abrazo_character_points
    tests/peers/character_check.py ... --character xbot.glb --manifest data/cmu-salsa.json --take salsa_01 --keep DIR

Blender writes a rigged figure, or the given character (with Mixamo's names), as a GLB with Mixamo's names and
as two whose bones are known only by VRM's list, in the way of VRM 1.0 and of 0.x. Leader and follower of a
take (default: of a generated dance) perform as each of them. Then every bone of every frame must be in Blender
where the program means it to be, within 0.1 mm, and the surface must move. For information: how far the
joints of limbs are from the performer's, on the path of the characters. Ends with 77, which ctest counts as skipped, when Blender is not
installed. three.js is asked where Node has it: `npm install three` in the folder that --node names.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# Keys are numbers of 24 bits: a few micrometres at the end of a chain of bones, some metres from the origin.
LIMIT_M = 1e-4
SKIPPED = 77

# VRM's name of a bone (of 0.x; those of 1.0 are the same here), and Mixamo's.
BONES = [("hips", "Hips"), ("spine", "Spine"), ("chest", "Spine1"), ("upperChest", "Spine2"), ("neck", "Neck"),
         ("head", "Head")] + [
    (side.lower() + bone, side + name) for side in ("Left", "Right") for bone, name in (
        ("Shoulder", "Shoulder"), ("UpperArm", "Arm"), ("LowerArm", "ForeArm"), ("Hand", "Hand"),
        ("UpperLeg", "UpLeg"), ("LowerLeg", "Leg"), ("Foot", "Foot"), ("Toes", "ToeBase"))]


def run(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit("%s: %s" % (" ".join(str(word) for word in command[:3]), done.stderr.strip()[-2000:]))
    return done.stdout


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


def read_glb(path):
    """The JSON of a GLB, and the bytes behind it."""
    content = path.read_bytes()
    length = struct.unpack("<I", content[12:16])[0]
    return json.loads(content[20:20 + length]), content[20 + length:]


def write_glb(path, document, rest):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)


def as_vrm(source, target, names, version):
    """The GLB as a VRM, which lists the bones of the humanoid."""
    document, rest = read_glb(source)
    node_of = {node.get("name"): number for number, node in enumerate(document["nodes"])}
    bones = {bone: node_of[names[name]] for bone, name in BONES}
    if version == 0:
        name = "VRM"
        extension = {"exporterVersion": "none", "specVersion": "0.0", "humanoid": {
            "humanBones": [{"bone": bone, "node": node, "useDefaultValues": True} for bone, node in bones.items()]}}
    else:
        name = "VRMC_vrm"
        extension = {"specVersion": "1.0", "meta": {"name": "figure", "authors": ["Blender"]}, "humanoid": {
            "humanBones": {bone: {"node": node} for bone, node in bones.items()}}}
    document.setdefault("extensions", {})[name] = extension
    document.setdefault("extensionsUsed", []).append(name)
    write_glb(target, document, rest)


def characters(options, program, folder):
    said = blender(program, "blender_characters.py", folder, *([options.character] if options.character else []))
    if not (folder / "names.json").exists():
        sys.exit("Blender wrote no characters:\n" + said)
    names = json.loads((folder / "names.json").read_text())
    as_vrm(folder / "numbered.glb", folder / "vrm1.vrm", names["numbered.glb"], 1)
    as_vrm(folder / "turned.glb", folder / "vrm0.vrm", names["turned.glb"], 0)
    written = [folder / "mixamo.glb", folder / "vrm0.vrm", folder / "vrm1.vrm"]
    if options.character:
        written.insert(0, folder / ("plain_" + options.character.name))
        shutil.copyfile(options.character, written[0])
    return written


def source_of(options, folder):
    if options.manifest:
        return ["--manifest", options.manifest, "--take", options.take]
    run(options.abrazo, "demo", "-o", folder / "demo", "--seed", "1", "--minutes", "0.5")
    return ["--manifest", folder / "demo" / "manifest.json", "--take", "salsa_01"]


def three_says(node_folder, file, rate):
    """Places of every frame by number of the node; None where three.js is not installed."""
    node = shutil.which("node")
    if not node or not (node_folder / "node_modules" / "three").is_dir():
        return None
    answer = file.with_suffix(".three.json")
    run(node, "--input-type=module", "-e", (HERE / "three_joints.mjs").read_text(), file.resolve(), rate,
        answer.resolve(), cwd=node_folder)
    return json.loads(answer.read_text())


def blender_says(program, file, rate):
    answer = file.with_suffix(".blender.json")
    said = blender(program, "blender_joints.py", file, repr(rate), answer)
    if not answer.exists():
        sys.exit("Blender did not come to an answer about %s:\n%s" % (file.name, said))
    return json.loads(answer.read_text())


def spread(distances):
    """Mean, 99th percentile and maximum, millimetres."""
    if not distances:
        return "nothing"
    ranked = sorted(distances)
    return "mean %.4f, p99 %.4f, max %.4f mm" % (
        1e3 * sum(ranked) / len(ranked), 1e3 * ranked[int(0.99 * (len(ranked) - 1))], 1e3 * ranked[-1])


def distances(places, others):
    return [math.dist(place, other) for place, other in zip(places, others)]


def check(file, meant, rate, places_of, frames, program):
    """Whether all bones are where they are meant to be. @param places_of  of a bone's node, by frame"""
    wanted = len(meant["hips"]["places"])
    wrong = [] if frames == wanted else ["there are %d frames instead of %d" % (frames, wanted)]
    from_meant, from_performer = [], {"hand": [], "foot": [], "other": []}
    for bone, of_bone in meant.items():
        places = places_of(of_bone["node"])
        from_meant += distances(places, of_bone["places"])
        part = next((end for end in ("hand", "foot") if bone.endswith(end)), "other")
        from_performer[part] += distances(places, of_bone.get("performer", []))
    print("%s in %s: %d bones, %d frames at %g Hz: %s" % (
        file.name, program, len(meant), frames, rate, spread(from_meant)))
    if program == "Blender":
        print("  from the performer's: wrists %s; ankles %s; shoulders, elbows, hips, knees %s" % tuple(
            spread(from_performer[part]) for part in ("hand", "foot", "other")))
    if not max(from_meant, default=math.inf) <= LIMIT_M:
        wrong.append("bones are not where they are meant to be")
    for sentence in wrong:
        print("  WRONG: " + sentence)
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--abrazo", required=True, type=pathlib.Path)
    parser.add_argument("--points", required=True, type=pathlib.Path)
    parser.add_argument("--character", type=pathlib.Path)
    parser.add_argument("--manifest", type=pathlib.Path)
    parser.add_argument("--take", default="salsa_01")
    parser.add_argument("--node", type=pathlib.Path, default=pathlib.Path.cwd())
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    program = shutil.which("blender")
    if not program:
        print("skipped: Blender is not installed")
        return SKIPPED
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        source = source_of(options, folder)
        pair = folder / "pair.npz"
        run(options.abrazo, "retarget", *source, "-o", pair, "--quiet")
        good = True
        for character in characters(options, program, folder):
            output = folder / ("moved_" + character.name)
            run(options.abrazo, "retarget", *source, "--character", character, "-o", output, "--quiet")
            meant = json.loads(run(options.points, character, pair))
            document = read_glb(character)[0]
            for role, body in zip(("active", "passive"), meant["bodies"]):
                file = output.with_stem(output.stem + "_" + role)
                # Blender recognises a file by its ending.
                as_glb = file.with_name(file.name + ".glb")
                shutil.copy(file, as_glb)
                said = blender_says(program, as_glb, meant["fps"])
                good &= check(file, body, meant["fps"], lambda node: said["bones"][document["nodes"][node]["name"]],
                              said["frames"], "Blender")
                if said["meshes"] == 0 or said["moved_m"] < 0.05:
                    print("  WRONG: the surface does not move")
                    good = False
                also = three_says(options.node, as_glb, meant["fps"])
                if also:
                    good &= check(file, body, meant["fps"], lambda node: also["nodes"][node], also["frames"], "three.js")
    return 0 if good else 1


sys.exit(main())
