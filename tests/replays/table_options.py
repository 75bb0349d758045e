"""Options of golden.list that gpuwars has not: they change the tables, which a replay holds.

    --with-sight S              S times every sight_m, so that enemies lose the ship more often than in play
    --with-waves-of TYPE        all waves of the timetable are of one type
    --with game.KEY=NUMBER      another number in game.toml; as often as needed
"""
import re
import shutil

TABLE_OPTIONS = {
    "--with-sight": ("enemies.toml", r"(?m)^(sight_m = )([0-9.]+)",
                     lambda value: lambda found: f"{found[1]}{float(found[2]) * float(value):g}"),
    "--with-waves-of": ("waves.toml", r'(type = )"\w+"', lambda value: lambda found: f'{found[1]}"{value}"'),
}


def change_of(option, value):
    """The table, the pattern in it and by what it is replaced."""
    if option in TABLE_OPTIONS:
        table, pattern, replacement = TABLE_OPTIONS[option]
        return table, pattern, replacement(value)
    found = re.fullmatch(r"game\.(\w+)=([0-9.]+)", value)
    if not found:
        raise ValueError(f"--with takes game.KEY=NUMBER, not '{value}'")
    return "game.toml", rf"(?m)^({found[1]} = )[0-9._]+", lambda line: f"{line[1]}{found[2]}"


def with_tables(options, assets, scratch, name):
    """The options for gpuwars, run in the folder `scratch`: what changes tables becomes a copy of the assets in it,
    under `name`, in which they are changed."""
    plain, rest, folder = [], list(options), scratch / name
    while rest:
        option = rest.pop(0)
        if option != "--with" and option not in TABLE_OPTIONS:
            plain.append(option)
            continue
        if not rest:
            raise ValueError(f"{option} needs a value")
        table, pattern, replacement = change_of(option, rest.pop(0))
        if not folder.exists():
            shutil.copytree(assets, folder)
        text, count = re.subn(pattern, replacement, (folder / table).read_text())
        if count == 0:
            raise ValueError(f"{option} finds nothing to change in {table}")
        (folder / table).write_text(text)
    return [*plain, "--assets", name] if folder.exists() else plain
