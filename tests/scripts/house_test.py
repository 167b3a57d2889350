"""The checks of the source tree find the faults they look for. usage: house_test.py TOOLS_DIRECTORY"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))

import check_architecture  # noqa: E402
import check_files  # noqa: E402
import check_includes  # noqa: E402
import check_sources  # noqa: E402


class Checks(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def assertFinds(self, problems, *words):
        """One problem for each word, in order."""
        self.assertEqual(len(problems), len(words), problems)
        for problem, word in zip(problems, words):
            self.assertIn(word, problem)

    def test_includes(self):
        self.write("src/scree/app/main.cpp", '#include "scree/physics/vec.h"\n#include <vector>\n')
        self.write("src/scree/data/walls.h", '#include "scree/physics/touch/wall.h"\n')
        self.write("src/scree/physics/device.h", "#include <math.h>\n")
        self.assertFinds(check_includes.check(self.root))
        self.write("src/scree/input/case.h", '#include "scree/particles/fields.h"\n')
        self.write("src/scree/kernels/move.h", ' # include "scree/base/error.h"\n')
        self.write("src/scree/output/frames.h", '#include "series.h"\n')
        self.write("src/scree/physics/vec.h", "// a vector\n#include <cmath>\n")
        self.write("src/scree/stuff/odds.h", "")
        self.assertFinds(check_includes.check(self.root), "input/ may not include particles/",
                         "kernels/ may not include base/", "series.h", ":2: <cmath>", "stuff/ is no layer")

    def test_files(self):
        self.write("src/good.h", "// A header.\n#pragma once\n")
        self.write("src/good.cpp", '#include "good.h"\n')
        self.write("tools/good.py", "x = 1\n" * check_files.LONGEST)
        self.assertFinds(check_files.check(self.root))
        self.write("src/alone.cpp", "int x;\n")
        self.write("src/open.h", "// No guard.\n")
        self.write("tools/good.py", "x = 1\n" * (check_files.LONGEST + 1))
        self.assertFinds(check_files.check(self.root), "alone.cpp:1", "open.h:1: a header without", "good.py:601")

    def test_architecture(self):
        text = "# Layers\n```\nsrc/scree/   the program\n  base/      errors\n  physics/   formulas\n    drag/  laws\n```\n"
        self.write("src/scree/base/error.h", "")
        self.write("src/scree/physics/drag/drag.h", "")
        self.write("ARCHITECTURE.md", text + "See `physics/drag/drag.h`, `src/scree/base/`, `physics/*/drag.h` and `a + b`.\n")
        self.assertFinds(check_architecture.check(self.root))
        self.write("src/scree/output/frames.h", "")
        self.write("ARCHITECTURE.md", text.replace("errors", "errors\n  data/  arrays") + "See `base/gone.h`.\n" + "\n" * 150)
        self.assertFinds(check_architecture.check(self.root), "longer than", "src/scree/output/ is not in the list",
                         "src/scree/data/ is listed and does not exist", "base/gone.h")

    def test_sources(self):
        self.write("docs/files.md", "| `contacts`, `max_overlap` | 1 | |\n")
        self.write("tests/unit/law_test.cpp", "TEST(Law, Holds) {\nTEST_P(Law, HoldsFor) {\n")
        self.write("verify/01_drag/case.toml", '[verify]\n[[verify.plots]]\ntitle = "Speed"\n')
        good = ("| 1 | tests `Law.Holds`, `Law.HoldsFor`; case `01_drag`; plot `01_drag: Speed` |\n"
                "| 2 | columns `contacts` and `max_overlap`; file `docs/files.md`; later: more |\n")
        self.write("docs/sources.md", good)
        program = "/bin/false"  # knows no key
        self.assertFinds(check_sources.check(self.root, program))
        self.write("docs/sources.md", good + "| 3 | test `Law.Breaks` |\n| 4 | plot `01_drag: Depth`, case `02_gone` |\n"
                   "| 5 | key `contact.magic` |\n| 6 |  |\n")
        self.assertFinds(check_sources.check(self.root, program), ":6: no answer", "Law.Breaks", "Depth", "02_gone", "magic")


if __name__ == "__main__":
    unittest.main()
