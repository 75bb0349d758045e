"""An X server of our own, with real keys and pictures of what is shown."""
import os
import shutil
import subprocess
import time

from program import skip, without_display

SIZE = (1280, 720)

# Key codes of X for places on the board, by the names of a US keyboard. A key named as a keysym is looked for on the
# layout in use; and newer keyboard data have a level of F1 to F12 that xdotool reaches with Alt.
PLACES = {f"F{number}": 66 + number for number in range(1, 11)} | {"F11": 95, "F12": 96}
PLACES |= {name: first + index for first, row in ((10, "1234567890-="), (24, "QWERTYUIOP[]"), (38, "ASDFGHJKL;'"),
                                                  (52, "ZXCVBNM,./")) for index, name in enumerate(row)}
FUNCTION_KEYS = {name: str(code) for name, code in PLACES.items() if name[0] == "F" and len(name) > 1}


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
        subprocess.run(["xdotool", *(FUNCTION_KEYS.get(word, word) for word in arguments)], env=self.environment,
                       check=True)

    def press_place(self, name):
        """The key that is called so on a US keyboard, whatever the layout makes of it."""
        self.keys("key", str(PLACES[name]))

    def layout(self, *arguments):
        """setxkbmap's arguments; games see it a moment later."""
        if shutil.which("setxkbmap") is None:
            skip("setxkbmap is not installed")
        subprocess.run(["setxkbmap", *arguments], env=self.environment, check=True)
        time.sleep(0.5)

    def window_of(self, process):
        """The id of a program's window."""
        for _ in range(100):
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(process.pid)],
                                   env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            if found.stdout.split():
                return found.stdout.split()[-1]
            time.sleep(0.1)
        raise AssertionError("no window appears")

    def pointer(self):
        """(x, y) on the screen."""
        told = subprocess.run(["xdotool", "getmouselocation"], env=self.environment, check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        x, y = (int(word.split(":")[1]) for word in told.split()[:2])
        return x, y

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
