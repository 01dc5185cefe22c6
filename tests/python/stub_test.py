# tests/python/stub_test.py: the stub says what the module has; what importing it takes.
import inspect
import os
import pathlib
import subprocess
import sys
import tempfile

from tools import Case, main, sinew

PACKAGE = pathlib.Path(sinew.__file__).parent
# Classes of C++ have a metaclass; what users do not make has no constructor in the stub.
KNOWN = """sinew\\.(Character|Mesh|Rig|Smoother|Surface)
sinew\\.(Mesh|Surface)\\.__init__
sinew\\._.*
"""


def python(*words, **more):
    return subprocess.run([sys.executable, *words], capture_output=True, text=True, **more)


class Stub(Case):
    @classmethod
    def setUpClass(cls):
        pass

    def test_mypy_accepts_the_stub(self):
        if python("-m", "mypy", "--version").returncode != 0:
            self.skipTest("left out: what mypy says of the stub, it is not installed")
        allowed = self.folder / "known"
        allowed.write_text(KNOWN)
        paths = dict(os.environ, MYPYPATH=str(PACKAGE.parent), PYTHONPATH=str(PACKAGE.parent))
        done = python("-m", "mypy.stubtest", "sinew", "--allowlist", allowed, "--ignore-unused-allowlist", env=paths,
                      cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        page = self.folder / "user.py"
        page.write_text("import sinew\nrig = sinew.load_rig('a')\nrig.add_muscle('m', bone=3)\n"
                        "surface: sinew.Surface = sinew.Smoother(rig.character, rig)(clip='Walk')\n"
                        "for frame in sinew.Smoother(rig.character).frames('Walk', fps='30'): frame.nothing\n")
        told = python("-m", "mypy", "--strict", page, env=paths, cwd=self.folder).stdout
        for words in ('Argument "bone"', 'Argument "fps"', 'has no attribute "nothing"', "Found 3 errors"):
            self.assertIn(words, told)

    def test_every_public_name_is_in_the_stub(self):
        """By words alone, where mypy is absent: each name, and each parameter of what is called."""
        text = (PACKAGE / "__init__.pyi").read_text()
        classes = {part.split("(")[0].split(":")[0].strip(): part.split("\ndef ")[0] for part in text.split("\nclass ")[1:]}
        for name in sinew.__all__:
            public = getattr(sinew, name)
            self.assertEqual(public.__module__, "sinew", name)
            if not inspect.isclass(public):
                self.has_parameters("\n    def ".join(text.split("\ndef ")), name, public)
                continue
            own = classes[name] + (classes["_Part"] if name in ("Muscle", "Line") else "")
            for member, value in inspect.getmembers(public):
                if not member.startswith("_") and not hasattr(ValueError, member) and not hasattr(tuple, member):
                    self.assertTrue("    def %s(" % member in own or "    %s: " % member in own, (name, member))
                    self.has_parameters(own, member, value)

    def has_parameters(self, text, name, value):
        if inspect.isfunction(value):
            self.assertTrue(value.__doc__, "%s says nothing of itself" % name)
            signature = text.split("    def %s(" % name)[1].split("->")[0]
            for parameter in inspect.signature(value).parameters:
                self.assertIn(parameter, signature, name)

    def test_package_is_marked_as_typed(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())

    def test_import_does_not_load_numpy(self):
        """NumPy comes with the first array. Printed, and only compared: machines differ."""
        code = "import time; a = time.perf_counter(); import %s; print(time.perf_counter() - a)"
        env = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")

        def best(module):
            return min(float(python("-c", code % module, env=env).stdout) for _ in range(5))
        ours, numpys = best("sinew"), best("numpy")
        print("import sinew: %.3f s, import numpy: %.3f s" % (ours, numpys))
        loaded = python("-c", "import sinew, sys; print('numpy' in sys.modules)", env=env).stdout
        self.assertEqual(loaded, "False\n")

    def test_module_exports_only_its_entry_point(self):
        """Libraries of other modules in the same interpreter do not meet what is linked here."""
        module, = PACKAGE.glob("_sinew*.so")
        told = subprocess.run(["nm", "-D", "--defined-only", module], capture_output=True, text=True)
        if told.returncode != 0:
            self.skipTest("left out: the symbols of the module, nm is not installed")
        names = [line.split()[-1] for line in told.stdout.splitlines() if line.split()[1] != "A"]
        self.assertEqual(names, ["PyInit__sinew"])
        needed = subprocess.run(["readelf", "-d", module], capture_output=True, text=True).stdout
        libraries = [line.split("[")[1].split("]")[0] for line in needed.splitlines() if "(NEEDED)" in line]
        first = next(name for name in libraries if "tinygltf" in name or "draco" in name)
        self.assertIn("tinygltf", first)
        self.assertNotIn(True, ["libpython" in name for name in libraries])

    def test_package_contains_all_files(self):
        source = pathlib.Path(__file__).resolve().parents[2] / "python" / "sinew"
        for path in source.iterdir():
            if path.is_file():
                self.assertEqual((PACKAGE / path.name).read_bytes(), path.read_bytes(), path.name)

    def test_docstrings_and_signatures_are_pythons(self):
        """help() shows signatures, not those of the layer below."""
        for name in ("load", "export", "Rig.add_muscle", "Smoother.__call__", "Character.sample"):
            target = sinew
            for part in name.split("."):
                target = getattr(target, part)
            self.assertGreater(len(inspect.signature(target).parameters), 0)
            self.assertIn(" ", inspect.getdoc(target))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as cache:
        os.environ["MYPY_CACHE_DIR"] = cache
        main()
