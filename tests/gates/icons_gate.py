"""The committed icons are what tools/make_icon.py draws: the SVG byte for byte, of PNG what they hold, because how well
it is compressed differs among versions of zlib."""
import zlib

import gate_tools
import generated_files

GENERATOR = "tools/make_icon.py"
ICONS = "cmake/packages/desktop/icons"
SIGNATURE = b"\x89PNG\r\n\x1a\n"


def unpacked(path):
    data = path.read_bytes()
    if not data.startswith(SIGNATURE):
        return data
    parts, at = [], len(SIGNATURE)
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        parts.append(kind + (zlib.decompress(body) if kind == b"IDAT" else body))
        at += 12 + length
    return b"".join(parts)


def check(source, _build=None):
    return generated_files.check(source, GENERATOR, ICONS, "icons", unpacked)


def planted(_build, folder):
    return generated_files.planted(folder, GENERATOR, ICONS, check)


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
