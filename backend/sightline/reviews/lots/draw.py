"""The draw of a lot: an order that follows from the audit chain, so that nobody chooses whom it hits."""

import hashlib
from collections.abc import Iterable


def seed_of(head: str, items: Iterable[tuple[int, int]]) -> str:
    """The seed of a draw: nobody chooses it. sha256 over the hash of the audit event before the draw's, and
    what is in the lot, each as "measurement.revision".
    """
    told = " ".join([head, *(f"{number}.{revision}" for number, revision in sorted(items))])
    return hashlib.sha256(told.encode()).hexdigest()


def drawn_order(seed: str, numbers: Iterable[int]) -> list[int]:
    """The lot's measurements in the order in which they are drawn: by sha256 of seed and number, which
    anybody can compute in any language. The first `sample_size` of those still in the lot are its sample.
    """
    return sorted(numbers, key=lambda one: (hashlib.sha256(f"{seed} {one}".encode()).digest(), one))
