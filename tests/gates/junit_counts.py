"""Prints "passed failed skipped" of a ctest JUnit file.

Skipped is only what said so itself (GTEST_SKIP, exit status 77, DISABLED_ in its name). A test that ctest
could not run, such as one whose program is missing, is a failure.
"""
import sys
import xml.etree.ElementTree as ElementTree

STATES = ("passed", "failed", "skipped")


def state_of(case):
    skip = case.find("skipped")
    if case.get("status") == "run" and skip is None and case.find("failure") is None:
        return "passed"
    if case.get("status") == "disabled" or (skip is not None and skip.get("message", "").startswith("SKIP_")):
        return "skipped"
    return "failed"


def cases(path):
    """(name, state) of each test."""
    return [(case.get("name"), state_of(case)) for case in ElementTree.parse(path).getroot().iter("testcase")]


def counts(path):
    states = [state for _name, state in cases(path)]
    return tuple(states.count(state) for state in STATES)


if __name__ == "__main__":
    try:
        print(*counts(sys.argv[1]))
    except (OSError, ElementTree.ParseError) as error:
        sys.exit(f"{sys.argv[1]}: no test results ({error})")
