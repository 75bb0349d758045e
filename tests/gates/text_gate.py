"""No file of the repository names a folder of the machine it was written on."""
import re

import gate_tools

# A path's beginning: not preceded by what makes it the middle of a relative path or of an address.
ABSOLUTE = re.compile(rb"(?:(?<![\w.~*$})-])|(?<=-[IL]))/(?:work|home|root|Users)/[\w.-]")


def check(source, _build):
    offences = []
    names = gate_tools.repository_files(source)
    for name in names:
        for number, line in enumerate((source / name).read_bytes().split(b"\n"), 1):
            if ABSOLUTE.search(line):
                offences.append(f"{name}:{number}: an absolute path of one machine")
    print(f"{len(names)} files looked at")
    if not names:
        offences.append("no file was found")
    return offences


def planted(build, folder):
    # In pieces, so that this file passes itself.
    refused = ["see /" + "work/main", 'path = "/' + 'home/someone/x"', "-I/" + "root/include"]
    allowed = ["a/work/b", "https://example.org/home/x", "the /home of files", "framework/x"]
    for index, text in enumerate(refused):
        (folder / f"refused_{index}.txt").write_text(f"first\n{text}\n")
    for index, text in enumerate(allowed):
        (folder / f"allowed_{index}.txt").write_text(text + "\n")
    offences = check(folder, build)
    escaped = gate_tools.escaped("planted path", offences, [f"refused_{i}.txt:2" for i in range(len(refused))])
    return escaped + [f"refused for nothing: {offence}" for offence in offences if "allowed" in offence]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
