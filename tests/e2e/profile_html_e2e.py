#!/usr/bin/env python3
"""Opens report.html as a browser shows it, in light and in dark: nothing of the console, nothing from a network, and
ink in every picture.

    profile_html_e2e.py REPORTS FOLDER      needs Chromium, else it is skipped and counted; ImageMagick reads its pictures
"""
import html
import re
import shutil
import subprocess
import sys
from pathlib import Path

from pictures import colours_of, pixels, reports_in
from program import Failures, skip

SIZE = (1280, 2000)
SCALE = 0.5  # of the picture of a whole page
# What settings of a browser's own would choose: 0 dark, 1 light.
SCHEMES = {"dark": 0, "light": 1}
# Leaves where every picture lies in the page's title, which --dump-dom prints.
MEASURING = """<script>document.title = [...document.querySelectorAll("svg")].map(function (svg) {
  const box = svg.getBoundingClientRect();
  return [box.x, box.y, box.width, box.height].map(Math.round).join(" ");
}).join(";") + "|" + document.documentElement.scrollHeight + "|" + document.documentElement.scrollWidth;</script>"""


class Browser:
    def __init__(self, folder):
        found = [name for name in ("chromium", "chromium-browser", "google-chrome") if shutil.which(name)]
        if not found or not shutil.which("convert"):
            skip("Chromium or ImageMagick is not installed")
        self.program, self.folder = found[0], folder

    def open(self, page, scheme, size, *options):
        """What it prints to (stdout, stderr)."""
        done = subprocess.run(
            [self.program, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
             "--disable-component-update", "--disable-background-networking", f"--user-data-dir={self.folder / 'user'}",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--v=0",
             f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}", f"--window-size={size[0]},{size[1]}", *options,
             page.resolve().as_uri()],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, check=True)
        return done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")

    def picture(self, page, scheme, size, scale=1):
        """(its file, lines of the console)"""
        file = self.folder / f"{page.parent.name}_{scheme}_{size[1]}.png"
        said = self.open(page, scheme, size, f"--screenshot={file}", f"--force-device-scale-factor={scale}")[1]
        return file, [line for line in said.splitlines() if "CONSOLE" in line]


def boxes_of(browser, page, scheme, width):
    """Where the pictures of the page lie, in pixels, and (height, width) of all of it."""
    probe = browser.folder / f"{page.parent.name}_measured.html"
    probe.write_text(page.read_text().replace("</body>", MEASURING + "</body>"))
    title = re.search(r"<title>([^<]*)</title>", browser.open(probe, scheme, (width, SIZE[1]), "--dump-dom")[0])
    boxes, height, scrolled = html.unescape(title.group(1)).split("|")
    return [tuple(map(int, box.split())) for box in boxes.split(";")], int(height), int(scrolled)


def ink_in(picture, box):
    """How many pixels of the box, but for a rim, are of another colour than most of it."""
    width, height, rgb = picture
    left, top, wide, high = box
    counts = {}
    for y in range(max(0, top + 4), min(height, top + high - 4)):
        row = rgb[3 * (y * width + left + 4):3 * (y * width + min(width, left + wide) - 4)]
        for x in range(0, len(row), 3):
            colour = row[x:x + 3]
            counts[colour] = counts.get(colour, 0) + 1
    return sum(counts.values()) - max(counts.values(), default=0), len(counts)


def looks(browser, page, scheme, failures):
    name = f"{page.parent.name} in {scheme}"
    shown, console = browser.picture(page, scheme, SIZE)
    failures.check(not console, f"{name}: nothing in the console {console[:2]}")
    colours = colours_of(shown)
    failures.check(len(colours) > 50, f"{name}: {len(colours)} colours on the first screen")
    ground = colours.most_common(1)[0][0]
    failures.check((sum(ground) > 384) == (scheme == "light"), f"{name}: the page is {tuple(ground)}")

    boxes, height, width = boxes_of(browser, page, scheme, SIZE[0])
    failures.check(width <= SIZE[0], f"{name}: nothing sticks out to the right, {width} pixels")
    pictures = len(list((page.parent / "plots").glob("*.svg")))
    failures.check(len(boxes) == pictures, f"{name}: {len(boxes)} of {pictures} pictures are on the page")
    # ImageMagick takes 16,000 pixels at most.
    whole = pixels(browser.picture(page, scheme, (SIZE[0], height), SCALE)[0])
    failures.check(abs(whole[1] - height * SCALE) <= 1, f"{name}: all of it is {whole[:2]} pixels")
    inks = [ink_in(whole, [int(side * SCALE) for side in box]) for box in boxes]
    least = 8000 if page.parent.name == "full" else 1000  # of an empty one there are words
    poor = [box for box, (ink, tones) in zip(boxes, inks) if ink < least or tones < 10]
    failures.check(not poor, f"{name}: every picture has ink, the least {min(inks)} {poor}")


def main():
    reports, folder = reports_in(Path(sys.argv[1])), Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    browser = Browser(folder)
    planted = folder / "planted.html"
    planted.write_text("<script>console.error('planted')</script>")
    failures.check(browser.picture(planted, "light", (200, 200))[1], "what a console says is noticed")
    for report in reports:
        page = report / "report.html"
        addresses = set(re.findall(r"[a-z]+://[^\s\"'<]+", page.read_text()))
        failures.check(addresses <= {"http://www.w3.org/2000/svg"}, f"{report.name}: no address but a name {addresses}")
        for scheme in SCHEMES if report.name == "full" else ["light"]:
            looks(browser, page, scheme, failures)
    full = next(report for report in reports if report.name == "full") / "report.html"
    failures.check(boxes_of(browser, full, "light", 500)[2] <= 500, "a narrow window does not scroll sideways")
    failures.finish()


if __name__ == "__main__":
    main()
