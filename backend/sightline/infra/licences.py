"""The libraries that this process runs on, with the licences that they state."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.metadata import PackageNotFoundError, metadata, requires, version

_LEGAL = "License :: OSI Approved :: "
_NEEDED = re.compile(r"([\w.-]+)(?:\[([\w,-]+)\])?")
_EXTRA = re.compile(r"extra == [\"']([\w-]+)")
_SHORT = 60


@dataclass(frozen=True, slots=True)
class Library:
    """A package; `licence` is what it states, None where it states nothing."""

    name: str
    version: str
    licence: str | None


@cache
def libraries() -> tuple[Library, ...]:
    """What Sightline needs and what that needs, as it is installed, by name."""
    installed: dict[str, Library] = {}
    visited: set[tuple[str, str]] = set()
    waiting = [("sightline", "")]
    while waiting:
        name, extras = wanted = waiting.pop()
        if wanted in visited:
            continue
        visited.add(wanted)
        try:
            installed[name] = Library(name, version(name), stated_licence(name))
        except PackageNotFoundError:
            continue  # for another system or another Python
        waiting += _needed(name, extras.split(","))
    del installed["sightline"]
    return tuple(installed[name] for name in sorted(installed))


def _needed(name: str, extras: list[str]) -> Iterator[tuple[str, str]]:
    """What a package needs, with the extras of each."""
    for line in requires(name) or ():
        extra = _EXTRA.search(line)
        if extra is None or extra[1] in extras:
            one = _NEEDED.match(line)
            if one is not None:
                yield plain_name(one[1]), one[2] or ""


def plain_name(name: str) -> str:
    """One spelling for each package's name."""
    return re.sub(r"[-_.]+", "-", name).lower()


def stated_licence(name: str) -> str | None:
    """What an installed package states: an expression, else its classifiers, else a short text."""
    try:
        stated = metadata(name)
    except PackageNotFoundError:
        return None
    classes = [
        one.removeprefix(_LEGAL) for one in stated.get_all("Classifier") or () if one.startswith(_LEGAL)
    ]
    text, *_ = stated.get_all("License") or [""]
    short = text if len(text) <= _SHORT and "\n" not in text else ""
    expression, *_ = stated.get_all("License-Expression") or [""]
    return expression or " AND ".join(classes) or short or None
