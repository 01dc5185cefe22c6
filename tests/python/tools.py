# tests/python/tools.py: what the tests of the Python module share. PYTHONPATH names the module's build.
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
ASSETS = ROOT / "assets"
CHARACTERS = ROOT.parent / "shared" / "characters"
PROGRAM = os.environ.get("SINEW_PROGRAM", "")  # The command line; "" where it is not built.
sys.path.insert(0, str(ROOT / "tests" / "support"))

import numpy  # noqa: E402

import sinew  # noqa: E402


def run(*words):
    """stdout of the command line."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError("%s: exit %d\n%s" % (words, done.returncode, done.stderr))
    return done.stdout


def needs_program(test):
    return unittest.skipUnless(PROGRAM, "left out: what the command line writes, it is not built")(test)


def bits(array):
    return numpy.ascontiguousarray(array).tobytes()


class Case(unittest.TestCase):
    """With a folder of its own, and the bundled man."""

    @classmethod
    def setUpClass(cls):
        cls.rig = sinew.load_rig(ASSETS / "humanoid.rig.json")
        cls.rig.detail, cls.rig.depth = "uniform", 2
        cls.character = cls.rig.character
        cls.smoother = sinew.Smoother(cls.character, cls.rig)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refusal(self, what, *arguments, **named):
        """The sinew.Error of a call, which must be a sentence on one line."""
        with self.assertRaises(sinew.Error) as caught:
            what(*arguments, **named)
        error = caught.exception
        self.assertNotIn("\n", str(error))
        self.assertGreater(len(error.reason.split()), 2, str(error))
        self.assertEqual(str(error), ": ".join(part for part in (error.file, error.place, error.reason) if part))
        return error

    def same_bits(self, one, other):
        self.assertEqual(one.shape, other.shape)
        self.assertEqual(one.dtype, other.dtype)
        self.assertTrue(bits(one) == bits(other), "the arrays differ")


def main():
    """Says why tests were left out, and exits 77 where all were."""
    program = unittest.main(exit=False, verbosity=0)
    for reason in sorted({reason for _, reason in program.result.skipped} - {""}):
        print(reason)
    if not program.result.wasSuccessful():
        sys.exit(1)
    sys.exit(77 if program.result.testsRun == len(program.result.skipped) else 0)
