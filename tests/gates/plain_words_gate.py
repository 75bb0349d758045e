"""Comments, messages and pages are in plain technical English: a few words that the tree once used for everything are refused."""
import re

import gate_tools

# The one list: what is refused, as whole words, and what to write.
PLAIN = {
    "nobody": "no one, none, nothing, or what is absent: 'unused', 'unseen', 'free ids'",
    "somebody": "who it is: a player, a caller, another program",
    "anybody": "any entity, any user",
    "everybody": "all, every entity",
    "whoever": "who it is: the caller, the last block to arrive",
    "whom": "another construction: 'the neighbours found', 'the caller'",
    "anew": "again, or the verb with re-: rebuild, repack, rewrite",
    "at hand": "here, this, available",
    "beforehand": "before, in advance",
    "(?:is|are|was|were|be|been) felt": "has an effect, changes the result, is noticed",
    "(?:is|are|was|were|be|been) said": "is reported, is printed, is documented",
}
WORDS = re.compile(r"(?<![\w/.'-])(" + "|".join(word.replace(" ", r"\s+") for word in PLAIN) + r")(?!\w|\.(?:gwr|expect))",
                   re.IGNORECASE)
EXEMPT = ()  # folders that have not been gone through
# Texts that reports keep and comparisons read (contender_choice.cpp), other people's words, bytes that stay as they are, and this list.
LEFT_OUT = ("LICENSE", "cmake/packages/debian/copyright", "tests/gates/plain_words_gate.py", "tests/data/", "tests/fuzz/corpus/",
            "tests/fuzz/regressions/", "bench/results/epyc-2-cores/profile/", "replays/golden.", "game/profile/session/contender_choice.cpp")
LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def words_of(name, text):
    """The text with all that is not for readers blanked: code, and names in `backticks`."""
    if name.endswith(gate_tools.SOURCE_SUFFIXES):
        shown, end = [], 0
        for match in LITERAL.finditer(text):
            shown += [re.sub(r"[^\n]", " ", text[end:match.start()]), match.group()]
            end = match.end()
        text = "".join(shown)
    return re.sub(r"`[^`\n]*`", lambda m: " " * len(m.group()), text)


def advice(word):
    return next(plain for refused, plain in PLAIN.items()
                if re.fullmatch(refused.replace(" ", r"\s+"), word, re.IGNORECASE))


def check(source, _build, exempt=EXEMPT):
    offences, looked_at = [], 0
    for name in gate_tools.repository_files(source):
        if name.startswith(LEFT_OUT + tuple(exempt)):
            continue
        try:
            text = words_of(name, (source / name).read_text())
        except UnicodeDecodeError:
            continue
        looked_at += 1
        for match in WORDS.finditer(text):
            word = " ".join(match.group(1).split())
            offences.append(f"{name}:{text.count(chr(10), 0, match.start()) + 1}: '{word}': write {advice(word)}")
    print(f"{looked_at} files looked at; exempt: {' '.join(exempt) or 'none'}")
    if not looked_at:
        offences.append("no file was found")
    return offences


def planted(build, folder):
    refused = {"a.cpp": "int someBody;  // Whoever comes\n", "b.md": "a run\nthat differs is\nsaid\n", "c.py": '"""Made anew."""\n',
               "d.cu": 'const char* s = "nobody";\n'}
    allowed = {"e.cpp": "int nobody = 1;  // for whose sake\n", "f.md": "`nobody` is a replay: nobody.gwr\n"}
    for name, text in (refused | allowed).items():
        (folder / name).write_text(text)
    offences = check(folder, build, exempt=())
    escaped = gate_tools.escaped("planted word", offences, ["a.cpp:1", "b.md:2", "c.py:1", "d.cu:1"])
    return escaped + [f"refused for nothing: {o}" for o in offences if o.startswith(tuple(allowed))]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
