"""All mutants of one file: a constant, a comparison or a sign inside a kernel's code, changed."""
import hashlib
import re
import sys
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "gates"))
from kernel_code import device_bodies, plain_code  # noqa: E402
from kernel_files import key_of  # noqa: E402

NUMBER = re.compile(
    r"(?<![\w.])(?:0[xX][\da-fA-F]+(?:\.[\da-fA-F]*)?(?:[pP][+-]?\d+)?|\d+\.?\d*(?:[eE][+-]?\d+)?)([fuUlL]*)(?![\w.])")
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|<|>|\+|-|\+=|-=)(?= )")
# Constants with a name, which kernels use: only floats, since whole ones are sizes.
NAMED = re.compile(r"^(?:inline )?constexpr float (k\w+) = ([^;]+);", re.M)
SWAPPED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "+=": "-=",
           "-=": "+="}


@dataclass(frozen=True)
class Mutant:
    file: str
    offset: int
    line: int
    kind: str  # constant, comparison or arithmetic
    old: str
    new: str
    kernel: str
    function: str
    context: str  # the line of source it stands in, and its place there
    column: int
    head: str = ""  # the function's own
    nth: int = 1  # of several whose lines are the same

    @property
    def stage(self):
        """The file's own name: one stage, one idea, one file."""
        return self.file.rsplit("/", 1)[-1].split(".")[0]

    @property
    def name(self):
        """Stays when other lines change, and when the file moves."""
        who = self.function if self.function == self.kernel else f"{self.kernel}.{self.function}"
        return f"{key_of(self.file)}: {who}: {self.context} [{self.column}: {self.old} -> {self.new}]" + (
            f" no. {self.nth}" if self.nth > 1 else "")

    @property
    def rank(self):
        """Chance without chance: the order in which mutants are chosen."""
        return hashlib.sha256(self.name.encode()).hexdigest()

    def applied(self, text):
        """The file's text with the change made."""
        if text[self.offset:self.offset + len(self.old)] != self.old:
            raise ValueError(f"{self.file}:{self.line} no longer holds '{self.old}'; find the mutants again")
        return text[:self.offset] + self.new + text[self.offset + len(self.old):]


def changed_number(text):
    """Another number of the same kind: a whole one plus 1, a real one by 1 % (0 becomes 0.01)."""
    suffix = NUMBER.fullmatch(text).group(1)
    if text[:2].lower() == "0x" and "p" in text.lower():
        digits, power = re.split("[pP]", text)
        return f"{digits}p{int(power.rstrip('fF')) + 1}{suffix}"
    if text[:2].lower() == "0x":
        digits = text[2:].rstrip("uUlL")  # never f, which is a digit here
        return f"0x{int(digits, 16) ^ 1:0{len(digits)}X}{text[2 + len(digits):]}"
    digits = text[:len(text) - len(suffix)]
    if "." in digits or "e" in digits.lower():
        value = float(digits)
        changed = repr(round(value * 1.01, 12)) if abs(value) >= 1e-3 else repr(value * 1.01) if value else "0.01"
        return (changed if "." in changed or "e" in changed else changed + ".0") + suffix
    return f"{int(digits) + 1}{suffix}"


def mutants_of(file, text):
    """Every mutant of a file, in the order of its text."""
    code = plain_code(text)
    found = []

    def add(offset, kind, old, new, kernel, function, head=""):
        begin = text.rfind("\n", 0, offset) + 1
        end = text.find("\n", offset)
        line = text.count("\n", 0, offset) + 1
        found.append(Mutant(file, offset, line, kind, old, new, kernel, function,
                            " ".join(text[begin:end if end >= 0 else None].split()), offset - begin + 1, head))

    for name in NAMED.finditer(code):
        for number in NUMBER.finditer(name.group(2)):
            at = name.start(2) + number.start()
            add(at, "constant", number.group(), changed_number(number.group()), name.group(1), name.group(1))
    for body in device_bodies(code):
        inside = code[body.start:body.end]
        for number in NUMBER.finditer(inside):
            add(body.start + number.start(), "constant", number.group(), changed_number(number.group()), body.kernel,
                body.function, body.head)
        for sign in OPERATOR.finditer(inside):
            kind = "arithmetic" if sign.group()[0] in "+-" else "comparison"
            add(body.start + sign.start(), kind, sign.group(), SWAPPED[sign.group()], body.kernel, body.function,
                body.head)
    named, seen = [], Counter()
    for mutant in sorted(found, key=lambda mutant: (mutant.offset, mutant.new)):
        seen[mutant.name] += 1
        named.append(replace(mutant, nth=seen[mutant.name]))
    return named
