"""Joint centres of markers by the program against the published formulas, calculated another way in NumPy.

    marker_joints_check.py --abrazo PROGRAM        exit status 77 where NumPy is not installed
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    sys.exit(77)

# Markers of Plug-in Gait on an adult [m]: x to the left, y up, z forward.
MIDDLE = {"C7": (0, 1.49, -.06), "CLAV": (0, 1.43, .08), "T10": (0, 1.20, -.11), "STRN": (0, 1.27, .11)}
LEFT = {"ASI": (.12, .95, .08), "PSI": (.04, .96, -.08), "KNE": (.15, .47, .05), "ANK": (.13, .08, -.03),
        "THI": (.18, .68, .04), "TIB": (.16, .30, .02), "TOE": (.10, .05, .10), "HEE": (.09, .04, -.10),
        "SHO": (.19, 1.44, .01), "UPA": (.25, 1.24, .01), "ELB": (.24, 1.10, .01), "WRA": (.16, 1.10, .26),
        "WRB": (.23, 1.10, .26), "FIN": (.19, 1.12, .34), "FHD": (.07, 1.68, .09), "BHD": (.07, 1.68, -.07)}
RADIUS, SIDES = .007, (("L", 1, "l"), ("R", -1, "r"))


def unit(v):
    return v / np.linalg.norm(v)


def rotation(random, tilt):
    axis = unit(random.normal(size=3))
    angle = random.normal() * tilt
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def person(random):
    """Markers with 1 cm of difference between people and sides, and whether knees and ankles have inner ones."""
    places = {name: np.array(place) + random.normal(0, .01, 3) for name, place in MIDDLE.items()}
    for side, sign, _ in SIDES:
        for name, place in LEFT.items():
            places[side + name] = np.array(place) * [sign, 1, 1] + random.normal(0, .01, 3)
    return places


def across(v, along):
    """The part of v that is perpendicular to a line."""
    return v - np.outer(unit(along), unit(along)) @ v


def centre_at_marker(above, marker, inward, distance):
    """Davis et al. 1991: the angle at the joint between the joint above and the marker is a right one. Seen from the
    marker, cos(angle to the joint above) = distance / length."""
    up = above - marker
    angle = np.arccos(distance / np.linalg.norm(up))
    return marker + distance * (np.cos(angle) * unit(up) + np.sin(angle) * unit(across(inward, up)))


def away(marker, above, below, otherwise):
    """Away from a marker beside a limb; the nearer than 3 cm to the line, the less it counts."""
    off = across(marker - above, below - above)
    share = min(1, np.linalg.norm(off) / .03)
    return -share * unit(off) + (1 - share) * otherwise


def joints_of(m):
    found = {}
    asis, psis = (m["LASI"] + m["RASI"]) / 2, (m["LPSI"] + m["RPSI"]) / 2
    width, depth = np.linalg.norm(m["LASI"] - m["RASI"]), np.linalg.norm(asis - psis)
    leg = np.linalg.norm(m["LASI"] - m["LKNE"]) + np.linalg.norm(m["LKNE"] - m["LANK"]) - .08
    left = unit(m["LASI"] - m["RASI"])
    forward = unit(across(asis - psis, left))
    up = np.linalg.svd(np.stack([left, forward]))[2][2]  # perpendicular to both
    up *= np.sign(up @ (m["C7"] - asis))
    found["root"] = (asis + psis) / 2
    shoulders = m["LSHO"] - m["RSHO"]
    neck = (m["C7"] + m["CLAV"]) / 2
    trunk_up = unit(across(neck - found["root"], shoulders))
    found["lowerneck"] = neck
    for side, sign, small in SIDES:
        # Harrington et al. 2007, in millimetres: 0.33 PW + 7.3, -0.30 PW - 10.9, -0.24 PD - 9.9.
        hip = asis + sign * (.33 * width + .0073) * left + (-.30 * width - .0109) * up \
            + (-.24 * depth - .0099) * forward
        inward = -sign * left
        knee_in = away(m[side + "THI"], hip, m[side + "KNE"], inward)
        knee = centre_at_marker(hip, m[side + "KNE"], knee_in, .128 * leg / 2 + RADIUS)
        ankle_in = away(m[side + "TIB"], knee, m[side + "ANK"], knee_in)
        ankle = centre_at_marker(knee, m[side + "ANK"], ankle_in, .085 * leg / 2 + RADIUS)
        # Rab et al. 2002: 17 % of the distance between the acromia, down along the trunk.
        shoulder = m[side + "SHO"] - .17 * np.linalg.norm(shoulders) * trunk_up
        wrist = (m[side + "WRA"] + m[side + "WRB"]) / 2
        bend = np.cross(unit(m[side + "ELB"] - shoulder), unit(wrist - m[side + "ELB"]))
        assert np.linalg.norm(bend) > .35, "the elbow is bent"
        elbow = centre_at_marker(shoulder, m[side + "ELB"], sign * unit(bend), .090 * leg / 2 + RADIUS)
        found.update({small + "hipjoint": hip, small + "femur": knee, small + "tibia": ankle,
                      small + "clavicle": shoulder, small + "humerus": elbow, small + "wrist": wrist})
    return found


def trc(frames):
    names = list(frames[0])
    lines = ["PathFileType\t4\t(X/Y/Z)\tperson.trc",
             "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames",
             f"100\t100\t{len(frames)}\t{len(names)}\tm\t100\t1\t{len(frames)}",
             "Frame#\tTime\t" + "\t\t\t".join(names),
             "\t\t" + "\t".join(f"{axis}{n + 1}" for n in range(len(names)) for axis in "XYZ")]
    for f, frame in enumerate(frames):
        lines.append("\t".join([str(f + 1), repr(f / 100)] + [repr(float(v)) for name in names for v in frame[name]]))
    return "\n".join(lines) + "\n"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--abrazo", required=True)
    program = arguments.parse_args().abrazo
    random = np.random.default_rng(20)
    largest = {}
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for _ in range(20):
            still = person(random)
            frames = []
            for f in range(12):  # the person as a stiff whole: sizes stay, and hips are those of the regression
                turn, shift = rotation(random, .2), random.normal(0, .05, 3)
                frames.append({name: turn @ place + shift for name, place in still.items()})
            (folder / "person.trc").write_text(trc(frames))
            done = subprocess.run([program, "motion", "positions", folder / "person.trc", "--up", "y", "--floor", "0",
                                   "-o", folder / "out.csv"], capture_output=True, text=True)
            assert done.returncode == 0, done.stderr
            rows = list(csv.DictReader((folder / "out.csv").open()))
            for row, frame in zip(rows, frames, strict=True):
                for name, truth in joints_of(frame).items():
                    error = np.abs([float(row[f"{name}_{axis}"]) for axis in "xyz"] - truth).max()
                    largest[name] = max(error, largest.get(name, 0))
    for name, error in largest.items():
        assert error < 1e-9, f"{name} is {error} m off"


if __name__ == "__main__":
    main()
