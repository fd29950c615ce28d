"""What is left to `make proofs`, and whether this run is one."""

import os
from collections.abc import Collection, Iterable
from typing import Any

import pytest

PROOFS = os.environ.get("SIGHTLINE_PROOFS") == "1"


def every(nth: int, cases: Iterable[Any], also: Collection[Any] = ()) -> list[Any]:
    """Cases of one statement for `parametrize`: the first, every `nth` after it, and those that alone reach a
    branch of the product (`also`); the others are proofs.
    """
    given = list(cases)
    assert all(one in given for one in also), "a case that is not there"
    return [
        case if n % nth == 0 or case in also else pytest.param(case, marks=pytest.mark.proof)
        for n, case in enumerate(given)
    ]
