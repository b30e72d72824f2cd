"""A generated dance with its library, made once for each test program in a folder of its own."""

import atexit
import functools
import os
import pathlib
import shutil
import subprocess
import tempfile

import abrazo

PROGRAM = os.environ["ABRAZO_PROGRAM"]


@functools.cache
def folder():
    """Where the dance is: demo/ with its manifest and motions, demo.h5."""
    path = pathlib.Path(tempfile.mkdtemp(prefix="abrazo_python_"))
    atexit.register(shutil.rmtree, path, ignore_errors=True)
    command_line("demo", "-o", path / "demo", "--seed", "3", "--minutes", "0.5")
    command_line("library", "build", path / "demo" / "manifest.json", "-o", path / "demo.h5")
    return path


def command_line(*words):
    """Runs abrazo; what it printed."""
    return subprocess.run([PROGRAM, *map(str, words)], check=True, capture_output=True, text=True).stdout


def refusal(*words):
    """The sentence with which the command line refuses something."""
    refused = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    assert refused.returncode == 1, refused
    last = refused.stderr.strip().splitlines()[-1]
    return last.removeprefix("abrazo: ")


@functools.cache
def library():
    return abrazo.Library.open(folder() / "demo.h5")


@functools.cache
def leader():
    """The one who leads the first take, at 60 frames a second."""
    return abrazo.read_motion(leader_file())


def leader_file():
    return folder() / "demo" / "salsa_01_a.bvh"
