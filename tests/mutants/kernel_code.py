"""What of a source file runs inside a kernel: code without comments, strings and the like, and whose body it is.

Not a parser of C++: it knows this project's own style, as clang-format leaves it (a binary operator stands between
blanks, an angle bracket of a template does not), and a test holds it to that.
"""
import re
from dataclasses import dataclass

# What a constant must not be taken from, though it stands in a body.
COMMENT_OR_LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
STATEMENTS_APART = re.compile(r"\b(?:static_assert|alignas|GW_ASSERT|assert)\s*\(")
TEMPLATE_OPENS = re.compile(r"\btemplate\s*<|(?<=\w)<(?=[\w:])")
CONSTANT_INDEX = re.compile(r"\[(?:[\s\d+*/-]|\d\w*|\bk[A-Z]\w*|\bsizeof\b|[()])*\]")
DEVICE_HEAD = re.compile(r"\bGW_(?:FN|MEMBER|BODY)\b|\boperator\(\)")
TYPE_HEAD = re.compile(r"\b(?:struct|class|union|enum(?: class)?)\s+(\w+)[^;()]*$")
FUNCTION_HEAD = re.compile(r"(operator\s*\(\)|operator\s*\S+|~?\w+)\s*\(")


def blanked(text, start, end):
    """The same text with blanks from start to end; lines stay where they are."""
    return text[:start] + re.sub(r"[^\n]", " ", text[start:end]) + text[end:]


def end_of(text, start, opening, closing):
    """Behind the bracket that closes the one at `start`; `start` itself when none does before the statement ends."""
    depth = 0
    for at in range(start, len(text)):
        if text[at] == opening:
            depth += 1
        elif text[at] == closing:
            depth -= 1
            if depth == 0:
                return at + 1
        elif text[at] in ";{" and opening == "<":
            break
    return start


def without_preprocessor(text):
    """Blanks directives, and what only the other device compiles."""
    lines, kept = text.split("\n"), []
    for line in lines:
        stripped = line.strip()
        if stripped.startswith("#if"):
            kept.append(stripped.split(None, 1)[-1].split("//")[0].strip())
        elif stripped.startswith("#else") and kept:
            kept[-1] = {"GW_ON_CUDA": "", "!GW_ON_CUDA": "GW_ON_CUDA"}.get(kept[-1], kept[-1])
        elif stripped.startswith("#endif") and kept:
            kept.pop()
        hidden = stripped.startswith("#") or "GW_ON_CUDA" in kept
        yield " " * len(line) if hidden else line


def plain_code(text):
    """The text with blanks for everything in which nothing may be changed."""
    text = COMMENT_OR_LITERAL.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    text = "\n".join(without_preprocessor(text))
    for found in STATEMENTS_APART.finditer(text):
        text = blanked(text, found.start(), end_of(text, found.end() - 1, "(", ")"))
    for found in TEMPLATE_OPENS.finditer(text):
        opens = found.end() - 1
        text = blanked(text, opens, end_of(text, opens, "<", ">"))
    for found in CONSTANT_INDEX.finditer(text):
        text = blanked(text, found.start() + 1, found.end() - 1)
    return text


@dataclass(frozen=True)
class Body:
    """A function that runs on the device: where its braces are, and who it belongs to."""
    kernel: str  # the outermost struct around it; a free function's own name
    function: str
    head: str
    start: int
    end: int


def device_bodies(text):
    """All bodies of device functions in plain code, in their order."""
    bodies, around, since = [], [], 0  # around: (kind, name, head, start)
    for at, letter in enumerate(text):
        if letter == "{":
            around.append((*kind_of(text[since:at], around), text[since:at], at + 1))
        elif letter == "}" and around:
            kind, name, head, start = around.pop()
            if kind == "function" and DEVICE_HEAD.search(head):
                types = [name for kind, name, *_ in around if kind == "type"]
                bodies.append(Body(types[0] if types else name, name, head, start, at))
        if letter in "{};":
            since = at + 1
    return sorted(bodies, key=lambda body: body.start)


def kind_of(head, around):
    """What a brace opens."""
    if any(kind in ("function", "block") for kind, *_ in around):
        return "block", ""
    found = TYPE_HEAD.search(head)
    if found:
        return "type", found.group(1)
    found = FUNCTION_HEAD.search(head)
    if found:
        return "function", found.group(1).replace(" ", "")
    return ("namespace", "") if re.search(r"\bnamespace\b", head) else ("data", "")
