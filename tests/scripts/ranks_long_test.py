"""Ten thousand steps of dense crowds that slosh from rank to rank. usage: ranks_long_test.py PROGRAM MPIEXEC"""

import time
import unittest

from ranks_common import Ranks

STEPS = 10000
# Whoever lies in the trough goes round it, over all cut planes, which follow the crowd.
TROUGH = """
[simulation]
end = END
time_step = STEP
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.04, 0.03, 0.05]
periodic = [true, false, false]
[gravity]
type = "expression"
expression = ["12 * sin(25 * t)", "9 * cos(17 * t)", "-9.81"]
[contact]
CONTACT
[[materials]]
name = "glass"
density = 2000
MATERIAL
restitution = 0.8
friction = 0.4
[[particles]]
name = "grains"
material = "glass"
diameter = { distribution = "uniform", min = "3 mm", max = "5 mm" }
insert = "random"
count = COUNT
velocity = { type = "random", deviation = 0.3 }
region_min = [0, 0, 0.001]
region_max = [0.04, 0.03, 0.04]
[[walls]]
name = "trough"
type = "box"
material = "glass"
min = [-0.04, 0, 0]
max = [0.08, 0.03, 0.05]
[output]
series = SERIES
"""


def case(step, count, contact, material):
    return (TROUGH.replace("END", str(STEPS * step)).replace("STEP", str(step)).replace("COUNT", str(count))
            .replace("CONTACT", contact).replace("MATERIAL", material).replace("SERIES", str(STEPS * step / 10)))


SOFT = case(2e-5, 250, 'rolling = "spring"', "stiffness = 500\nrolling_friction = 0.02")
# Every sweep is as many messages as there are colours, and where ranks outnumber the processors each waits for its turn.
HARD = case(1e-4, 80, 'collision = "hard"\n[hard]\nsweeps = 10', "")


class TenThousandSteps(Ranks):
    def same_bits(self, text):
        found = {}
        for ranks in (1, 2, 3, 4, 8):
            begin = time.monotonic()
            summary = self.run_on(ranks, text, f"on{ranks}", threads=1 + ranks % 2)
            self.assertEqual(summary["steps"], STEPS)
            found[ranks] = [summary[key] for key in ("state_hash", "contacts", "wall_contacts", "ledger")]
            print(f"{ranks} ranks: {found[ranks][0][:16]}, {found[ranks][1]} contacts, {summary['sharing']}, "
                  f"{time.monotonic() - begin:.0f} s", flush=True)
            self.assertEqual(found[ranks], found[1], ranks)
            self.same_files("on1", f"on{ranks}")
        self.assertGreater(found[1][1] + found[1][2], 0.3 * STEPS * summary["particles"])  # dense

    def test_soft_contact(self):
        self.same_bits(SOFT)

    def test_hard_collisions(self):
        self.same_bits(HARD)


if __name__ == "__main__":
    unittest.main()
