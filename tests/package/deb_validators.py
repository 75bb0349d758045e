#!/usr/bin/env python3
"""What Debian's own tools say about the packages that deb_contents_e2e.py leaves.

    deb_validators.py lintian|desktop|metainfo FOLDER       exit status 77: the tool is not here
"""
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures, skip  # noqa: E402

# Each tool, what it looks at below FOLDER, and its options. lintian's informations, such as a missing watch file, are for
# who uploads to Debian. An override of a tag that only newer versions know is an alien-tag to older ones.
TOOLS = {
    "lintian": (["lintian", "--fail-on", "error,warning", "--display-level", ">=warning", "--allow-root",
                "--suppress-tags", "alien-tag"], "debs/*.deb"),
    "desktop": (["desktop-file-validate"], "unpacked/usr/share/applications/*.desktop"),
    "metainfo": (["appstreamcli", "validate", "--no-net"], "unpacked/usr/share/metainfo/*.xml"),
}
# The project has no homepage.
PARDONED = {"metainfo": ["--override=url-homepage-missing=info"]}


def ended(command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


def main():
    command, pattern = TOOLS[sys.argv[1]]
    if not shutil.which(command[0]):
        skip(f"{command[0]} is not installed")
    files = sorted(map(str, Path(sys.argv[2]).glob(pattern)))
    run = ended([*command, *PARDONED.get(sys.argv[1], []), *files])
    if "is not recognized" in run.stdout:  # before 1.0 appstreamcli knows nothing of it
        run = ended([*command, *files])
    failures = Failures()
    failures.check(bool(files) and run.returncode == 0, f"{command[0]} on {len(files)} files: {run.returncode}\n{run.stdout}")
    failures.finish()


if __name__ == "__main__":
    main()
