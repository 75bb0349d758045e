#!/usr/bin/env python3
"""Man pages and completion know every verb and option that --help lists, and no others.

    manual_e2e.py PROGRAM DOCUMENTS              pages and script against --help
    manual_e2e.py PROGRAM DOCUMENTS --lint       man and mandoc find nothing to warn of; 77 without either
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures, run, skip  # noqa: E402

OPTION = re.compile(r"(?<![\w-])(--?[a-z][\w-]*)")


def help_of(program, *verb):
    code, out, _ = run(program, *verb, "--help")
    if code != 0:
        raise RuntimeError(f"{verb} --help ends with {code}")
    return out


def listed_options(text):
    """Those that begin a line of --help."""
    names = re.findall(r"^  (-[^\s,]+(?:, ?-[^\s,]+)*)", text, re.MULTILINE)
    return {option for each in names for option in OPTION.findall(each)}


def terms_of(page):
    """Options that a page declares: the line after each .TP."""
    terms = re.findall(r"^\.TP\n(.*)$", page.replace("\\-", "-").replace("\\fB", " ").replace("\\fR", " "), re.MULTILINE)
    return {option for term in terms for option in OPTION.findall(term)}


def completed(script, line):
    """What bash offers for a line whose last word is being typed."""
    words = line.split(" ")
    array = " ".join(f"'{word}'" for word in words)
    code = (f". '{script}'; COMP_WORDS=({array}); COMP_CWORD={len(words) - 1}; _gpuwars; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    out = subprocess.run(["bash", "--norc", "-uc", code], stdout=subprocess.PIPE, text=True, check=True, cwd=script.parent)
    return set(out.stdout.split())


def check_verb(failures, program, documents, verb):
    text = help_of(program, verb)
    options = listed_options(text)
    page = (documents / f"man6/gpuwars-{verb}.6").read_text()
    failures.check(len(options) > 2 and terms_of(page) == options,
                   f"gpuwars-{verb}(6) has {len(options)} options of --help; not the same: {sorted(terms_of(page) ^ options)}")
    offered = completed(documents / "completions/gpuwars", f"gpuwars {verb} -")
    failures.check(offered == options, f"so has completion: {sorted(offered ^ options)}")
    for names, words in re.findall(r"^  (-\S+) ([a-z0-9-]+(?:\|[a-z0-9-]+)+)", text, re.MULTILINE):
        option = names.split(",")[-1]
        for line in (f"gpuwars {verb} {option} ", f"gpuwars {verb} {option} = "):
            found = completed(documents / "completions/gpuwars", line)
            failures.check(found == set(words.split("|")), f"'{line}' offers {words}: {sorted(found)}")


def check_files(failures, documents):
    with tempfile.TemporaryDirectory() as folder:
        script = Path(shutil.copy(documents / "completions/gpuwars", folder))
        (script.parent / "mine.gwr").touch()
        (script.parent / "other.txt").touch()
        check_words(failures, script)


def check_words(failures, script):
    failures.check(completed(script, "gpuwars replay m") == {"mine.gwr"}, "replays are offered where they are wanted")
    failures.check(completed(script, "gpuwars replay o") == set(), "and no other files")
    failures.check("other.txt" in completed(script, "gpuwars play --record o"), "but to options that take any")
    failures.check(completed(script, "gpuwars play --seed o") == set(), "and none to numbers")
    failures.check("replay" in completed(script, "gpuwars re") and "--mode" in completed(script, "gpuwars --mo"),
                   "first comes a verb, or an option of play")


def lint(failures, pages):
    commands = {"man": ["man", "--warnings", "--local-file", "-Tutf8", "-Z"], "mandoc": ["mandoc", "-T", "lint", "-W", "warning"]}
    tools = [tool for tool in commands if shutil.which(tool)]
    if not tools:
        skip("neither man nor mandoc is installed")
    for tool in tools:
        for page in pages:
            result = subprocess.run([*commands[tool], str(page)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                    check=False)
            said = result.stderr + (result.stdout if tool == "mandoc" else "")
            failures.check(result.returncode == 0 and not said.strip(), f"{tool}: {page.name} {said.strip()}")


def main():
    program, documents = sys.argv[1], Path(sys.argv[2]).resolve()
    failures = Failures()
    pages = sorted((documents / "man6").iterdir())
    if "--lint" in sys.argv:
        lint(failures, pages)
        failures.finish()
    text = help_of(program)
    verbs = re.findall(r"^  (\w+) ", text.split("Verbs:")[1], re.MULTILINE)
    wanted = {"gpuwars.6"} | {f"gpuwars-{verb}.6" for verb in verbs}
    failures.check({page.name for page in pages} == wanted, f"a page for each of {len(verbs)} verbs")
    main_page = (documents / "man6/gpuwars.6").read_text().replace("\\-", "-")
    failures.check(all(f"\\fB{verb}\\fR" in main_page for verb in verbs), "gpuwars(6) lists them")
    usual, signals = text.split("Exit codes: ")[1].strip().rstrip(".").split(";\n")
    exits = [exit.split(" ", 1) for exit in usual.split(", ")] + [("128 + N", signals.removeprefix("128 + N "))]
    for code, meaning in exits:
        failures.check(f".B {code}\n{meaning}" in main_page, f"and exit code {code}: {meaning}")
    for verb in verbs:
        check_verb(failures, program, documents, verb)
    check_files(failures, documents)
    failures.finish()


if __name__ == "__main__":
    main()
