"""The stubs say what the module has, all of it and nothing else; every name has a docstring."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys
import unittest

import abrazo

STUBS = ast.parse(pathlib.Path(abrazo.__file__).with_name("__init__.pyi").read_text())
ASKED_OF_PYTHON = {"__init__", "__len__", "__next__", "__iter__"}  # others are Python's own, or for a person


def public(name):
    return not name.startswith("_")


def members(names):
    return {name for name in names if public(name) or name in ASKED_OF_PYTHON}


class Stubs(unittest.TestCase):
    def stub_classes(self):
        return {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}

    def stub_functions(self):
        return {node.name: node for node in STUBS.body if isinstance(node, ast.FunctionDef)}

    def test_name_what_the_module_has(self):
        constants = {node.target.id for node in STUBS.body if isinstance(node, ast.AnnAssign)}
        said = constants | set(self.stub_classes()) | set(self.stub_functions())
        had = {name for name in vars(abrazo) if public(name)} | {"__version__"}
        self.assertEqual(said, had)

    def test_name_the_members_of_each_class(self):
        for name, node in self.stub_classes().items():
            if name == "Error":
                continue
            own = members(vars(getattr(abrazo, name)))
            said = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            if not isinstance(getattr(abrazo, name).__init__, type(object.__init__)) or "__init__" not in said:
                own.discard("__init__")  # pybind11 gives one to each that cannot be made
            if name == "FrameIterator":
                said.add("__iter__")  # of Iterator
            self.assertEqual(said, own | ({"__init__"} & said), name)

    def test_name_the_arguments_in_their_order(self):
        def check(node, documented):
            said = [argument.arg for argument in node.args.args + node.args.kwonlyargs if argument.arg != "self"]
            signature = documented.splitlines()[0]
            had = re.findall(r"[(,] ?(\w+): ", re.sub(r"\[[^][]*\]", "", re.sub(r"\[[^][]*\]", "", signature)))
            self.assertEqual(said, [name for name in had if name != "self"], signature)

        for name, node in self.stub_functions().items():
            check(node, getattr(abrazo, name).__doc__)
        for name, node in self.stub_classes().items():
            for item in node.body:
                if isinstance(item, ast.FunctionDef) and not item.decorator_list and public(item.name):
                    check(item, getattr(getattr(abrazo, name), item.name).__doc__)

    def test_are_marked_as_such(self):
        self.assertTrue(pathlib.Path(abrazo.__file__).with_name("py.typed").exists())


class Docstrings(unittest.TestCase):
    def test_are_everywhere_where_a_name_does_not_say_all(self):
        for name, value in vars(abrazo).items():
            if not public(name) or isinstance(value, tuple):
                continue
            self.assertTrue(value.__doc__, name)

    def test_give_shape_and_unit_of_arrays(self):
        for kind in (abrazo.Clip, abrazo.Frame, abrazo.Library, abrazo.Run, abrazo.RecordedFrame):
            for name, member in inspect.getmembers(kind, lambda value: isinstance(value, property)):
                if name in ("positions", "active", "passive", "features", "selected_pair", "morph_steps", "user", "times"):
                    self.assertRegex(member.__doc__, r"^\(.*\).*\[m\]|^\(T,\) \[s\]", f"{kind.__name__}.{name}")


class Names(unittest.TestCase):
    def test_are_those_of_the_package(self):
        self.assertEqual(f"{abrazo.Clip.__module__}.{abrazo.Clip.__qualname__}", "abrazo.Clip")
        self.assertEqual(repr(abrazo.Error("x")), "Error('x')")
        self.assertEqual(abrazo.Error.__module__, "abrazo")

    def test_have_the_version_of_the_program(self):
        said = subprocess.run([os.environ["ABRAZO_PROGRAM"], "--version"], capture_output=True, text=True).stdout
        self.assertIn(abrazo.__version__, said)


class Linking(unittest.TestCase):
    def test_needs_no_toolkit_and_one_hdf5(self):
        loaded = "import abrazo; print(open('/proc/self/maps').read())"
        maps = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, check=True).stdout
        libraries = {pathlib.Path(line.split()[-1]).name for line in maps.splitlines() if ".so" in line}
        self.assertEqual([name for name in libraries if re.match(r"lib(Qt|vtk|opencv)", name)], [])
        self.assertEqual({name.split(".so")[0] for name in libraries if "hdf5" in name}, {"libhdf5_serial"})


if __name__ == "__main__":
    unittest.main()
