"""The committed sounds are what tools/make_sounds.py makes, byte for byte."""
import gate_tools
import generated_files

GENERATOR = "tools/make_sounds.py"
SOUNDS = "assets/sounds"


def check(source, _build=None):
    return generated_files.check(source, GENERATOR, SOUNDS, "sounds")


def planted(_build, folder):
    return generated_files.planted(folder, GENERATOR, SOUNDS, check)


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
