"""Build backend of pyproject.toml (PEP 517): a wheel of what CMake installs as the component `python`.

pip install .                                          builds the engine in a folder of its own
pip install . --config-settings=build-dir=FOLDER       takes what was built in a folder, such as build/release
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version():
    return re.search(r"project\(abrazo VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def metadata():
    return (
        f"Metadata-Version: 2.1\nName: abrazo\nVersion: {version()}\n"
        "Summary: Virtual partner for close interactions, from recorded pairs and their interaction meshes\n"
        "License: AGPL-3.0-or-later\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.20\n"
    )


def build(folder):
    """Builds the module for this Python."""
    configure = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    configure += ["-DABRAZO_WORKBENCH=OFF", "-DABRAZO_TESTS=OFF", "-DABRAZO_PYTHON=ON"]
    subprocess.run([*configure, f"-DPython_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "abrazo_python"], check=True)


def record_row(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def info_folder():
    return f"abrazo-{version()}.dist-info"


def write_wheel(package, folder):
    """The wheel of an installed package: its files, and what pip wants to know of it."""
    info = info_folder()
    files = [file for file in sorted(package.iterdir()) if file.is_file()]
    contents = {f"abrazo/{file.name}": file.read_bytes() for file in files}
    programs = {f"abrazo/{file.name}" for file in files if os.access(file, os.X_OK)}
    contents[f"{info}/METADATA"] = metadata().encode()
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    contents[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: cmake_wheel\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    record = "".join(record_row(name, content) for name, content in contents.items())
    contents[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    name = f"abrazo-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            entry = zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if path in programs else 0o100644) << 16
            wheel.writestr(entry, content)
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Of PEP 517: without building."""
    info = pathlib.Path(metadata_directory, info_folder())
    info.mkdir()
    (info / "METADATA").write_text(metadata())
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Of PEP 517: the name of the wheel that was written."""
    given = (config_settings or {}).get("build-dir")
    with tempfile.TemporaryDirectory(prefix="abrazo_wheel_") as temporary:
        folder = pathlib.Path(given or temporary, "" if given else "build").resolve()
        staging = pathlib.Path(temporary, "installed")
        if not given:
            build(folder)
        install = ["cmake", "--install", folder, "--prefix", staging, "--component", "python", "--strip"]
        subprocess.run(install, check=True)
        return write_wheel(next(staging.rglob("__init__.py")).parent, wheel_directory)


def build_sdist(sdist_directory, config_settings=None):
    """Of PEP 517: the repository itself is what is built from."""
    raise NotImplementedError("there is no source distribution; build from a clone of the repository")
