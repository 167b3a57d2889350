"""The command line: suggestions, options with units, a run in pieces by one line. usage: command_line_test.py PROGRAM"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAUSED = 5

CASE = """
[simulation]
end = "0.5 ms"
time_step = "0.02 ms"

[domain]
min = [0, 0, 0]
max = [0.1, 0.1, 0.1]

[gravity]
type = "uniform"
acceleration = [0, 0, -9.81]

[[materials]]
name = "glass"
density = 2500
stiffness = 1000

[[particles]]
material = "glass"
diameter = "4 mm"
count = 27

[output]
series = "0.1 ms"
"""


class CommandLine(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.work = pathlib.Path(temporary.name)
        (self.work / "case.toml").write_text(CASE)

    def scree(self, *words):
        return subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=self.work)

    def refused(self, *words):
        result = self.scree(*words)
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def summary(self, directory):
        return json.loads((self.work / directory / "summary.json").read_text())

    def test_suggests_commands_and_options(self):
        self.assertEqual(self.refused("rnu", "case.toml"),
                         "scree: error[E190]: unknown command 'rnu'\n      = help: did you mean 'run'?   (scree --help)\n")
        self.assertEqual(self.refused("run", "--helpp"),
                         "scree run: error[E190]: unknown option '--helpp'\n"
                         "      = help: did you mean '--help'?   (scree run --help)\n")
        self.assertIn("did you mean '--until'?", self.refused("run", "case.toml", "--untill=3"))
        self.assertIn("'twice' is one argument too many", self.refused("run", "case.toml", "twice"))
        self.assertIn("scree run: error[E190]", self.refused("run", "case.toml", "--until"))
        self.assertIn("scree run: error[E190]", self.refused("run"))
        self.assertIn("scree: error[E190]", self.refused())

    def test_what_the_documents_call_exists(self):
        texts = [p for pattern in ("*.md", "docs/**/*.md", "bench/*.md", "examples/*/README.md", "examples/*/case.toml",
                                   "verify/**/case.toml") for p in SOURCE.glob(pattern)]
        self.assertGreater(len(texts), 50)
        called = {}
        for text in texts:
            for command, words in re.findall(r"\bscree (run|check|verify|bench|plot|info|explain|new)\b([^`\n#]*)", text.read_text()):
                for option in re.findall(r"\s(--[a-z][a-z-]*)", words):
                    called.setdefault((command, option), text.relative_to(SOURCE))
        self.assertGreater(len(called), 10)
        for (command, option), text in sorted(called.items()):
            self.assertRegex(self.scree(command, "--help").stdout, rf"{option}\b", f"{text}: scree {command} {option}")

    def test_the_long_cases_of_the_verification_book_are_there(self):
        self.assertIn("there are: 01_cavity, ", self.refused("verify", "--long", "nothing"))

    def test_help_is_a_word_too(self):
        self.assertEqual(self.scree("help").stdout, self.scree("--help").stdout)
        self.assertEqual(self.scree("help", "run").stdout, self.scree("run", "--help").stdout)
        self.assertIn("unknown command 'rnu'", self.refused("help", "rnu"))

    def test_help_and_version_are_no_errors(self):
        for words in (["--help"], ["run", "--help"], ["--version"]):
            self.assertEqual(self.scree(*words).returncode, 0)

    def test_options_take_units_and_name_their_range(self):
        result = self.scree("run", "case.toml", "--quiet", "-o", "run", "--until", "0.2 ms", "--threads", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertAlmostEqual(self.summary("run")["time"], 2e-4)
        self.assertIn("--until 2 mm: error[E120]", self.refused("run", "case.toml", "--until", "2 mm"))
        self.assertIn("'--threads' must be from 1 to", self.refused("run", "case.toml", "--threads", "0"))
        self.assertIn("'--threads' must not be negative", self.refused("run", "case.toml", "--threads", "-1"))
        self.assertIn("'--rounds' must be a whole number", self.refused("bench", "--rounds", "many"))

    def test_one_line_does_a_run_in_pieces(self):
        whole = self.scree("run", "case.toml", "--quiet", "-o", "whole")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        line = ("run", "case.toml", "-o", "run", "--threads", "1", "--wall-time", "1 us")
        first = self.scree(*line)
        self.assertEqual(first.returncode, PAUSED, first.stderr)
        self.assertEqual(self.summary("run")["status"], "paused")
        second = self.scree(*line)
        self.assertIn("the run in 'run' goes on from its checkpoint at t = 2e-05 s\n", second.stderr)
        self.assertEqual(self.summary("run")["first_step"], 1)
        codes = [self.scree(*line, "--quiet").returncode for piece in range(23)]
        self.assertEqual(codes, 22 * [PAUSED] + [0])
        self.assertEqual(self.summary("run")["state_hash"], self.summary("whole")["state_hash"])
        again = self.scree(*line)
        self.assertEqual(again.returncode, 0)
        self.assertIn("the run in 'run' has come to its end; --force begins it anew", again.stderr)

    def test_a_restart_goes_on_where_its_checkpoint_lies(self):
        self.scree("run", "case.toml", "--quiet", "-o", "first", "--until", "0.2 ms")
        result = self.scree("run", "case.toml", "--quiet", "--restart", "first")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.summary("first")["first_step"], 10)
        self.assertFalse((self.work / "runs").exists())
        refusal = self.refused("run", "case.toml", "--restart", "first", "--set", "materials.glass.density=2600")
        self.assertIn("materials.glass.density  was 2500, is 2600", refusal)

    def test_a_finished_run_has_nothing_to_go_on_with(self):
        self.scree("run", "case.toml", "--quiet", "-o", "run")
        before = (self.work / "run" / "series.csv").read_text()
        again = self.scree("run", "case.toml", "-o", "run", "--restart", "latest")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("the run in 'run' is already finished, at t = 0.0005 s", again.stderr)
        self.assertEqual((self.work / "run" / "series.csv").read_text(), before)
        longer = self.scree("run", "case.toml", "-o", "run", "--restart", "latest", "--until", "0.6 ms")
        self.assertEqual(longer.returncode, 0, longer.stderr)
        self.assertEqual(self.summary("run")["first_step"], 25)

    def test_a_run_begins_with_the_warnings_of_the_check(self):
        change = ("--set", 'outlets=[{name="out", type="region", min=[1, 1, 1], max=[2, 2, 2]}]')
        warning = "outlet 'out': lies outside the domain and takes no particle"
        loud = self.scree("run", "case.toml", "-o", "run", *change)
        self.assertEqual(loud.returncode, 0, loud.stderr)
        self.assertIn("warning (scree check):\n  " + warning, loud.stderr)
        self.assertNotIn("warning", self.scree("run", "case.toml", "-o", "run2", "--quiet", *change).stderr)
        self.assertNotIn("warning", self.scree("run", "case.toml", "-o", "run3").stderr)

    def test_steps_beyond_counting_are_refused(self):
        self.assertIn("--set simulation.end=1e15: error[E132]", self.refused(
            "run", "case.toml", "--set", "simulation.end=1e15", "--set", 'simulation.time_step="auto"'))
        self.assertIn("--until 1e+15: error[E132]", self.refused("run", "case.toml", "--until", "1e15"))

    def test_a_device_does_all_of_a_case_or_nothing(self):
        for command in ("check", "run"):
            told = self.refused(command, "case.toml", "--set", "contact.collision=hard", "--device", "opencl")
            self.assertIn("hard collisions are not there yet on devices", told)
            told = self.refused(command, str(SOURCE / "examples" / "20_cavity" / "case.toml"), "--device", "opencl")
            self.assertIn("flows that are solved for are not there yet on devices", told)
        self.assertIn("no such device", self.refused("check", "case.toml", "--device", "opencl:99"))

    def test_mixed_precision_is_for_devices(self):
        for command in ("check", "run"):
            told = self.refused(command, "case.toml", "--precision", "mixed")
            self.assertIn("error[E190]: mixed precision is for devices", told)
            told = self.refused(command, "case.toml", "--precision", "half", "--device", "opencl")
            self.assertIn("--precision half: error[E190]: expected double or mixed", told)

    def test_check_tells_what_a_run_writes_and_the_room_for_it(self):
        report = self.scree("check", "case.toml", "-o", "elsewhere").stdout
        self.assertRegex(report, r"writes +2 frames of [0-9.]+ kB, 6 rows of \d+ B, 1 checkpoint of [0-9.]+ kB\n")
        self.assertRegex(report, r"ok +disk +up to [0-9.]+ kB; .* are left for 'elsewhere'\n")


if __name__ == "__main__":
    unittest.main()
