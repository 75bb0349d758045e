#!/usr/bin/env python3
"""Draws GpuWars' icon, the ship among three of its enemies, as SVG and in the sizes that desktops ask for.

One list of polygons below is the drawing; SVG and PNG are made from it. Every run gives the same pixels, on every
machine: of arithmetic only + - * / and sqrt is used.

    tools/make_icon.py [output folder]        needs nothing but Python's standard library
"""
import struct
import sys
import zlib
from pathlib import Path

SIZES = (16, 24, 32, 48, 64, 128, 256)  # larger ones are drawn from the SVG
CANVAS = 512  # units of the drawing, x right, y down

NIGHT, GRID, WHITE = 0x080B18, 0x2A4C9C, 0xF4F8FF
AMBER, MAGENTA, RED = 0xFFB000, 0xFF3CE0, 0xFF3030
GLOW = ((4.2, 0.08), (2.4, 0.18))  # widths in lines, opacities: light around a neon line


def corner(x, y, towards_x, towards_y, radius):
    """Points of a quarter of a circle about (x, y), from its side to its top or bottom."""
    steps = 12
    points = []
    for i in range(steps + 1):
        t = i / steps  # a rational circle: no sine needed
        across, along = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        points.append((x + towards_x * radius * across, y + towards_y * radius * along))
    return points


def plate():
    low, high, radius = 16, CANVAS - 16, 96
    near, far = low + radius, high - radius
    return (corner(far, far, 1, 1, radius) + corner(near, far, -1, 1, radius)[::-1] +
            corner(near, near, -1, -1, radius) + corner(far, near, 1, -1, radius)[::-1])


def shape(corners, x, y, size):
    return [(x + size * a, y + size * b) for a, b in corners]


SHIP = shape([(0, -1), (0.72, 0.86), (0, 0.42), (-0.72, 0.86)], 250, 258, 148)
COCKPIT = shape([(0, -1), (0, 0.42)], 250, 258, 148)
TRIANGLE = shape([(0.94, 0.25), (-0.69, 0.69), (-0.25, -0.94)], 122, 132, 52)
SQUARE = shape([(-1, -1), (1, -1), (1, 1), (-1, 1)], 392, 134, 38)
HEXAGON = shape([(1, 0), (0.5, 0.866), (-0.5, 0.866), (-1, 0), (-0.5, -0.866), (0.5, -0.866)], 422, 408, 46)


class Polygon:
    """A closed one filled, or its line drawn when it has a width; left out of pictures under `least` pixels."""

    def __init__(self, points, colour, opacity=1.0, width=0.0, least=0, closed=True):
        self.points, self.colour, self.opacity = points, colour, opacity
        self.width, self.least, self.closed = width, least, closed


def neon(points, colour, width, least=0, closed=True):
    """A line and the light around it."""
    return [Polygon(points, colour, opacity, width * wider, max(least, 48), closed) for wider, opacity in GLOW] + [
        Polygon(points, colour, 1.0, width, least, closed)]


def drawing():
    parts = [Polygon(plate(), NIGHT)]
    for place in (128, 256, 384):
        parts += [Polygon([(place, 16), (place, 496)], GRID, 0.5, 4, 48, False),
                  Polygon([(16, place), (496, place)], GRID, 0.5, 4, 48, False)]
    parts.append(Polygon(plate(), GRID, 1.0, 8, 32))
    parts += neon(TRIANGLE, AMBER, 13, 24) + neon(SQUARE, MAGENTA, 13, 24) + neon(HEXAGON, RED, 15, 24)
    parts.append(Polygon(SHIP, WHITE, 0.25))
    parts += neon(SHIP, WHITE, 20) + neon(COCKPIT, WHITE, 12, 32, False)
    return parts


def svg(parts):
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {CANVAS} {CANVAS}">']
    for part in parts:
        path = "M" + "L".join(f"{x:.2f},{y:.2f}" for x, y in part.points) + ("Z" if part.closed else "")
        paint = (f'fill="none" stroke="#{part.colour:06x}" stroke-width="{part.width:.2f}" stroke-linejoin="round" '
                 f'stroke-linecap="round" stroke-opacity' if part.width else f'fill="#{part.colour:06x}" fill-opacity')
        lines.append(f'<path d="{path}" {paint}="{part.opacity:g}"/>')
    return "\n".join(lines + ["</svg>", ""])


def distance2_to(x, y, a, b):
    """Square of the distance to the segment a b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    along = ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)
    along = min(1.0, max(0.0, along))
    dx, dy = a[0] + along * dx - x, a[1] + along * dy - y
    return dx * dx + dy * dy


def is_inside(x, y, edges):
    inside = False
    for (ax, ay), (bx, by) in edges:
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


def cover(pixels, size, part):
    """Lays one part over the picture, with edges softened over a pixel."""
    scale = size / CANVAS
    points = [(x * scale, y * scale) for x, y in part.points]
    ends = points[1:] + points[:1] if part.closed else points[1:]
    edges = list(zip(points, ends))
    half = max(part.width * scale, 1.0 if part.width else 0.0) / 2  # no line thinner than a pixel
    reach = half + 1
    colour = [(part.colour >> shift & 255) / 255 for shift in (16, 8, 0)]
    top, bottom = min(y for _, y in points) - reach, max(y for _, y in points) + reach
    for row in range(max(0, int(top)), min(size, int(bottom) + 1)):
        y = row + 0.5
        close = [edge for edge in edges
                 if min(edge[0][1], edge[1][1]) - reach < y < max(edge[0][1], edge[1][1]) + reach]
        seen = close if part.width else edges
        if not seen:
            continue
        left, right = min(min(a[0], b[0]) for a, b in seen) - reach, max(max(a[0], b[0]) for a, b in seen) + reach
        for column in range(max(0, int(left)), min(size, int(right) + 1)):
            x = column + 0.5
            near = min((distance2_to(x, y, a, b) for a, b in close), default=reach * reach)
            if part.width:
                if near >= reach * reach:
                    continue
                distance = near ** 0.5 - half
            else:
                distance = min(near, reach * reach) ** 0.5
                distance = -distance if is_inside(x, y, edges) else distance
            amount = min(1.0, max(0.0, 0.5 - distance)) * part.opacity
            if amount > 0:
                pixel = pixels[row][column]
                for i in range(3):  # premultiplied
                    pixel[i] = colour[i] * amount + pixel[i] * (1 - amount)
                pixel[3] = amount + pixel[3] * (1 - amount)


def picture(parts, size):
    """Rows of RGBA bytes."""
    pixels = [[[0.0] * 4 for _ in range(size)] for _ in range(size)]
    for part in parts:
        if size >= part.least:
            cover(pixels, size, part)
    rows = []
    for row in pixels:
        data = bytearray()
        for r, g, b, a in row:
            data += bytes(int(channel / a * 255 + 0.5) if a else 0 for channel in (r, g, b))
            data.append(int(a * 255 + 0.5))
        rows.append(bytes(data))
    return rows


def png(rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = len(rows)
    above, filtered = bytes(4 * size), bytearray()
    for row in rows:  # filter 2: differences to the row above
        filtered += b"\2" + bytes((now - before) & 255 for now, before in zip(row, above))
        above = row
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes(filtered), 9)) + chunk(b"IEND", b""))


def main():
    usual = Path(__file__).resolve().parent.parent / "cmake/packages/desktop/icons"
    folder = (Path(sys.argv[1]) if len(sys.argv) > 1 else usual) / "hicolor"
    parts = drawing()
    files = {"scalable/apps/gpuwars.svg": svg(parts).encode()}
    files |= {f"{size}x{size}/apps/gpuwars.png": png(picture(parts, size)) for size in SIZES}
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
