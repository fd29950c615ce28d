"""Where live lines come from: one protocol, whatever brings them.

A source gives both cameras' lines in step: line n of either was taken at n / line rate. Lines that were lost
on the way are put back as copies of the line before, and said (`Lost`): nothing after them is shifted.
"""

from __future__ import annotations

import os
import select
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Lines = NDArray[np.uint8]


@dataclass(frozen=True)
class Lost:
    """Lines `line` to `line + count` (numbers that count the lost ones) of camera 1 or 2 did not arrive."""

    camera: int
    line: int
    count: int


@dataclass(frozen=True, eq=False)
class Piece:
    """The next lines of both cameras, (n, rows) each, and which of them are copies."""

    first: Lines
    second: Lines
    lost: tuple[Lost, ...] = ()

    def since(self, line: int) -> Piece:
        """What is left from line `line` of this piece on, `lost` being numbered within it too."""
        lost = [
            Lost(one.camera, max(0, one.line - line), one.count - max(0, line - one.line))
            for one in self.lost
            if one.line + one.count > line
        ]
        return Piece(self.first[line:], self.second[line:], tuple(lost))


class LineSource(Protocol):
    """Both cameras' lines as they come. `notes` says in sentences what went wrong, `broken` whether that
    ended it; `waiting_bytes` is what came and was not yet taken, `last_at` when the last of it came (seconds
    since 1970), None: just now.
    """

    @property
    def name(self) -> str: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def broken(self) -> bool: ...
    @property
    def waiting_bytes(self) -> int: ...
    @property
    def last_at(self) -> float | None: ...

    def pieces(self) -> Iterator[Piece | None]:
        """Lines until the source or the `Ending` ends them; None where none came for a while."""


class Ending:
    """The wish to end, given by a signal or a thread and seen by whoever waits for lines."""

    def __init__(self) -> None:
        self.fd, self.tell_fd = os.pipe()
        os.set_blocking(self.tell_fd, False)

    def wish(self) -> None:
        os.write(self.tell_fd, b"!")

    def wished(self, seconds: float = 0.0) -> bool:
        """Whether it was wished, within so many seconds."""
        return bool(select.select([self.fd], [], [], seconds)[0])

    def close(self) -> None:
        os.close(self.tell_fd)
        os.close(self.fd)


def pairs_of(data: bytes, rows: int) -> Piece:
    """Whole pairs of lines: `rows` bytes of camera 1, as many of camera 2, and so on."""
    both = np.frombuffer(data, np.uint8).reshape(-1, 2, rows)
    return Piece(np.ascontiguousarray(both[:, 0]), np.ascontiguousarray(both[:, 1]))


def describe_replaced(name: str) -> str:
    """The sentence for a file that is not the one that was read until now."""
    return f"{name} was replaced by another file; start again for the new one."


def cut_short(name: str, rest: int) -> str:
    """The sentence for bytes that make no whole pair."""
    return (
        f"{name} ended in the middle of a pair of lines: its last {rest} bytes are left out; check --rows, "
        "and the cameras."
    )
