"""What pages link to exists, headings included, and so do the files they name in `backticks`, and every page of docs/ that a
source, a text or a tool names."""
import re
from pathlib import Path

import gate_tools

LINK = re.compile(r"\]\(([^)\s]+)\)")
NAMED = re.compile(r"(?<![\w./-])docs/[\w./-]*\.(?:md|json|png|svg)\b")
# `game/sim/step.cu`, `render/sprite_pass.*`; not `replays/NAME.gwr`, which stands for others.
FILE = re.compile(r"`((?:gpu|render|host|game|labs|bench|assets|tools|tests|replays|docs|cmake|findings)/[\w./*-]+)`")
PLACEHOLDER = re.compile(r"[A-Z]{2}")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
# Bytes that stay as they are; texts in a template are relative to the page that is made of it.
LEFT_OUT = ("tests/fuzz/regressions/", "tests/data/", "bench/results/epyc-2-cores/profile/")
# History, and keys that stay when files move (tests/gates/kernel_files.py).
NAMES_OTHERS = ("CHANGELOG.md", "docs/results/mutants.md", "bench/results/")
TEMPLATES = {"tools/enemies_template.md": "docs/reference/enemies.md"}


def anchors(text):
    """As GitHub makes them of headings."""
    found = set()
    for heading in re.findall(r"^#+ +(.*)$", FENCE.sub("", text), re.MULTILINE):
        heading = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        found.add(re.sub(r"[^\w\- ]", "", heading).replace(" ", "-"))
    return found


def broken_links(source, name, text):
    page = source / TEMPLATES.get(name, name)
    for number, line in enumerate(FENCE.sub(lambda m: "\n" * m.group().count("\n"), text).split("\n"), 1):
        for file in FILE.findall(line):
            if not (name.startswith(NAMES_OTHERS) or PLACEHOLDER.search(file) or next(source.glob(file), None)):
                yield f"{name}:{number}: names {file}, which is not there"
        for target in LINK.findall(line):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            file = page.parent / path if path else source / name
            if not file.exists():
                yield f"{name}:{number}: links to {target}, which is not there"
            elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text()):
                yield f"{name}:{number}: links to {target}, and no heading there is called so"


def check(source, _build):
    offences, looked_at = [], 0
    for name in gate_tools.repository_files(source):
        if name.startswith(LEFT_OUT):
            continue
        try:
            text = (source / name).read_text()
        except UnicodeDecodeError:
            continue
        looked_at += 1
        if name.endswith(".md"):
            offences += broken_links(source, name, text)
        for number, line in enumerate(text.split("\n"), 1):
            offences += [f"{name}:{number}: names {path}, which is not there" for path in NAMED.findall(line)
                         if not (source / path).exists()]
    print(f"{looked_at} files looked at")
    if not looked_at:
        offences.append("no file was found")
    return offences


def planted(build, folder):
    (folder / "docs").mkdir()
    # In pieces, so that this file passes itself.
    gone, page = "docs/" + "gone.md", "docs/" + "page.md"
    (folder / page).write_text("# One\n## `a` and b\n[x](missing.md) [y](page.md#none)\n[z](#a-and-b) [w](https://a.b/c)\n"
                                    "`game/gone.*` `{page}` `replays/NAME.gwr`\n".replace("{page}", page))
    (folder / "a.cpp").write_text(f"// see {gone}\n// see {page} and other/{gone}\n")
    offences = check(folder, build)
    escaped = gate_tools.escaped("planted link", offences, ["page.md:3: links to missing.md", "page.md:3: links to page.md#none",
                                                            "a.cpp:1: names", "page.md:5: names game"])
    return escaped + [f"refused for nothing: {o}" for o in offences if "page.md:4" in o or "a.cpp:2" in o or "NAME" in o]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
