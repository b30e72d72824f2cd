"""SMPL parameters by the program against an independent calculation in NumPy, with a made-up body.

    smpl_body_check.py --abrazo PROGRAM        exit status 77 where NumPy is not installed
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

PARENTS = {
    24: [-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19, 20, 21],
}
PARENTS[52] = PARENTS[24][:22] + [20, 22, 23, 20, 25, 26, 20, 28, 29, 20, 31, 32, 20, 34, 35,
                                  21, 37, 38, 21, 40, 41, 21, 43, 44, 21, 46, 47, 21, 49, 50]
PARENTS[55] = PARENTS[24][:22] + [15, 15, 15] + [20, 25, 26, 20, 28, 29, 20, 31, 32, 20, 34, 35, 20, 37, 38,
                                                 21, 40, 41, 21, 43, 44, 21, 46, 47, 21, 49, 50, 21, 52, 53]
# A standing person [m]: x to the left, y up.
PLACES = np.array([[0, .95, 0], [.09, .88, 0], [-.09, .88, 0], [0, 1.06, 0], [.1, .48, 0], [-.1, .48, 0], [0, 1.2, 0],
                   [.1, .08, -.02], [-.1, .08, -.02], [0, 1.26, 0], [.11, .02, .1], [-.11, .02, .1], [0, 1.47, 0],
                   [.07, 1.38, 0], [-.07, 1.38, 0], [0, 1.55, .02], [.18, 1.4, 0], [-.18, 1.4, 0], [.45, 1.4, 0],
                   [-.45, 1.4, 0], [.7, 1.4, 0], [-.7, 1.4, 0], [.78, 1.4, 0], [-.78, 1.4, 0]])


def body(joints, seed, shapes=16, vertices=300):
    """A body whose regressor gives joints near PLACES from random vertices, as the files of the models are laid out."""
    random = np.random.default_rng(seed)
    places = np.zeros((joints, 3))
    for j in range(joints):
        places[j] = PLACES[j] if j < min(joints, 22) or joints == 24 else places[PARENTS[joints][j]] + [.02, -.01, 0]
    regressor = np.zeros((joints, vertices))
    template = random.normal(0, .05, (vertices, 3))
    for j in range(joints):
        chosen = np.arange(5 * j, 5 * j + 5)
        template[chosen] += places[j] - template[chosen].mean(0)
        regressor[j, chosen] = .2
    return {"v_template": template, "shapedirs": random.normal(0, .002, (vertices, 3, shapes)), "J_regressor": regressor,
            "kintree_table": np.array([[2**32 - 1] + PARENTS[joints][1:], range(joints)], dtype=np.int64)}


def rodrigues(r):
    angle = np.linalg.norm(r)
    if angle == 0:
        return np.eye(3)
    k = r / angle
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def forward(model, poses, trans, betas):
    """Joints (T, J, 3) by 4 x 4 transforms, another way than the program's."""
    shaped = model["v_template"] + model["shapedirs"][:, :, :len(betas)] @ betas
    rest = model["J_regressor"] @ shaped
    joints = len(rest)
    result = np.zeros((len(poses), joints, 3))
    for t, pose in enumerate(poses):
        world = []
        for j in range(joints):
            local = np.eye(4)
            local[:3, :3] = rodrigues(pose[3 * j:3 * j + 3])
            parent = PARENTS[joints][j]
            local[:3, 3] = rest[j] - (rest[parent] if parent >= 0 else 0)
            world.append(local if parent < 0 else world[parent] @ local)
        result[t] = [m[:3, 3] + trans[t] for m in world]
    return result


def run(*words):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True)


def positions(program, motion, model, folder):
    out = folder / "out.csv"
    done = run(program, "motion", "positions", motion, "--body-model", model, "-o", out)
    assert done.returncode == 0, done.stderr
    rows = list(csv.reader(out.open()))
    names = [name[:-2] for name in rows[0][2::3]]
    values = np.array([[float(v) for v in row[2:]] for row in rows[1:]])
    return names, values.reshape(len(values), len(names), 3)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--abrazo", required=True)
    program = arguments.parse_args().abrazo
    random = np.random.default_rng(7)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for joints in (24, 52, 55):
            for z_up in (False, True):
                model = body(joints, joints)
                if joints == 55:  # as the distributed file, which has pickled arrays beside those that are needed
                    model["joint2num"] = np.array([{"Pelvis": 0}], dtype=object)
                    model["shapedirs"] = np.asfortranarray(model["shapedirs"])
                np.savez(folder / "model.npz", **model)
                frames, betas = 40, random.normal(0, 1, 10)
                poses = random.normal(0, .1, (frames, 3 * joints))
                poses[:, :3] = [np.pi / 2, 0, 0] if z_up else [0, 0, 0]
                poses[3] = 0
                if z_up:
                    poses[3, :3] = [np.pi / 2, 0, 0]
                trans = random.normal(0, .02, (frames, 3)).cumsum(0)
                if z_up:  # the root turns about the shaped pelvis: bring its height onto the axis that points up
                    trans += [0, -.95, .95]
                named = {"trans": trans, "betas": betas, "gender": "neutral", "mocap_frame_rate": 60.0}
                if joints == 55:  # Inter-X's layout: no face
                    poses[:, 66:75] = 0
                    named.update(root_orient=poses[:, :3], pose_body=poses[:, 3:66].reshape(frames, 63),
                                 pose_lhand=poses[:, 75:120], pose_rhand=poses[:, 120:165])
                else:
                    named["poses"] = poses
                np.savez(folder / "motion.npz", **named)
                names, found = positions(program, folder / "motion.npz", folder / "model.npz", folder)
                truth = forward(model, poses, trans, betas)
                if z_up:
                    truth = np.stack([truth[..., 0], truth[..., 2], -truth[..., 1]], -1)
                where = {"root": 0, "lhipjoint": 1, "rhipjoint": 2, "lfemur": 4, "rtibia": 8, "lfoot": 10, "lowerneck": 12,
                         "lclavicle": 16, "rhumerus": 19, "lwrist": 20,
                         "lhand": {24: 22, 52: 25, 55: 28}[joints]}
                shift = None
                for name, joint in where.items():
                    off = found[:, names.index(name)] - truth[:, joint]
                    if shift is None:
                        shift = off[0]  # of the floor, the same for all
                    error = np.abs(off - shift).max()
                    assert error < 1e-6, f"{joints} joints, z up {z_up}: {name} is {error} m off"
                assert abs(shift[0]) < 1e-6 and abs(shift[2]) < 1e-6, shift
        # What does not go together is said.
        np.savez(folder / "small.npz", **body(24, 1))
        for words, expected in (
                ((folder / "motion.npz",), "Name the file of the model"),
                ((folder / "motion.npz", "--body-model", folder / "small.npz"), "expected (40, 3)"),
                ((folder / "motion.npz", "--body-model", folder / "motion.npz"), "has no array J_regressor")):
            done = run(program, "motion", "info", *words)
            if expected == "expected (40, 3)":
                assert done.returncode == 0, done.stderr  # 22 joints of the body and no hands
                continue
            assert done.returncode != 0 and expected in done.stderr, done.stderr
        few = dict(body(24, 1))
        few["shapedirs"] = few["shapedirs"][:, :, :4]
        np.savez(folder / "few.npz", **few)
        done = run(program, "motion", "info", folder / "motion.npz", "--body-model", folder / "few.npz")
        assert "has 4 shapes, and the motion 10 betas" in done.stderr, done.stderr
        np.savez(folder / "wrong.npz", poses=np.zeros((5, 156)), trans=np.zeros((5, 3)), betas=np.zeros(4))
        done = run(program, "motion", "info", folder / "wrong.npz", "--body-model", folder / "small.npz")
        assert "angles of 52 joints, and the body model has 24" in done.stderr, done.stderr
        np.savez(folder / "cut.npz", poses=np.zeros((5, 72)), trans=np.zeros((4, 3)), betas=np.zeros(4))
        done = run(program, "motion", "info", folder / "cut.npz", "--body-model", folder / "small.npz")
        assert "trans: has the shape (4, 3); expected (5, 3)" in done.stderr, done.stderr


if __name__ == "__main__":
    main()
