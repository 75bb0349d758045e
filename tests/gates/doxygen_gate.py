"""Every public entity of the library's headers is documented: Doxygen, by gpu/Doxyfile, has nothing to warn of."""
import shutil
import subprocess
import tempfile
from pathlib import Path

import gate_tools


def warnings_of(source, headers):
    """Doxygen's warnings of the headers in the folder, one a line."""
    if not shutil.which("doxygen"):
        raise gate_tools.Skip("doxygen is not here")
    with tempfile.TemporaryDirectory() as out:
        options = (source / "gpu/Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {out}\nINPUT = {headers}\n"
        run = subprocess.run(["doxygen", "-"], input=options, cwd=source, capture_output=True, text=True, check=False)
        made = len(list(Path(out).glob("html/*.html")))
    warnings = [line.replace(f"{source}/", "") for line in run.stderr.splitlines() if line.strip()]
    if run.returncode != 0 or not made:
        warnings.append(f"doxygen failed with {run.returncode} and made {made} pages")
    print(f"{made} pages")
    return warnings


def check(source, _build):
    return warnings_of(source, "gpu")


def planted(_build, folder):
    source = Path(__file__).resolve().parents[2]
    (folder / "planted.h").write_text("// A header.\n#pragma once\n\nnamespace gw {\n\n// Known.\nstruct Known {\n"
                                      "  int a, b;  // both\n  int silent;\n};\n\nvoid unknown();\n\n}  // namespace gw\n")
    offences = warnings_of(source, folder)
    escaped = gate_tools.escaped("planted entity", offences, ["Member silent", "Member unknown"])
    return escaped + [f"refused for nothing: {o}" for o in offences if "Compound gw::Known" in o or "Member a " in o or "Member b " in o]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
