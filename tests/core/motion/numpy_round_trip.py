#!/usr/bin/env python3
"""numpy_round_trip.py write FOLDER: positions in every layout that NumPy writes.
numpy_round_trip.py check FILE.npz FILE.npy: those that Abrazo wrote have what the first .npz of FOLDER has."""
import sys

import numpy as np


def positions():
    """Numbers that both precisions hold exactly, of a column that stands 1.75 units tall."""
    frames, joints = np.meshgrid(np.arange(5), np.arange(25), indexing="ij")
    return np.stack([joints / 64 + frames / 8, joints / 16, frames / 32 - joints / 128], axis=2)


def write(folder):
    a = positions()
    names = np.array([f"point{j}" for j in range(25)])
    for number, dtype in enumerate(["<f4", "<f8", ">f4", ">f8"]):
        for order in "CF":
            b = np.array(a, dtype=dtype, order=order)
            np.save(f"{folder}/{number}{order}.npy", b)
            np.savez(f"{folder}/{number}{order}.npz", positions=b, joint_names=names, fps=np.float32(24.5), up="z",
                     metres_per_unit=0.5)
            np.savez_compressed(f"{folder}/{number}{order}c.npz", person1=b, person2=b + 1, joint_names=names,
                                fps=np.array([30]), up=np.array(["Y"]))


def check(archive, array):
    data = np.load(archive)
    assert set(data.files) == {"positions", "joint_names", "fps", "up", "metres_per_unit"}, data.files
    assert data["positions"].dtype == np.float64 and np.array_equal(data["positions"], positions())
    assert np.array_equal(np.load(array), positions())
    assert data["joint_names"][0] == "root" and len(data["joint_names"]) == 25
    assert data["fps"] == 24.5 and str(data["up"]) == "y" and data["metres_per_unit"] == 1


write(sys.argv[2]) if sys.argv[1] == "write" else check(*sys.argv[2:])
