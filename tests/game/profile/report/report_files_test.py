#!/usr/bin/env python3
"""The files of a profiling session as other programs read them.

    report_files_test.py markup|schema|pictures REPORTS SCHEMA

markup: SVG is well-formed, and HTML nests.  schema: report.json is as docs/reference/profile-report.schema.json says; skipped
without Python's jsonschema.  pictures: every PNG shows every colour of its SVG; skipped without rsvg-convert, or
ImageMagick to read them.
"""
import json
import re
import shutil
import sys
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "e2e"))
from pictures import colours_of, reports_in  # noqa: E402
from program import Failures, skip  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
WITHOUT_END = {"meta", "link", "br"}


class Nesting(HTMLParser):
    """Elements that are left open, closed twice, or have an id of another."""

    def __init__(self):
        super().__init__()
        self.open, self.wrong, self.ids, self.links = [], [], set(), set()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            if attributes["id"] in self.ids:
                self.wrong.append("twice: id " + attributes["id"])
            self.ids.add(attributes["id"])
        if attributes.get("href", "").startswith("#"):
            self.links.add(attributes["href"][1:])
        if tag not in WITHOUT_END:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append("closed out of turn: " + tag)

    def offences(self):
        return self.wrong + self.open + ["goes nowhere: " + link for link in self.links - self.ids]


def markup(reports, failures, _schema):
    for report in reports:
        plots = sorted((report / "plots").glob("*.svg"))
        for plot in plots:
            try:
                root = ElementTree.parse(plot).getroot()
            except ElementTree.ParseError as error:
                failures.check(False, f"{report.name}/{plot.name} is well-formed: {error}")
                continue
            texts = [text.text or "" for text in root.iter(SVG + "text")]
            good = root.tag == SVG + "svg" and len(texts) >= 3 and " asked, " in texts[1]
            failures.check(good, f"{report.name}/{plot.name} is SVG, and its subtitle says how many enemies there were")
        page = Nesting()
        page.feed((report / "report.html").read_text())
        failures.check(not page.offences(), f"{report.name}/report.html nests {page.offences()}")


def schema(reports, failures, path):
    try:
        import jsonschema
    except ImportError:
        skip("Python's jsonschema is not installed")
    rules = json.loads(path.read_text())
    validator = jsonschema.validators.validator_for(rules)
    validator.check_schema(rules)
    for report in reports:
        errors = list(validator(rules).iter_errors(json.loads((report / "report.json").read_text())))
        failures.check(not errors, f"{report.name}/report.json is as the schema says {errors[:1]}")
    damaged = json.loads((reports[0] / "report.json").read_text())
    del damaged["cases"][0]["enemies"]
    failures.check(not validator(rules).is_valid(damaged), "and the schema notices what is missing")


def pictures(reports, failures, _schema):
    if not shutil.which("rsvg-convert") or not shutil.which("convert"):
        skip("rsvg-convert or ImageMagick is not installed")
    for report in reports:
        if report.name == "hostile":
            continue  # without numbers there is nothing to compare
        for plot in sorted((report / "plots").glob("*.svg")):
            seen = colours_of(plot.with_suffix(".png"))
            # What is half transparent, and the thin rims of characters, mix with what is below.
            solid = re.sub(r"<[^>]*-opacity=[^>]*>", "", plot.read_text())
            wanted = set(re.findall(r'class="gw-[fs]-(?!edge|grid|on-)[^"]*" (?:fill|stroke)="(#[0-9a-f]{6})"', solid))
            missing = {colour for colour in wanted if seen.get(bytes.fromhex(colour[1:]), 0) < 10}
            failures.check(len(wanted) >= 2 and not missing and len(seen) > 20,
                           f"{report.name}/{plot.stem}.png: {len(wanted)} colours, missing {sorted(missing)}")


def main():
    part, folder, path = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    failures = Failures()
    {"markup": markup, "schema": schema, "pictures": pictures}[part](reports_in(folder), failures, path)
    failures.finish()


if __name__ == "__main__":
    main()
