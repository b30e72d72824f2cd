"""The wheel that `pip install .` makes, of this build folder: it holds the module, and imports from anywhere."""

import base64
import csv
import hashlib
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

sys.path.insert(0, os.path.join(os.environ["ABRAZO_SOURCE_DIR"], "packaging", "python"))
import cmake_wheel


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="abrazo_wheel_")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        name = cmake_wheel.build_wheel(folder.name, {"build-dir": os.environ["ABRAZO_BUILD_DIR"]})
        cls.wheel = zipfile.ZipFile(cls.folder / name)
        cls.addClassCleanup(cls.wheel.close)

    def test_is_named_for_this_python(self):
        self.assertRegex(os.path.basename(self.wheel.filename), r"^abrazo-[\d.]+-cp3\d+-cp3\d+-linux_\w+\.whl$")

    def test_holds_the_module_its_stubs_and_the_licence(self):
        names = {name.split("/", 1)[1] for name in self.wheel.namelist()}
        self.assertLessEqual({"__init__.py", "__init__.pyi", "py.typed", "METADATA", "WHEEL", "RECORD", "LICENSE"}, names)
        self.assertEqual(len([name for name in names if name.startswith("_abrazo.cpython")]), 1)
        self.assertIn("abrazo-scene-reader", names)
        self.assertEqual(len(names), 9)

    def test_lets_what_reads_scenes_be_started(self):
        mode = self.wheel.getinfo("abrazo/abrazo-scene-reader").external_attr >> 16
        self.assertEqual(mode & 0o777, 0o755)

    def test_records_every_file_with_its_sum(self):
        record = next(name for name in self.wheel.namelist() if name.endswith("/RECORD"))
        rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(self.wheel.read(record).decode()))}
        self.assertEqual(set(rows), set(self.wheel.namelist()))
        for name, (digest, size) in rows.items():
            if name == record:
                continue
            content = self.wheel.read(name)
            expected = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            self.assertEqual((digest, int(size)), (f"sha256={expected}", len(content)))

    def test_says_what_pyproject_says(self):
        metadata = cmake_wheel.metadata()
        project = pathlib.Path(os.environ["ABRAZO_SOURCE_DIR"], "pyproject.toml").read_text()
        for line in metadata.splitlines():
            if not line.startswith(("Version", "Metadata-Version")):
                self.assertIn(line.split(": ", 1)[1], project)

    def test_imports_from_where_it_is_unpacked(self):
        place = self.folder / "site"
        self.wheel.extractall(place)
        answer = subprocess.run(
            [sys.executable, "-c", "import abrazo; print(abrazo.__file__, abrazo.__version__)"],
            env={**os.environ, "PYTHONPATH": str(place)}, cwd=self.folder, capture_output=True, text=True, check=True,
        )  # fmt: skip
        self.assertEqual(answer.stdout.split(), [str(place / "abrazo" / "__init__.py"), cmake_wheel.version()])


if __name__ == "__main__":
    unittest.main()
