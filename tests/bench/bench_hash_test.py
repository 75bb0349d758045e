"""What --hash of the benches prints: the same on any number of threads, one line per scene or way, and equal among all
exact ways that search in the same frames."""

import re
import subprocess
import sys
import unittest

TICK, NEIGHBOURS = sys.argv[1:3]


def hashes(program, *options):
    """The hashes that a program prints, by what they are of."""
    run = subprocess.run([program, "--hash", *options], capture_output=True, text=True, check=True)
    return dict(re.findall(r"^hash (.+): ([0-9a-f]{16})$", run.stdout, re.MULTILINE))


class Tick(unittest.TestCase):
    def run_with(self, threads):
        return hashes(TICK, "--enemies", "256", "--rounds", "2", "--threads", threads)

    def test_is_the_same_on_any_number_of_threads(self):
        one = self.run_with("1")
        self.assertEqual(list(one), ["uniform 256", "swarm 256", "mixed 256", "horde 256"])
        self.assertEqual(len(set(one.values())), 4)  # four scenes, four games
        self.assertEqual(one, self.run_with("3"))


class Neighbours(unittest.TestCase):
    def run_with(self, threads):
        return hashes(NEIGHBOURS, "--entities", "512", "--distribution", "swarm", "--frames", "11", "--threads", threads)

    def test_exact_ways_find_the_same_on_any_number_of_threads(self):
        one = self.run_with("1")
        self.assertEqual(one, self.run_with("3"))
        found = {way.split(" ", 4)[4]: value for way, value in one.items()}
        exact = [found[way] for way in ("grid", "grid, half bins", "grid, hashed", "ngrid, bitonic", "ngrid, packed",
                                        "ngrid, frozen rows", "brute force")]
        self.assertEqual(len(set(exact)), 1)
        self.assertNotEqual(found["thesis: fixed 4, odd-even"], exact[0])  # it misses some: the hash must show it


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
