"""Which verdict holds for a revision that puts an earlier one back: of a motion, and of a height."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar


class Judged(Protocol):
    """A revision; `judged_id`: the one that its verdict was given on, None while it waits."""

    @property
    def judged_id(self) -> int | None: ...


Revision = TypeVar("Revision", bound=Judged)


def verdict_that_stood(history: Sequence[Revision], same: Callable[[Revision], bool]) -> int | None:
    """The revision on which the newest verdict on the `same` content was given; `history` oldest first."""
    of_same = (one.judged_id for one in reversed(history) if one.judged_id is not None and same(one))
    return next(of_same, None)
