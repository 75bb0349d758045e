"""Prints a header with its plain comments as Doxygen's: those at the head are of the file, those above a declaration and
those behind one are of it. Lines keep their numbers. `doxygen gpu/Doxyfile` runs it."""
import re
import sys

ABOVE = re.compile(r"^(\s*)//(?!/)(.*)$")
BEHIND = re.compile(r"^(\s*[^\s/].*?)\s{2,}//(?!/)(.*)$")


def plain(text):
    """Angle brackets and commands would be markup."""
    return re.sub(r"([\\@<>#%&])", r"\\\1", text)


# float x, y;  // of both
SEVERAL = re.compile(r"^(\s*)((?:const )?[\w:]+(?:<\w+>)?) (\*?\w+(?: = [\w.:]+)?(?:, \*?\w+(?: = [\w.:]+)?)+);$")


def filtered(line):
    above, behind = ABOVE.match(line), BEHIND.match(line)
    if above:
        return f"{above.group(1)}///{plain(above.group(2))}"
    several = behind and SEVERAL.match(behind.group(1))
    if several:
        indent, kind, names = several.groups()
        return indent + " ".join(f"{kind} {name}; /**<{plain(behind.group(2))} */" for name in names.split(", "))
    if behind:
        return f"{behind.group(1)}  ///<{plain(behind.group(2))}"
    return r"/// \file" if line == "#pragma once" else line  # it follows the head, and ends it


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as header:
        print("\n".join(filtered(line) for line in header.read().split("\n")))
