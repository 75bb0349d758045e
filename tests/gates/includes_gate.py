"""Includes go one way: gpu <- render <- host <- {game, labs} <- {tests, bench}.

game/sim and game/autopilot run on the device: of render/ they may know only the plain vertex struct
and the plain table of shapes. Of libraries only
public headers are included: the others move from version to version.
gpu/ is a library: its users may have a folder of that name, which must not be found in place of this one.
"""
import re

import gate_tools

LAYERS = ("gpu", "render", "host", "game", "labs", "bench", "tests", "tools", "assets")
MAY_INCLUDE = {
    "gpu": {"gpu"},
    "render": {"gpu", "render"},
    "host": {"gpu", "render", "host"},
    "game": {"gpu", "render", "host", "game"},
    "labs": {"gpu", "render", "host", "labs"},
    "bench": {"gpu", "render", "host", "game", "labs", "bench", "tests"},
    "tests": {"gpu", "render", "host", "game", "labs", "bench", "tests"},
    "tools": {"tools"},
    "assets": set(),
}
PLAIN = ("render/sprite_vertex.h", "render/sprite_shapes.h")
ON_DEVICE = ("game/sim/", "game/autopilot/")
PRIVATE = re.compile(r"/(?:impl|detail|details|internal|private)/")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.MULTILINE)


def included_file(source, name, quoted, angled):
    """The file of ours that an include means, relative to the root, or None for a library's."""
    if quoted:
        beside = ((source / name).parent / quoted).resolve()
        if beside.is_file() and beside.is_relative_to(source):
            return beside.relative_to(source).as_posix()
    path = quoted or angled
    if path.startswith("gpuwars/"):  # the flat public headers of gpu/
        return path.replace("gpuwars/", "gpu/", 1)
    return path if path.split("/")[0] in LAYERS and "/" in path else None


def check(source, _build):
    offences = []
    names = gate_tools.source_files(source, LAYERS)
    for name in names:
        layer = name.split("/")[0]
        for quoted, angled in INCLUDE.findall((source / name).read_text(errors="replace")):
            target = included_file(source, name, quoted, angled)
            if target is None:
                if PRIVATE.search(quoted or angled):
                    offences.append(f"{name}: {quoted or angled} is a library's own affair")
                continue
            if layer == "gpu" and (quoted or angled).startswith("gpu/"):
                offences.append(f"{name}: names {target} by the folder; say <gpuwars/NAME.h>, or of a header that is "
                                "not installed the name alone")
            elif target.split("/")[0] not in MAY_INCLUDE[layer]:
                offences.append(f"{name}: {layer}/ must not include {target}")
            elif name.startswith(ON_DEVICE) and target.startswith("render/") and target not in PLAIN:
                offences.append(f"{name}: of render/ the simulation may include only {' and '.join(PLAIN)}, not {target}")
    print(f"{len(names)} files looked at")
    if not names:
        offences.append("no source file was found")
    return offences


def planted(build, folder):
    files = {
        "gpu/a.h": '#include "render/b.h"\n',
        "gpu/c.h": '#include <vector>\n#include <gpuwars/a.h>\n#include "a.h"\n#include "device_functions.h"\n',
        "gpu/by_folder.h": '#include "gpu/a.h"\n',
        "gpu/by_folder_angled.cu": "#include <gpu/a.h>\n",
        "tools/t.cpp": "#include <gpuwars/a.h>\n",
        "render/b.h": '  #  include "game/sim/state.h"\n',
        "render/angled.h": "#include <game/sim/state.h>\n",
        "render/upwards.cpp": '#include "../game/sim/state.h"\n',
        "render/sprite_vertex.h": "\n",
        "host/h.h": '#include "render/sprite_vertex.h"\n#include "game/sim/state.h"\n',
        "render/on_host.h": '#include "host/h.h"\n',
        "game/sim/state.h": '#include "render/sprite_vertex.h"\n',
        "game/sim/draw.cu": '#include "render/b.h"\n',
        "game/main.cpp": '#include "render/b.h"\n#include "gpu/a.h"\n#include "tests/t.h"\n',
        "game/parser.cpp": "#include <toml++/impl/parser.h>\n#include <toml++/toml.h>\n",
        "labs/l.cpp": '#include "gpu/a.h"\n#include "game/sim/state.h"\n',
        "tests/t.h": '#include "game/sim/state.h"\n#include "gpu/a.h"\n',
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    offences = check(folder, build)
    expected = ["gpu/a.h: ", "gpu/by_folder.h", "gpu/by_folder_angled.cu", "render/b.h: ", "render/angled.h",
                "render/upwards.cpp", "host/h.h: host/ must not include game/sim/state.h", "render/on_host.h", "game/sim/draw.cu", "game/main.cpp", "game/parser.cpp: toml++/impl/parser.h",
                "labs/l.cpp", "tools/t.cpp"]
    escaped = gate_tools.escaped("planted include", offences, expected)
    if len(offences) != len(expected):
        escaped.append(f"{len(expected)} offences were planted, {len(offences)} reported: {offences}")
    return escaped


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
