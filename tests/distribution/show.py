"""What a run shows of itself while it lasts."""
import shutil


class Progress:
    """One line on a terminal, rewritten each second; elsewhere nothing."""

    def __init__(self, stream):
        self.stream, self.shown, self.suite = stream, stream.isatty(), ""

    def __call__(self, seconds, log):
        if self.shown:
            with log.open("rb") as file:
                file.seek(max(0, log.stat().st_size - 400))
                last = file.read().decode(errors="replace").strip().rpartition("\n")[2]
            width = shutil.get_terminal_size().columns
            line = f"{self.suite}: {seconds // 60:.0f}:{seconds % 60:02.0f} {last}".replace("\r", " ").replace("\t", " ")
            self.stream.write(f"\r\x1b[K{line[:width - 1]}")
            self.stream.flush()

    def clear(self):
        if self.shown:
            self.stream.write("\r\x1b[K")
            self.stream.flush()
