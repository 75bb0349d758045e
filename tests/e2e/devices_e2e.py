"""gpuwars devices: the same facts for people and for scripts, and an answer where nothing can draw."""
import json
import shutil
import sys
from pathlib import Path

import program as gpuwars

CUDA_STATES = {"ready", "notBuilt", "noDriver", "driverTooOld", "noDevice", "deviceTooOld", "failed"}
KERNELS = {"x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4", "aarch64", "other"}


def check_facts(failures, facts):
    kinds = [device["kind"] for device in facts["devices"]]
    failures.check(kinds[-1] == "cpu" and set(kinds[:-1]) <= {"cuda"}, f"devices are {kinds}, the cpu last")
    failures.check(all(device["name"] and device["detail"] for device in facts["devices"]), "all of them described")
    failures.check(facts["cudaState"] in CUDA_STATES, f"the state of CUDA has a name: {facts['cudaState']}")
    ready = facts["cudaState"] == "ready"
    failures.check(facts["auto"] == ("cuda" if ready else "cpu"), f"auto takes {facts['auto']}")
    failures.check((facts["cudaMissing"] == "") == ready, f"why there is no CUDA: {facts['cudaMissing'] or '-'}")
    failures.check(facts["autoWhy"].endswith("."), f"and why auto takes it: {facts['autoWhy']}")
    failures.check((facts["builtWithCuda"] is None) == (facts["cudaState"] == "notBuilt"),
                   f"the program's CUDA is {facts['builtWithCuda']}, the driver's {facts['driver']['supportsCuda']}")
    failures.check(facts["cpuKernels"] in KERNELS, f"the processor's kernels are for {facts['cpuKernels']}")
    if facts["cudaState"] == "driverTooOld":
        failures.check(facts["builtWithCuda"] in facts["cudaMissing"], "an old driver is told what it lacks")


def check_renderers(failures, facts):
    ordinals = range(sum(device["kind"] == "cuda" for device in facts["devices"]))
    for renderer in facts["renderers"]:
        shared = renderer["sharesMemoryWithCuda"]
        failures.check(shared is None or (shared in ordinals and renderer["name"] and not renderer["software"]),
                       f"{renderer['place']}: {renderer['name'] or 'draws nothing'}, shares memory with {shared}")


def check_remedy(failures, program, folder):
    """Where a variable keeps the driver away: one sentence that names it, without the driver's own lines."""
    replay = Path(__file__).resolve().parents[2] / "replays/first_seconds.gwr"
    picture = folder / "picture.png"
    draw = ("render", replay, "--device", "cpu", "--from", 20, "--to", 20, "--out", picture)
    for name, value in (("LIBGL_DRIVERS_PATH", "/none"), ("__EGL_VENDOR_LIBRARY_FILENAMES", "/none.json"),
                        ("MESA_GL_VERSION_OVERRIDE", "3.3"), ("MESA_LOADER_DRIVER_OVERRIDE", "zink"),
                        ("GALLIUM_DRIVER", "none_such"), ("EGL_PLATFORM", "wayland")):
        code, _, stderr = gpuwars.run(program, *draw, environment={**gpuwars.without_display(), name: value})
        drawn = code == 0 and picture.is_file() and stderr == ""  # some drivers take no notice of some of them
        said = code == 1 and len(stderr.splitlines()) == 1 and f"{name}='{value}', the likely cause" in stderr
        failures.check(drawn or said, f"{name}={value}: " + ("a picture" if drawn else stderr.strip()))
        picture.unlink(missing_ok=True)
    nowhere = {**gpuwars.without_display(), "__EGL_VENDOR_LIBRARY_FILENAMES": "/none.json"}
    code, _, stderr = gpuwars.run(program, *draw, environment=nowhere)
    failures.check(code == 1 and "__EGL_VENDOR_LIBRARY_FILENAMES" in stderr, "one of them at least hides every driver")


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = gpuwars.Failures()
    code, stdout, stderr = gpuwars.run(program, "devices", "--json", "-")
    failures.check(code == 0 and stderr == "", f"devices --json ends well and quietly: {code} {stderr!r}")
    facts = json.loads(stdout)
    check_facts(failures, facts)
    check_renderers(failures, facts)

    code, stdout, stderr = gpuwars.run(program, "devices")
    failures.check(code == 0 and stderr == "", f"devices ends well and quietly: {code} {stderr!r}")
    lines = stdout.splitlines()
    failures.check(lines[-1] == f"auto takes {facts['auto']}: {facts['autoWhy']}", f"the last line: {lines[-1]}")
    names = [thing["name"] for thing in facts["devices"] + facts["renderers"]] + [facts["cpuKernels"]]
    failures.check(all(name in stdout for name in names), "whatever a script is told, people are told too")

    # EGL finds its drivers by these; so here it has none.
    nowhere = {**gpuwars.without_display(), "__EGL_VENDOR_LIBRARY_DIRS": "/nonexistent",
               "__EGL_VENDOR_LIBRARY_FILENAMES": ""}
    code, stdout, stderr = gpuwars.run(program, "devices", "--json", "-", environment=nowhere)
    failures.check(code == 0 and stderr == "", f"without EGL it still ends well and quietly: {code} {stderr!r}")
    failures.check(json.loads(stdout)["renderers"] == [], "and lists nothing that draws")
    code, stdout, _ = gpuwars.run(program, "devices", environment=nowhere)
    failures.check(code == 0 and "none without a display" in stdout, "in words too")
    check_remedy(failures, program, folder)
    failures.finish()


if __name__ == "__main__":
    main()
