#!/usr/bin/env python3
"""The figures of core/metrics/published.hpp once more, with NumPy, from its description and not from its code.

published_check.py FILE.npz: person1 is the user, person2 the captured partner, person3 the made one, (T, 25, 3) at
30 Hz, Y up, joints by name. Prints one JSON object.
"""
import json
import sys

import numpy as np

CLIP = 60  # frames


def gaussian(values, width):
    reach = int(4 * width + 0.5)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2)
    padded = np.pad(values, reach, mode="symmetric")
    return np.convolve(padded, kernel / kernel.sum(), mode="valid")


def beats(motion):
    speed = gaussian(np.linalg.norm(np.diff(motion, axis=0), axis=2).mean(axis=1), 5)
    inner = speed[1:-1]
    return 1 + np.flatnonzero((inner < speed[:-2]) & (inner < speed[2:]))


def facing(motion, index):
    """Unit vectors on the floor, X and Z."""
    def side(left, right):
        axis = (motion[:, index[left]] - motion[:, index[right]])[:, [0, 2]]
        return axis / np.linalg.norm(axis, axis=1, keepdims=True)
    left = 0.6 * side("lhipjoint", "rhipjoint") + 0.4 * side("lclavicle", "rclavicle")
    left /= np.linalg.norm(left, axis=1, keepdims=True)
    return np.stack([-left[:, 1], left[:, 0]], axis=1)


def frechet(a, b):
    covariances = np.cov(a, rowvar=False), np.cov(b, rowvar=False)
    # Fewer clips than features: most eigenvalues are zero but for rounding, whose roots would count.
    eigenvalues = np.abs(np.linalg.eigvals(covariances[0] @ covariances[1]))
    roots = np.sqrt(eigenvalues[eigenvalues > 1e-10 * eigenvalues.max()]).sum()
    difference = a.mean(axis=0) - b.mean(axis=0)
    return difference @ difference + np.trace(covariances[0]) + np.trace(covariances[1]) - 2 * roots


def main():
    data = np.load(sys.argv[1])
    user, captured, made = (data[f"person{n}"] for n in (1, 2, 3))
    index = {name: i for i, name in enumerate(data["joint_names"])}
    ten = [index[name] for name in ("root", "ltibia", "rtibia", "lfoot", "rfoot", "upperneck", "lclavicle", "rclavicle",
                                    "lwrist", "rwrist")]
    figures = {}
    figures["mpjpe_m"] = np.linalg.norm(made - captured, axis=2).mean()
    figures["mpjve_m"] = np.linalg.norm(np.diff(made, axis=0) - np.diff(captured, axis=0), axis=2).mean()

    toes = made[:, [index["lfoot"], index["rfoot"]]]
    landed = toes[..., 1] < toes[..., 1].min() + 0.05
    steps = np.concatenate([np.zeros((1, 2)), np.linalg.norm(np.diff(toes, axis=0), axis=2)])
    figures["foot_sliding_m"] = steps[landed].mean()

    pelvis = made[:, index["root"]]
    moves = np.linalg.norm(np.diff(pelvis[:, [0, 2]], axis=0), axis=1) > 0.03
    for ankle in ("ltibia", "rtibia"):
        moves &= np.linalg.norm(np.diff(made[:, index[ankle]] - pelvis, axis=0), axis=1) < 0.01
    figures["skating_share"] = moves[1:].sum() / len(moves)

    figures["jitter_10_m_s3"] = np.linalg.norm(np.diff(made, n=3, axis=0), axis=2).mean() * 30**3 / 10

    between = np.linalg.norm(user[:, :, None] - made[:, None], axis=3).reshape(len(user), -1).min(axis=1)
    figures["penetration_share"] = (between < 0.01).mean()
    figures["penetration_depth_m"] = np.clip(0.01 - between, 0, None).mean()

    def distances(partner):
        return np.linalg.norm(partner[:, ten][:, :, None] - user[:, ten][:, None], axis=3).reshape(len(user), -1)
    shown, meant = distances(made) < 0.25, distances(captured) < 0.25
    figures["contact_precision"] = (shown & meant).sum() / shown.sum()
    figures["contact_recall"] = (shown & meant).sum() / meant.sum()
    figures["contact_f1"] = 2 / (1 / figures["contact_precision"] + 1 / figures["contact_recall"])

    opposite = -(facing(user, index) * facing(made, index)).sum(axis=1)
    figures["turned_away_share"] = (np.degrees(np.arccos(np.clip(opposite, -1, 1))) > 45).mean()

    echoes = np.abs(beats(user)[:, None] - beats(made)[None]).min(axis=1)
    figures["beat_echo_degree"] = np.exp(-echoes**2 / 18).mean()

    def clips(partner):
        whole = len(user) // CLIP * CLIP
        return distances(partner)[:whole].reshape(-1, CLIP, 100).mean(axis=1)
    reference = clips(captured)
    scored = [(clips(motion) - reference.mean(axis=0)) / (reference.std(axis=0) + 1e-10) for motion in (made, captured)]
    figures["fid_cd"] = frechet(*scored)
    rows = scored[0]
    apart = np.linalg.norm(rows[:, None] - rows[None], axis=2)
    figures["diversity"] = apart.sum() / (len(rows) * (len(rows) - 1))
    print(json.dumps({name: float(value) for name, value in figures.items()}))


main()
