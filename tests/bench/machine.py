"""What a measurement was taken on: processor, load, versions. No names of hosts, and no folders."""

import os
import pathlib
import platform
import subprocess

PACKAGES = ["libbenchmark-dev", "libsuitesparse-dev", "libcgal-dev", "libtet1.5-dev", "libflann-dev", "libnanoflann-dev",
            "libeigen3-dev", "libvtk9-dev", "libgl1-mesa-dri"]


def first_line(path, key):
    try:
        with open(path) as lines:
            return next((line.split(":", 1)[1].strip() for line in lines if line.startswith(key)), "unknown")
    except OSError:
        return "unknown"


def name():
    return f"{first_line('/proc/cpuinfo', 'model name')}, {len(os.sched_getaffinity(0))} cores, Linux {platform.release().split('-')[0]}"


def load():
    return "%.2f %.2f %.2f" % os.getloadavg()


def packages():
    found = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${Version}, ", *PACKAGES], capture_output=True, text=True)
    return found.stdout.rstrip(", ") or "unknown"


def revision(root):
    found = subprocess.run(["git", "-C", root, "describe", "--always", "--dirty"], capture_output=True, text=True)
    return found.stdout.strip() or "unknown"


def command_line(words):
    """Words without the folders of absolute paths: what someone else would type."""
    return " ".join(pathlib.Path(word).name if word.startswith("/") else word for word in map(str, words))
