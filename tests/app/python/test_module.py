"""The module itself: what it brings, what it says of itself, what it loads."""
import ast
import pathlib
import subprocess
import sys
import unittest

import abstand

FOLDER = pathlib.Path(abstand.__file__).parent


class Module(unittest.TestCase):
    def test_every_public_thing_has_a_docstring(self):
        for name in abstand.__all__:
            thing = getattr(abstand, name)
            if not callable(thing):
                continue
            self.assertTrue((thing.__doc__ or "").strip(), name)
            self.assertEqual(thing.__module__, "abstand", name)
            if not isinstance(thing, type) or issubclass(thing, Exception):
                continue
            for member, value in vars(thing).items():
                if not member.startswith("_"):
                    self.assertTrue((value.__doc__ or "").strip(), f"{name}.{member}")

    def test_the_stub_names_what_is_there(self):
        tree = ast.parse((FOLDER / "__init__.pyi").read_text())
        classes = {n.name: n for n in tree.body if isinstance(n, ast.ClassDef)}
        functions = {n.name for n in tree.body if isinstance(n, ast.FunctionDef)}
        names = {n.target.id for n in tree.body if isinstance(n, ast.AnnAssign)}
        public = set(abstand.__all__) | {"__version__"}
        self.assertEqual({n for n in classes if not n.startswith("_")} | functions | names, public)
        for name in abstand.__all__:
            thing = getattr(abstand, name)
            if not isinstance(thing, type) or issubclass(thing, Exception) or name in ("StepResult", "SceneRun"):
                continue
            members = {n for n in vars(thing) if not n.startswith("_")}
            stub = {n.name for n in classes[name].body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")}
            self.assertEqual(stub, members, name)

    def test_the_stub_names_the_arrays_of_scenes(self):
        tree = ast.parse((FOLDER / "__init__.pyi").read_text())
        arrays = next(n for n in tree.body if isinstance(n, ast.ClassDef) and n.name == "_SceneArrays")
        step = abstand.Scene(pathlib.Path(__file__).resolve().parents[3] / "data/scenes/spheres.yaml").step(0.0)
        self.assertEqual({n.target.id for n in arrays.body} | {"t"}, set(vars(step)))
        for name in vars(step):
            self.assertIn(name, abstand.StepResult.__doc__)

    def test_it_is_typed(self):
        self.assertTrue((FOLDER / "py.typed").exists())
        self.assertRegex(abstand.__version__, r"^\d+\.\d+\.\d+$")

    def test_readers_are_loaded_when_they_are_asked_for(self):
        code = ("import sys, abstand\n"
                "assert 'abstand._scene' not in sys.modules and not any('opencv' in l for l in open('/proc/self/maps'))\n"
                "abstand.Scene\nassert 'abstand._scene' in sys.modules")
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_errors(self):
        self.assertTrue(issubclass(abstand.UsageError, ValueError))
        self.assertTrue(issubclass(abstand.WriteError, OSError))
        for error in (abstand.ParseError, abstand.UsageError, abstand.WriteError):
            self.assertTrue(issubclass(error, abstand.Error))
        with self.assertRaises(AttributeError):
            abstand.nothing


if __name__ == "__main__":
    unittest.main()
