#!/usr/bin/env python3
"""Draws a stretch of a trace (gpuwars profile --trace) as SVG: a lane for each track, a bar for each event.

    draw_trace.py TRACE.json OUT.svg [--from MS] [--length MS]

Viewers such as ui.perfetto.dev show the whole of it and let one zoom; this is for pages that cannot.
"""
import argparse
import json
import sys
from html import escape
from pathlib import Path

WIDTH, LEFT, LANE, BAR, TOP = 1200, 120, 34, 24, 20
COLOURS = ("#332288", "#88ccee", "#117733", "#ddcc77", "#882255", "#44aa99", "#aa4499", "#999933", "#cc6677", "#6699cc")
DARK = {"#332288", "#117733", "#882255", "#aa4499", "#999933"}
LETTER = 6.6  # width of one


def tracks_of(events):
    """[(run, track, [(name, begin, took)])] in the viewers' order; times in ms."""
    runs, names, bars = {}, {}, {}
    for event in events:
        key = (event["pid"], event.get("tid"))
        if event["name"] == "process_name":
            runs[event["pid"]] = event["args"]["name"]
        elif event["name"] == "thread_name":
            names[key] = event["args"]["name"]
        elif event["ph"] == "X":
            bars.setdefault(key, []).append((event["name"], event["ts"] / 1000, event["dur"] / 1000))
    return [(runs[key[0]], names[key], bars.get(key, [])) for key in sorted(names)]


def svg_of(tracks, begin, length):
    """A picture of `length` ms from `begin` on."""
    scale, colour_of = (WIDTH - LEFT - 20) / length, {}
    parts, y, run = [], TOP, None
    for of, track, bars in tracks:
        if of != run:
            run, y = of, y + (10 if run else 0)
            parts.append(f'<text x="8" y="{y + 12}" font-weight="bold">{escape(of)}</text>')
            y += 22
        parts.append(f'<text x="8" y="{y + 16}" fill="#555">{escape(track)}</text>')
        for name, start, took in bars:
            left, right = max(start, begin), min(start + took, begin + length)
            if right <= left:
                continue
            x, wide = LEFT + (left - begin) * scale, (right - left) * scale
            word = name.split()[0]
            colour = colour_of.setdefault(word, COLOURS[len(colour_of) % len(COLOURS)])
            parts.append(f'<rect x="{x:.1f}" y="{y}" width="{max(wide, 0.5):.1f}" height="{BAR}" fill="{colour}" stroke="#fff" '
                         f'stroke-width="0.5"><title>{escape(name)}: {took:.3f} ms</title></rect>')
            if wide > LETTER * len(name) + 6:
                ink = "#fff" if colour in DARK else "#000"
                parts.append(f'<text x="{x + 4:.1f}" y="{y + 16}" fill="{ink}">{escape(name)}</text>')
        y += LANE
    for step in range(11):
        x = LEFT + step / 10 * length * scale
        parts.insert(0, f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{y}" stroke="#e4e4e4"/>')
        parts.append(f'<text x="{x:.1f}" y="{y + 14}" fill="#555" text-anchor="middle">{begin + step / 10 * length:.1f}</text>')
    parts.append(f'<text x="{WIDTH / 2}" y="{y + 32}" fill="#555" text-anchor="middle">ms since the start of the run</text>')
    height = y + 44
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
            f'font-family="DejaVu Sans, sans-serif" font-size="11"><rect width="{WIDTH}" height="{height}" fill="#fff"/>'
            + "\n".join(parts) + "</svg>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("trace", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--from", type=float, default=0, dest="begin", metavar="MS", help="where it begins (0)")
    parser.add_argument("--length", type=float, default=50, metavar="MS", help="how much of it (50)")
    arguments = parser.parse_args()
    if not arguments.length > 0:
        parser.error("--length takes milliseconds above 0")
    try:
        tracks = tracks_of(json.loads(arguments.trace.read_text())["traceEvents"])
        arguments.out.write_text(svg_of(tracks, arguments.begin, arguments.length))
    except OSError as error:
        sys.exit(f"{error.filename}: {error.strerror}; check the name")
    except (ValueError, KeyError, TypeError, IndexError):
        sys.exit(f"{arguments.trace} is no trace of 'gpuwars profile --trace'; profile again")


if __name__ == "__main__":
    main()
