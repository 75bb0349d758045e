"""The systems that are tested, as a table: what is Debian's release, and what is done on it."""
import dataclasses
from collections.abc import Callable

from cross_build import check_cross
from native import check_native


@dataclasses.dataclass(frozen=True)
class Suite:
    name: str
    release: str  # as debootstrap knows it
    title: str
    check: Callable  # (root, outcome, source, quick): adds what it finds to the outcome


SUITES = {suite.name: suite for suite in (
    Suite("bookworm", "bookworm", "Debian 12", check_native),
    Suite("trixie", "trixie", "Debian 13", check_native),
    Suite("forky", "forky", "Debian 14, testing", check_native),
    Suite("aarch64", "trixie", "AArch64: cross-built on Debian 13, under qemu-user", check_cross),
)}
