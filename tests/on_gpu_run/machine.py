"""When and where a run took place."""
import datetime
import json
import os
import shutil
import subprocess


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as info:
            for line in info:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return "unknown processor"


def gpu():
    """(name, driver) of the first GPU, as the driver's own tool says."""
    if shutil.which("nvidia-smi"):
        run = subprocess.run(["nvidia-smi", "--query-gpu=name,driver_version", "--format=csv,noheader"],
                             capture_output=True, text=True, check=False)
        if run.returncode == 0 and "," in run.stdout:
            name, driver = run.stdout.splitlines()[0].rsplit(",", 1)
            return name.strip(), driver.strip()
    return None, None


def devices(programs):
    """What the game itself knows of this machine."""
    result = programs.logs / "devices.json"
    programs.run("gpuwars", "devices", "--json", result, limit=60)
    return json.loads(result.read_text())


def computing(programs):
    """The name of what really computes: a stand-in for CUDA must not pass for a GPU."""
    if programs.device == "cpu":
        return processor()
    names = [device["name"] for device in devices(programs)["devices"] if device["kind"] == "cuda"]
    return names[0] if names else "unknown"


def facts(command):
    name, driver = gpu()
    return {"date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
            "command": command,
            "machine": {"gpu": name, "driver": driver, "cpu": processor(), "cores": os.cpu_count()}}
