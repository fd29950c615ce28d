"""Holding numbers against what this program computes: to the last digit where the same one computed them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from sightline.errors import BadInput, Damaged

_DIFFERENCES = (Damaged, BadInput, ArithmeticError, LookupError, TypeError, ValueError)


@dataclass(eq=False)
class Recomputing:
    """What was computed again. `is_alike`: whether this program computes a part as a version of it did.

    A number of a program that computes alike must be the one that is found. Of any other version's, those
    that are not are counted and no change is seen in them: their audit events and the seal bind them.
    """

    is_alike: Callable[[str, str], bool]
    equal: int = 0
    differing: int = 0
    first: str = ""

    @contextmanager
    def of(self, part: str, *versions: str) -> Iterator[None]:
        """Compare in the block what a part of these versions computed. Raises what the block raises."""
        try:
            yield
        except _DIFFERENCES as difference:
            if all(self.is_alike(part, by) for by in versions):
                raise
            self.differing += 1
            self.first = self.first or getattr(difference, "message", "") or repr(difference)
        else:
            self.equal += 1
