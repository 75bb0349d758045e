"""clang-format and clang-tidy of one major version: others lay out and warn differently."""
import re
import shutil
import subprocess

import gate_tools

MAJOR = 14  # Debian 12's; on newer systems the package of this version, where there is one


def tool(name):
    """The program `name` of the pinned version."""
    found = []
    for program in (f"{name}-{MAJOR}", name):
        path = shutil.which(program)
        if not path:
            continue
        version = subprocess.run([path, "--version"], capture_output=True, text=True, check=False).stdout
        major = re.search(r"version (\d+)", version)
        if major and int(major.group(1)) == MAJOR:
            return path
        found.append(f"{program} is of version {major.group(1) if major else 'unknown'}")
    raise gate_tools.Skip(f"{name} {MAJOR} is not here" + (f" ({', '.join(found)})" if found else ""))
