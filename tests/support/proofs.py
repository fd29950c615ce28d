"""What is left to `make proofs`, and whether this run is one."""

import os
from collections.abc import Iterable
from typing import Any

import pytest

PROOFS = os.environ.get("SIGHTLINE_PROOFS") == "1"


def every(nth: int, cases: Iterable[Any]) -> list[Any]:
    """Cases of one statement for `parametrize`: the first and every `nth` after it; the others are proofs."""
    return [
        case if n % nth == 0 else pytest.param(case, marks=pytest.mark.proof) for n, case in enumerate(cases)
    ]
