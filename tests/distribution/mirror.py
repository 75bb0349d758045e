"""Where this machine gets its Debian packages from, and how: read out of apt's own settings."""
import re
import subprocess
import urllib.error
import urllib.request
from pathlib import Path

FETCHED = ("http://", "https://", "file:/")  # what debootstrap can fetch from
BY_RANK = ("oldstable", "stable", "testing", "unstable", "sid")  # names of releases that move


class NoMirror(Exception):
    """One sentence: why there is none."""


def one_line_sources(text):
    """(types, addresses, suites, components) of each line of the old format: deb [options] ADDRESS SUITE COMPONENT..."""
    for line in text.splitlines():
        words = re.sub(r"\[[^]]*\]", " ", line.split("#")[0]).split()
        if len(words) >= 3:
            yield [words[0]], [words[1]], [words[2]], words[3:]


def stanza_sources(text):
    """The same of each stanza of a .sources file."""
    for stanza in re.split(r"\n\s*\n", text):
        fields, name = {}, None
        for line in stanza.splitlines():
            if line.startswith("#"):
                continue
            if line[:1].isspace():
                fields.setdefault(name, []).extend(line.split())
            elif ":" in line:
                name, _, value = line.partition(":")
                name = name.lower()
                fields[name] = value.split()
        if fields.get("enabled", ["yes"]) != ["no"]:
            yield tuple(fields.get(key, []) for key in ("types", "uris", "suites", "components"))


def machine_mirror(etc=Path("/etc")):
    """The address from which this machine takes the main archive of its own Debian release."""
    known = etc / "os-release"
    release = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', known.read_text(), re.MULTILINE)) if known.is_file() else {}
    if release.get("ID") != "debian":
        raise NoMirror("this machine is no Debian; name a mirror of Debian with --mirror")
    sources = etc / "apt"
    files = [sources / "sources.list", *sorted((sources / "sources.list.d").glob("*"))]
    for file in filter(Path.is_file, files):
        if file.suffix not in (".list", ".sources"):
            continue
        read = stanza_sources if file.suffix == ".sources" else one_line_sources
        for types, addresses, suites, components in read(file.read_text(errors="replace")):
            if "deb" in types and "main" in components and {release.get("VERSION_CODENAME"), *BY_RANK} & set(suites):
                for address in addresses:
                    if address.startswith(FETCHED):
                        return address.rstrip("/")
    raise NoMirror("apt's sources name no mirror of Debian that debootstrap can fetch from; name one with --mirror")


def apt_settings():
    """apt's settings of this machine that decide whether it may fetch: proxies, certificates, checks of dates."""
    try:
        dump = subprocess.run(["apt-config", "dump"], stdout=subprocess.PIPE, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return ""
    return "".join(line + "\n" for line in dump.splitlines() if re.match(r"Acquire::(http|https|Check-[\w-]*)\b", line))


def proxies(settings, environment):
    """Variables that tell debootstrap and others of the proxy: the environment's, else apt's."""
    found = {key: environment[key] for key in ("http_proxy", "https_proxy", "no_proxy") if environment.get(key)}
    for scheme in ("http", "https"):
        of_apt = re.search(rf'^Acquire::{scheme}::Proxy "([^"]+)";$', settings, re.MULTILINE)
        if of_apt and of_apt[1] != "DIRECT":
            found.setdefault(f"{scheme}_proxy", of_apt[1])
    return found


def check_answers(mirror, release, through):
    """Raises NoMirror when a release cannot be had there; `through`: proxies()."""
    handler = urllib.request.ProxyHandler({key.removesuffix("_proxy"): value for key, value in through.items()})
    try:
        with urllib.request.build_opener(handler).open(f"{mirror}/dists/{release}/Release", timeout=30):
            return
    except (urllib.error.URLError, OSError, ValueError) as error:
        raise NoMirror(f"the mirror has no {release} or does not answer ({error})") from None
