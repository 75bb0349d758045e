"""An X server of our own, with real keys and pictures of what is shown."""
import os
import shutil
import subprocess
import time

from program import skip, without_display

SIZE = (1280, 720)


class Screen:
    def __init__(self, folder):
        for tool in ("Xvfb", "xdotool", "import"):
            if shutil.which(tool) is None:
                skip(f"{tool} is not installed")
        self.folder = folder
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as answer:  # to the end of the line: the server dies of a pipe closed early
            number = answer.readline().strip()
        self.environment = {**without_display(), "DISPLAY": f":{number}", "SDL_VIDEODRIVER": "x11"}
        for _ in range(100):  # the number comes before the door opens
            answer = subprocess.run(["xdotool", "getdisplaygeometry"], env=self.environment,
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if answer.returncode == 0:
                break
            time.sleep(0.1)

    def keys(self, *arguments):
        subprocess.run(["xdotool", *arguments], env=self.environment, check=True)

    def picture(self, name=None):
        """The screen's pixels; with a name they are kept as a PNG too."""
        pixels = subprocess.run(["import", "-window", "root", "-depth", "8", "rgb:-"], env=self.environment,
                                check=True, stdout=subprocess.PIPE).stdout
        if name:
            subprocess.run(["import", "-window", "root", str(self.folder / name)], env=self.environment, check=True)
        return pixels

    def wait_for(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if condition(self.picture()):
                return True
            time.sleep(0.3)
        return False

    def close(self):
        self.server.terminate()
        self.server.wait()


def lit(pixels):
    """How many bytes of the picture are bright."""
    return sum(1 for byte in pixels[::7] if byte > 150)


def below_header(pixels):
    """But for the real frame rate, which is real even in a pause."""
    return pixels[SIZE[0] * 60 * 3:]
