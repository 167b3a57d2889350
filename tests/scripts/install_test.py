"""An installed tree works from any prefix. usage: install_test.py CMAKE BUILD_DIRECTORY BIN_DIRECTORY"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE, BUILD, BIN = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.work = pathlib.Path(temporary.name)
        first, cls.prefix = cls.work / "first", cls.work / "moved to" / "another place"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", first], check=True, capture_output=True)
        cls.prefix.parent.mkdir()
        first.rename(cls.prefix)

    def scree(self, *arguments):
        result = subprocess.run([self.prefix / BIN / "scree", *map(str, arguments)], capture_output=True, text=True,
                                cwd=self.work)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def test_its_files_are_its_own(self):
        self.assertIn(str(self.prefix), self.scree("info"))

    def test_it_checks_runs_and_draws_an_example(self):
        self.scree("new", "bouncing_ball", "mine")
        self.scree("check", "mine/case.toml")
        self.scree("run", "mine/case.toml", "--until", 0.25, "--plot", "--quiet")
        summary = json.loads((self.work / "runs" / "mine" / "summary.json").read_text())
        self.assertEqual(summary["status"], "finished")
        self.assertTrue((self.work / "runs" / "mine" / "series.png").exists())

    def test_it_verifies(self):
        self.scree("verify", "22_settling", "-o", "book")
        self.assertTrue((self.work / "book" / "verify.json").exists())

    def test_it_brings_scenes_and_papers(self):
        for pattern in ("share/scree/bench/dense.toml", "share/scree/examples/*/README.md", "share/scree/share/plot.py",
                        "share/scree/verify/01_drag/case.toml", "share/doc/*/LICENSE", "share/doc/*/THIRD_PARTY.md",
                        "share/doc/*/docs/files.md"):
            self.assertTrue(list(self.prefix.glob(pattern)), pattern)
        self.assertFalse(list(self.prefix.rglob("packings")))


if __name__ == "__main__":
    unittest.main()
