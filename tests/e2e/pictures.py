"""Reports that the test profile_reports has made, and what pictures show."""
import subprocess
from collections import Counter


def reports_in(folder):
    """The folders of all reports; there are some."""
    reports = sorted(file.parent for file in folder.glob("*/report.json"))
    assert reports, f"{folder} holds no report: run the test profile_reports first"
    return reports


def pixels(picture):
    """(width, height, its bytes as RGB), by ImageMagick."""
    made = subprocess.run(["convert", picture, "-strip", "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE)
    kind, size, depth, rest = made.stdout.split(b"\n", 3)
    width, height = map(int, size.split())
    assert (kind, depth, len(rest)) == (b"P6", b"255", width * height * 3)
    return width, height, rest


def colours_of(picture):
    """How many pixels have each colour, three bytes."""
    rgb = pixels(picture)[2]
    return Counter(rgb[i:i + 3] for i in range(0, len(rgb), 3))
