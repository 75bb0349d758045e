#!/usr/bin/env python3
"""Draws GpuWars' own typeface and bakes it: assets/fonts/neon.png (distance atlas) and neon.json.

Every glyph is a handful of strokes of bent tube, written below on a grid: the baseline is y = 0, capitals
are 6 units high, lower case 4, descenders reach -2. A stroke is a list of points `x,y` or `x,y,r`; r is
the radius of the bend there (without it: BEND for right angles and flatter turns, SHARP for acute ones).
A stroke that starts with `o` is closed; a stroke of one point is a dot.

The atlas does not hold coverage but the distance to the middle of the nearest stroke, 255 on the stroke
and 0 at RANGE units from it, so that the shader chooses the weight, the softness and the glow.

    tools/make_font.py [output folder]        needs nothing but Python's standard library
"""
import json
import math
import struct
import sys
import zlib
from pathlib import Path

PIXELS_PER_UNIT = 8
CAP_HEIGHT = 6.0       # units
RANGE = 1.6            # units of distance that the atlas can express: the widest glow
SPACING = 1.7          # units between the strokes of neighbouring letters
BEND, SHARP = 1.4, 0.2
ATLAS_WIDTH = 1024     # pixels
ARC_STEPS = 5

GLYPHS = {
    "!": "0,6 0,1.9;0,0",
    '"': "0,6 0,4.5;1.4,6 1.4,4.5",
    "#": ".9,.4 1.7,5.6;2.7,.4 3.5,5.6;0,2 4.1,2;.3,4 4.4,4",
    "$": "4,4.6 4,5.3,.9 0,5.3,.9 0,3,.9 4,3,.9 4,.7,.9 0,.7,.9 0,1.4;2,6.5 2,-.5",
    "%": "0,0 4.4,6;o0,4.1,.6 1.5,4.1,.6 1.5,6,.6 0,6,.6;o2.9,0,.6 4.4,0,.6 4.4,1.9,.6 2.9,1.9,.6",
    "&": "4.3,0 .7,4.2,.5 .7,6,.9 2.9,6,.9 2.9,4.2,.5 0,1.8,.8 0,0,.9 2.6,0,1 4.3,2.4",
    "'": "0,6 0,4.5",
    "(": "1.2,6.8 0,5.2,.8 0,.8,.8 1.2,-.8",
    ")": "0,6.8 1.2,5.2,.8 1.2,.8,.8 0,-.8",
    "*": "1.5,1.9 1.5,5.1;.1,2.7 2.9,4.3;.1,4.3 2.9,2.7",
    "+": "1.6,1.4 1.6,4.6;0,3 3.2,3",
    ",": ".5,.1 0,-1.1",
    "-": "0,3 2.6,3",
    ".": "0,0",
    "/": "0,-.5 3,6.5",
    "0": "o0,0 3.6,0 3.6,6 0,6",
    "1": ".7,4.8 2.2,6,.2 2.2,0",
    "2": "0,6 3.6,6 3.6,3.1 0,3.1 0,0,.4 3.6,0",
    "3": "0,6 3.6,6 3.6,0 0,0;.9,3.1 3.6,3.1",
    "4": "0,6 0,2.5,.8 3.6,2.5;3.6,6 3.6,0",
    "5": "3.6,6 0,6,.4 0,3.3,.4 3.6,3.3 3.6,0 0,0",
    "6": "3.4,6 0,6 0,0 3.6,0 3.6,3.3 0,3.3",
    "7": "0,6 3.6,6,.5 1.3,0",
    "8": "o0,0 3.6,0 3.6,3.2 0,3.2;o.35,3.2,1.1 3.25,3.2,1.1 3.25,6,1.1 .35,6,1.1",
    "9": ".2,0 3.6,0 3.6,6 0,6 0,2.7 3.6,2.7",
    ":": "0,.8;0,3.8",
    ";": ".5,3.8;.5,.8 0,-.5",
    "<": "2.8,5.4 0,3 2.8,.6",
    "=": "0,2 3.2,2;0,4 3.2,4",
    ">": "0,5.4 2.8,3 0,.6",
    "?": "0,5.2 0,6,.8 3.6,6 3.6,3.2 1.7,3.2,.9 1.7,1.9;1.7,0",
    "@": "3.5,1.7 1.5,1.7,.8 1.5,4.3,.8 3.5,4.3,.3 3.5,1.7,.3 5,1.7,.8 5,6 0,6 0,0 4.4,0",
    "A": "0,0 0,6,1.9 4,6,1.9 4,0;0,2.3 4,2.3",
    "B": "0,3.2 0,6,.2 3.5,6,1.2 3.5,3.2,1.2 0,3.2;3,3.2 4,3.2,1.1 4,0,1.2 0,0,.2 0,3.2",
    "C": "4,6 0,6,1.8 0,0,1.8 4,0",
    "D": "o0,0,.2 4.1,0,2 4.1,6,2 0,6,.2",
    "E": "3.7,6 0,6,.4 0,0,.4 3.7,0;0,3.1 3,3.1",
    "F": "3.7,6 0,6,.4 0,0;0,3.1 3,3.1",
    "G": "4,6 0,6,1.8 0,0,1.8 4,0,1 4,2.9,.2 2.2,2.9",
    "H": "0,0 0,6;4,0 4,6;0,3.1 4,3.1",
    "I": "0,0 0,6",
    "J": "3.3,6 3.3,0,1.6 0,0,1.6 0,1.8",
    "K": "0,0 0,6;3.8,6 0,2.5;1.3,3.7 4,0",
    "L": "0,6 0,0,.4 3.5,0",
    "M": "0,0 0,6,.3 2.5,2.6,.3 5,6,.3 5,0",
    "N": "0,0 0,6,.3 4,0,.3 4,6",
    "O": "o0,0,1.9 4.3,0,1.9 4.3,6,1.9 0,6,1.9",
    "P": "0,0 0,6,.2 4,6 4,2.6 0,2.6",
    "Q": "o0,0,1.9 4.3,0,1.9 4.3,6,1.9 0,6,1.9;2.8,1.6 4.7,-.6",
    "R": "0,0 0,6,.2 4,6 4,2.6 0,2.6;1.9,2.6 4.1,0",
    "S": "3.9,6 0,6 0,3.1 4,3.1 4,0 .1,0",
    "T": "0,6 4.4,6;2.2,6 2.2,0",
    "U": "0,6 0,0,1.8 4,0,1.8 4,6",
    "V": "0,6 2.1,0,.4 4.2,6",
    "W": "0,6 1.5,0,.3 2.9,4.7,.3 4.3,0,.3 5.8,6",
    "X": "0,6 4,0;4,6 0,0",
    "Y": "0,6 2.1,2.9 4.2,6;2.1,2.9 2.1,0",
    "Z": "0,6 4,6,.4 0,0,.4 4,0",
    "[": "1.2,6.8 0,6.8,.2 0,-.8,.2 1.2,-.8",
    "\\": "0,6.5 3,-.5",
    "]": "0,6.8 1.2,6.8,.2 1.2,-.8,.2 0,-.8",
    "^": "0,4.2 1.4,6 2.8,4.2",
    "_": "0,-.8 4,-.8",
    "`": "0,6.2 .8,5",
    "a": ".2,4 3.2,4,1.1 3.2,0,.3 0,0,.9 0,2.2,.9 3.2,2.2",
    "b": "0,6.2 0,0,.3 3.2,0,1.1 3.2,4,1.1 0,4",
    "c": "3,4 0,4,1.2 0,0,1.2 3,0",
    "d": "3.2,6.2 3.2,0,.3 0,0,1.1 0,4,1.1 3.2,4",
    "e": "0,2.1 3.2,2.1,.2 3.2,4,1.1 0,4,1.1 0,0,1.1 3,0",
    "f": "2.3,6.2 .8,6.2,1.1 .8,0;0,4 2.2,4",
    "g": "3.2,0 0,0,1.1 0,4,1.1 3.2,4,.3 3.2,-2,1.1 .2,-2",
    "h": "0,6.2 0,0;0,4 3.2,4,1.2 3.2,0",
    "i": "0,4 0,0;0,5.8",
    "j": "1,4 1,-2,1 -.1,-2;1,5.8",
    "k": "0,6.2 0,0;2.8,4 0,1.6;1,2.5 3,0",
    "l": "0,6.2 0,0,1 1,0",
    "m": "0,0 0,4;0,4 2.4,4,1 2.4,0;1.4,4 4.8,4,1 4.8,0",
    "n": "0,0 0,4;0,4 3.2,4,1.2 3.2,0",
    "o": "o0,0,1.2 3.3,0,1.2 3.3,4,1.2 0,4,1.2",
    "p": "0,-2 0,4,.3 3.2,4,1.1 3.2,0,1.1 0,0",
    "q": "3.2,-2 3.2,4,.3 0,4,1.1 0,0,1.1 3.2,0",
    "r": "0,0 0,4;0,2.6 0,4,1.3 2.2,4",
    "s": "3,4 0,4,.9 0,2.1,.9 3,2.1,.9 3,0,.9 0,0",
    "t": ".8,5.6 .8,0,1.1 2.4,0;0,4 2.3,4",
    "u": "0,4 0,0,1.2 3.2,0;3.2,4 3.2,0",
    "v": "0,4 1.6,0,.3 3.2,4",
    "w": "0,4 1.2,0,.2 2.3,3.2,.2 3.4,0,.2 4.6,4",
    "x": "0,4 3,0;3,4 0,0",
    "y": "0,4 0,0,1.1 3.2,0;3.2,4 3.2,-2,1.1 .2,-2",
    "z": "0,4 3,4,.3 0,0,.3 3,0",
    "{": "1.6,6.8 .8,6.8,.8 .8,3.2,.4 0,3,.1 .8,2.8,.4 .8,-.8,.8 1.6,-.8",
    "|": "0,6.8 0,-.8",
    "}": "0,6.8 .8,6.8,.8 .8,3.2,.4 1.6,3,.1 .8,2.8,.4 .8,-.8,.8 0,-.8",
    "~": "0,2.6 .9,3.5,.5 2.3,2.5,.5 3.2,3.4",
}
FIGURE_WIDTH = 3.6     # every digit advances alike, so that counters do not jitter
SPACE_ADVANCE = 3.4


def parse(stroke):
    """A stroke's points (x, y, bend or None) and whether it is closed."""
    closed = stroke.startswith("o")
    points = []
    for token in stroke.lstrip("o").split():
        numbers = [float(part) for part in token.split(",")]
        points.append((numbers[0], numbers[1], numbers[2] if len(numbers) > 2 else None))
    return points, closed


def bend(before, corner, after):
    """The corner as a short arc (a quadratic curve is close enough at this size)."""
    ax, ay = before[0] - corner[0], before[1] - corner[1]
    bx, by = after[0] - corner[0], after[1] - corner[1]
    a, b = math.hypot(ax, ay), math.hypot(bx, by)
    acute = (ax * bx + ay * by) / (a * b) > 0.1
    radius = corner[2] if corner[2] is not None else (SHARP if acute else BEND)
    radius = min(radius, a / 2, b / 2)
    start = (corner[0] + ax / a * radius, corner[1] + ay / a * radius)
    end = (corner[0] + bx / b * radius, corner[1] + by / b * radius)
    # Control point nearer to the corner than a plain quadratic's midpoint: rounder, like bent glass.
    arc = []
    for step in range(ARC_STEPS + 1):
        t = step / ARC_STEPS
        w0, w1, w2 = (1 - t) ** 2, 2 * t * (1 - t) * 0.75, t ** 2
        total = w0 + w1 + w2
        arc.append(((w0 * start[0] + w1 * corner[0] + w2 * end[0]) / total,
                    (w0 * start[1] + w1 * corner[1] + w2 * end[1]) / total))
    return arc


def segments(glyph):
    """All strokes of a glyph as straight segments (x0, y0, x1, y1)."""
    result = []
    for stroke in GLYPHS[glyph].split(";"):
        points, closed = parse(stroke)
        if len(points) == 1:
            result.append((points[0][0], points[0][1], points[0][0], points[0][1]))
            continue
        count = len(points)
        line = []
        for i, point in enumerate(points):
            if not closed and i in (0, count - 1):
                line.append(point[:2])
            else:
                line += bend(points[i - 1], point, points[(i + 1) % count])
        if closed:
            line.append(line[0])
        result += [a + b for a, b in zip(line, line[1:])]
    return result


def distance(px, py, lines):
    nearest = RANGE * RANGE
    for x0, y0, x1, y1 in lines:
        dx, dy, qx, qy = x1 - x0, y1 - y0, px - x0, py - y0
        length2 = dx * dx + dy * dy
        t = 0.0 if length2 == 0 else min(1.0, max(0.0, (qx * dx + qy * dy) / length2))
        ex, ey = qx - t * dx, qy - t * dy
        nearest = min(nearest, ex * ex + ey * ey)
    return math.sqrt(nearest)


def bake(glyph):
    """The glyph's tile: (rows of bytes, left, top, advance), the latter three in units."""
    lines = segments(glyph)
    xs = [x for line in lines for x in (line[0], line[2])]
    ys = [y for line in lines for y in (line[1], line[3])]
    left, right = min(xs) - RANGE, max(xs) + RANGE
    bottom, top = min(ys) - RANGE, max(ys) + RANGE
    width = math.ceil((right - left) * PIXELS_PER_UNIT)
    height = math.ceil((top - bottom) * PIXELS_PER_UNIT)
    rows = []
    for row in range(height):
        y = top - (row + 0.5) / PIXELS_PER_UNIT
        rows.append(bytes(round(255 * (1 - distance(left + (column + 0.5) / PIXELS_PER_UNIT, y, lines) / RANGE))
                          for column in range(width)))
    advance = (FIGURE_WIDTH if glyph.isdigit() else max(xs)) + SPACING
    return rows, left, top, advance


def png(rows):
    """A grey 8-bit PNG."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "assets" / "fonts"
    folder.mkdir(parents=True, exist_ok=True)
    tiles = sorted(((glyph, *bake(glyph)) for glyph in GLYPHS), key=lambda tile: (-len(tile[1]), tile[0]))
    atlas, metrics = [], {" ": [0, 0, 0, 0, 0.0, 0.0, SPACE_ADVANCE]}
    x, y, shelf = 0, 0, 0
    for glyph, rows, left, top, advance in tiles:  # shelves, tallest glyphs first
        width, height = len(rows[0]), len(rows)
        if x + width > ATLAS_WIDTH:
            x, y, shelf = 0, y + shelf + 1, 0
        shelf = max(shelf, height)
        while len(atlas) < y + height:
            atlas.append(bytearray(ATLAS_WIDTH))
        for row in range(height):
            atlas[y + row][x:x + width] = rows[row]
        metrics[glyph] = [x, y, width, height, round(left, 4), round(top, 4), round(advance, 4)]
        x += width + 1
    (folder / "neon.png").write_bytes(png(atlas))
    lines = [f"    {json.dumps(str(ord(glyph)))}: {json.dumps(metrics[glyph])}" for glyph in sorted(metrics)]
    (folder / "neon.json").write_text(
        '{\n  "comment": "made by tools/make_font.py; glyphs: code: [x, y, width, height (pixels of the atlas), '
        'left, top, advance (units)]",\n'
        f'  "image": "neon.png",\n  "pixelsPerUnit": {PIXELS_PER_UNIT},\n  "capHeight": {CAP_HEIGHT},\n'
        f'  "range": {RANGE},\n  "spacing": {SPACING},\n  "glyphs": {{\n' + ",\n".join(lines) + "\n  }\n}\n")
    print(f"{folder}: {len(metrics)} glyphs, atlas {ATLAS_WIDTH} x {len(atlas)}")


if __name__ == "__main__":
    main()
