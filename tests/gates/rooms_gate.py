"""Folders of sources are rooms, and no rooms include each other in a circle.

A folder and those below it that a room keeps for itself count as one: gpu/ngrid/detail, and what lies below game/sim.
"""
import gate_tools
from includes_gate import INCLUDE, included_file

LAYERS = ("gpu", "render", "host", "game", "labs")
INNER = ("gpu/ngrid", "game/sim")  # one room with the folders below


def room_of(name):
    folder = name.rpartition("/")[0]
    return next((room for room in INNER if folder == room or folder.startswith(room + "/")), folder)


def arrows_of(source, names):
    """{(room, room it includes): the includes as "file: included file"}"""
    public = {name.rpartition("/")[2]: name for name in names if name.startswith("gpu/")}
    arrows = {}
    for name in names:
        for quoted, angled in INCLUDE.findall((source / name).read_text(errors="replace")):
            target = included_file(source, name, quoted, angled)
            if target and angled.startswith("gpuwars/"):
                target = public.get(target.rpartition("/")[2], target)
            if target and target.split("/")[0] in LAYERS and room_of(name) != room_of(target):
                arrows.setdefault((room_of(name), room_of(target)), []).append(f"{name}: {target}")
    return arrows


def circles(arrows):
    """The sets of rooms that reach each other."""
    onward = {}
    for room, other in arrows:
        onward.setdefault(room, set()).add(other)

    def reached(room):
        found, todo = set(), [room]
        while todo:
            for other in onward.get(todo.pop(), ()):
                if other not in found:
                    found.add(other)
                    todo.append(other)
        return found

    reach = {room: reached(room) for room in onward}
    return {frozenset(other for other in found if room in reach.get(other, ())) for room, found in reach.items() if room in found}


def check(source, _build):
    names = gate_tools.source_files(source, LAYERS)
    arrows = arrows_of(source, names)
    print(f"{len({room_of(name) for name in names})} rooms, {len(arrows)} arrows")
    offences = [] if arrows else ["no room includes another: nothing was looked at"]
    for circle in circles(arrows):
        within = [includes[0] for (room, other), includes in sorted(arrows.items()) if {room, other} <= circle]
        offences.append(f"{', '.join(sorted(circle))} include each other: {'; '.join(within)}")
    return offences


def planted(build, folder):
    files = {
        "gpu/exec/a.h": "#include <gpuwars/b.h>\n",
        "gpu/math/b.h": "\n",
        "gpu/ngrid/n.h": '#include "detail/d.h"\n',
        "gpu/ngrid/detail/d.h": "#include <gpuwars/n.h>\n",
        "game/sim/state.h": '#include "game/sim/draw/list.h"\n',
        "game/sim/draw/list.h": '#include "game/sim/state.h"\n',
        "game/ui/u.h": '#include "game/view/v.h"\n',
        "game/view/v.h": '#include "game/session/s.h"\n',
        "game/session/s.h": '#include "game/sim/state.h"\n',
    }
    def written(changes):
        for name, text in {**files, **changes}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        return check(folder, build)

    escaped = [f"clean rooms were refused: {offence}" for offence in written({})]
    escaped += gate_tools.escaped("three rooms in a circle", written({"game/session/s.h": '#include "game/ui/u.h"\n'}),
                                  ["game/session, game/ui, game/view include each other: game/session/s.h: game/ui/u.h"])
    escaped += gate_tools.escaped("two floors of gpu/", written({"gpu/math/b.h": "#include <gpuwars/a.h>\n"}),
                                  ["gpu/exec, gpu/math include each other"])
    return escaped


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
