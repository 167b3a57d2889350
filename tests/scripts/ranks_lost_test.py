"""Particles that go far in one step, particles wider than blocks, and those that are lost. usage: ranks_lost_test.py PROGRAM MPIEXEC"""

import csv
import unittest

from ranks_common import Ranks

# A row of beads from end to end, in as many blocks as there are ranks, and what comes to them.
ROW = """
[simulation]
end = END
time_step = 1e-4
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.8, 0.02, 0.02]
periodic = [true, false, false]
[[materials]]
name = "soft"
density = 1000
stiffness = 1
restitution = 0.9
friction = 0.3
[[particles]]
name = "beads"
material = "soft"
diameter = "4 mm"
insert = "positions"
positions = [BEADS]
[output]
series = "1 ms"
frames = "5 ms"
"""
BEADS = ", ".join(f"[{0.0125 + 0.025 * k}, 0.01, 0.01]" for k in range(32))


def group(name, positions, more):
    return (f'[[particles]]\nname = "{name}"\nmaterial = "soft"\ninsert = "positions"\npositions = {positions}\n{more}\n')


def row(end, more):
    return ROW.replace("END", str(end)).replace("BEADS", BEADS) + more


class LostParticles(Ranks):
    def same_on(self, case, *ranks):
        alone = self.run_on(0, case, "alone")
        for n in ranks:
            self.assertEqual(self.run_on(n, case, f"on{n}")["state_hash"], alone["state_hash"], n)
            self.same_files("alone", f"on{n}")
        return alone

    def test_one_that_crosses_several_blocks_in_a_step_is_found(self):
        # Blocks of eight ranks are 0.1 m wide, 3170 m/s are 0.317 m in a step; and there is a bead in the way.
        bullet = group("bullet", "[[0.05, 0.0113, 0.01]]", 'diameter = "4 mm"\nvelocity = [3170, 0, 0]')
        alone = self.same_on(row(0.02, "tracks = [32]\n" + bullet).replace("0.02, 0.02]", "0.2, 0.02]"), 2, 3, 8)
        self.assertGreater(alone["contacts"], 0)
        with open(self.work / "alone" / "tracks.csv") as file:
            speeds = [float(line["vx"]) for line in csv.DictReader(file)]
        self.assertGreater(min(speeds) * 1e-4, 0.3)

    def test_particles_may_be_wider_than_blocks(self):
        # Blocks of eight ranks are 0.1 m wide.
        balloon = group("balloon", "[[0.41, 0.01, 0.2275]]", 'diameter = "0.43 m"\nvelocity = [0.1, 0, -0.1]')
        tall = row(0.03, balloon).replace("max = [0.8, 0.02, 0.02]", "max = [0.8, 0.02, 0.5]")
        alone = self.same_on(tall.replace("periodic = [true, false, false]", "periodic = [false, false, false]"), 2, 8)
        self.assertGreater(alone["contacts"], 100)

    def stopped(self, case, *ranks):
        """What is told of a run that stops, once and alike on any number of ranks."""
        alone = self.scree(0, case, "alone")
        self.assertEqual(alone.returncode, 3, alone.stderr)
        told = alone.stderr.splitlines()[0]
        for n in ranks:
            shared = self.scree(n, case, f"on{n}")
            self.assertEqual(shared.returncode, 3, shared.stderr)
            self.assertEqual(shared.stderr.count(told), 1, (told, shared.stderr))
            self.assertEqual(shared.stderr.count("m/s"), 1, shared.stderr)
            self.same_files("alone", f"on{n}")
        return told

    def test_one_that_leaves_a_closed_domain_stops_the_run(self):
        # Two leave in the same step, far from each other; the lower id is named.
        case = row(0.02, group("leavers", "[[0.7, 0.013, 0.013], [0.1, 0.013, 0.013]]", 'diameter = "1 mm"\nvelocity = [0, 0, 1]'))
        told = self.stopped(case, 2, 3, 8)
        self.assertIn("particle 32 at (0.7, 0.013, 0.02", told)
        self.assertIn("has left the domain through its upper z face", told)

    def test_one_that_is_nowhere_is_named_with_its_last_place(self):
        push = '[gravity]\ntype = "expression"\nexpression = ["t > 0.0123 && x > 0.5 ? 1e300 : 0", "0", "0"]\n'
        told = self.stopped(row(0.02, push), 2, 3)
        self.assertIn("the motion of particle 20 at", told)  # the first of twelve
        self.assertIn("is no longer finite. It was at (0.5125, 0.01, 0.01) m at t = 0.012 s", told)


if __name__ == "__main__":
    unittest.main()
