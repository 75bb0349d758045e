"""Prints "passed failed skipped" of a ctest JUnit file.

Skipped is only what said so itself (GTEST_SKIP, exit status 77, DISABLED_ in its name). A test that ctest
could not run, such as one whose program is missing, is a failure.
"""
import sys
import xml.etree.ElementTree as ElementTree


def counts(path):
    passed = failed = skipped = 0
    for case in ElementTree.parse(path).getroot().iter("testcase"):
        skip = case.find("skipped")
        if case.get("status") == "run" and skip is None and case.find("failure") is None:
            passed += 1
        elif case.get("status") == "disabled":
            skipped += 1
        elif skip is not None and skip.get("message", "").startswith("SKIP_"):
            skipped += 1
        else:
            failed += 1
    return passed, failed, skipped


if __name__ == "__main__":
    try:
        print(*counts(sys.argv[1]))
    except (OSError, ElementTree.ParseError) as error:
        sys.exit(f"{sys.argv[1]}: no test results ({error})")
