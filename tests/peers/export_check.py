#!/usr/bin/env python3
"""Gives exported motion to the programs it is for: Blender reads .glb and .bvh, the glTF validator the .glb.

    tests/peers/export_check.py --abrazo build/release/bin/abrazo [--input FILE --library LIB] [--keep DIR]
    tests/peers/export_check.py --abrazo ... --session S.abrazo

Without an input a dance is generated. Both characters are written as .glb, .bvh and .csv; then every joint
of every frame must stand in Blender where the .csv has it, within 0.1 mm for .glb and 1 mm for .bvh, at the
same rate and with as many frames; each .glb must have a skeleton and a bound, moving body per character.
Ends with 77, which ctest counts as skipped, when Blender is not installed. The validator is asked where Node
has it: `npm install gltf-validator` in the folder that --node names.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LIMIT_M = {".glb": 1e-4, ".bvh": 1e-3}
SKIPPED = 77

VALIDATE = """
const validator = require('gltf-validator');
const bytes = new Uint8Array(require('fs').readFileSync(process.argv[1]));
validator.validateBytes(bytes).then(report => console.log(JSON.stringify(report.issues)));
"""


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("%s: %s" % (" ".join(str(word) for word in command[:3]), done.stderr.strip()[-2000:]))
    return done.stdout


def written(options, folder):
    """pair.glb, pair.bvh and pair.csv in the folder."""
    if options.session:
        for ending in (".glb", ".bvh", ".csv"):
            run(options.abrazo, "export", options.session, "--what", "active,passive", "-o",
                folder / ("pair" + ending))
        return
    clip, library, skeleton = options.input, options.library, options.skeleton
    if not clip:
        run(options.abrazo, "demo", "-o", folder / "demo", "--seed", "1", "--minutes", "0.5")
        library = folder / "demo.h5"
        run(options.abrazo, "library", "build", folder / "demo" / "manifest.json", "-o", library, "--quiet")
        clip = folder / "demo" / "salsa_01_a.bvh"
    for ending in (".glb", ".bvh", ".csv"):
        run(options.abrazo, "synth", "--library", library, "--input", clip, "--preset", "responsive",
            "-o", folder / ("pair" + ending), "--quiet", *(["--skeleton", skeleton] if skeleton else []))


def blender_says(blender, file, truth):
    answer = file.with_suffix(file.suffix + ".json")
    answer.unlink(missing_ok=True)
    # Blender looks along PATH for the Python that it belongs to: its own comes first.
    path = os.pathsep.join([str(pathlib.Path(blender).parent), os.environ.get("PATH", "")])
    done = subprocess.run([blender, "--background", "--factory-startup", "--python", HERE / "blender_check.py",
                           "--", file, truth, answer], capture_output=True, text=True, env={**os.environ, "PATH": path})
    if "No module named 'numpy'" in done.stdout + done.stderr:
        print("Blender's Python has no numpy, which its importers need: nothing was checked")
        sys.exit(SKIPPED)
    if not answer.exists():
        sys.exit("Blender did not come to an answer about %s:\n%s" % (file.name, done.stdout[-3000:] + done.stderr))
    return json.loads(answer.read_text())


def complaints(file, found):
    ending = file.suffix
    if found["worst_m"] > LIMIT_M[ending]:
        yield "%s is %.4f mm off" % (found["worst_at"], 1e3 * found["worst_m"])
    if abs(found["rate_hz"] - found["csv_rate_hz"]) > 0.01:
        yield "the rate is %g Hz instead of %g" % (found["rate_hz"], found["csv_rate_hz"])
    if found["frames"] != found["csv_frames"]:
        yield "there are %d frames instead of %d" % (found["frames"], found["csv_frames"])
    if ending != ".glb":
        return
    if found["armatures"] != 2:
        yield "there are %d armatures for two characters" % found["armatures"]
    if len(found["meshes"]) != 2:
        yield "there are %d meshes for two characters" % len(found["meshes"])
    for mesh in found["meshes"]:
        if not mesh["is_bound"] or mesh["unbound_vertices"] or mesh["uneven_vertices"]:
            yield mesh["name"] + " is not bound to its skeleton throughout"
        if mesh["moved_m"] < 0.05:
            yield mesh["name"] + " does not move"
        if not mesh["smooth"] or len(mesh["materials"]) != 1:
            yield mesh["name"] + " is not a smooth body in one material"
    if len({tuple(mesh["materials"]) for mesh in found["meshes"]}) != len(found["meshes"]):
        yield "the characters share a material"


def validator_says(node_folder, file):
    """Issues by severity, or None where there is no validator."""
    node = shutil.which("node")
    if not node or not (node_folder / "node_modules" / "gltf-validator").is_dir():
        return None
    done = subprocess.run([node, "-e", VALIDATE, file.resolve()], capture_output=True, text=True, cwd=node_folder)
    if done.returncode != 0:
        sys.exit("the glTF validator failed: " + done.stderr)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--abrazo", required=True, type=pathlib.Path)
    parser.add_argument("--input", type=pathlib.Path)
    parser.add_argument("--skeleton", type=pathlib.Path)
    parser.add_argument("--library", type=pathlib.Path)
    parser.add_argument("--session", type=pathlib.Path)
    parser.add_argument("--node", type=pathlib.Path, default=pathlib.Path.cwd())
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    blender = shutil.which("blender")
    if not blender:
        print("skipped: Blender is not installed")
        return SKIPPED
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        written(options, folder)
        failed = False
        for ending in (".glb", ".bvh"):
            file = folder / ("pair" + ending)
            found = blender_says(blender, file, folder / "pair.csv")
            print("%s: %d joint places over %d frames at %g Hz, at most %.4f mm off (mean %.5f)" % (
                file.name, found["compared"], found["csv_frames"], found["rate_hz"], 1e3 * found["worst_m"],
                1e3 * found["mean_m"]))
            for mesh in found["meshes"]:
                print("  %s: %d vertices, %d faces" % (mesh["name"], mesh["vertices"], mesh["triangles"]))
            for complaint in complaints(file, found):
                print("  WRONG: " + complaint)
                failed = True
        issues = validator_says(options.node, folder / "pair.glb")
        if issues is None:
            print("glTF validator: not asked, it is not installed")
        else:
            print("glTF validator: %(numErrors)d errors, %(numWarnings)d warnings, %(numInfos)d infos" % issues)
            for message in issues["messages"][:10]:
                print("  %s: %s" % (message["code"], message["message"]))
            failed = failed or issues["numErrors"] > 0
    return 1 if failed else 0


sys.exit(main())
