"""Bodies of statistical figures; a part that cannot be computed is its reason."""

from dataclasses import fields, is_dataclass
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, Field

from sightline.enums import IntervalPart
from sightline.infra.web.bodies import Out, of_record
from sightline.messages.said import Said
from sightline.statistics.distributions import Density, Ecdf
from sightline.statistics.errors import ErrorGroup, Interval


def part_body(part: Any, empty: Said | None = Said("stat-group-empty")) -> Any:
    """A part as it goes out: arrays as lists to the micrometre, its reason where there is none."""
    if part is None:
        return None if empty is None else {"reason": empty}
    if isinstance(part, Said):
        return {"reason": part}
    if not is_dataclass(part):
        return part  # as it went out before
    return {one.name: _round_arrays(getattr(part, one.name)) for one in fields(part)}


def _round_arrays(value: Any) -> Any:
    return round_to_micrometre(value) if isinstance(value, np.ndarray) else value


def round_to_micrometre(values: np.ndarray[Any, Any]) -> list[float]:
    """Values (N,) in metres to the micrometre."""
    found: list[float] = np.round(values, 6).tolist()
    return found


#: A part that is made of a record, or is the reason why there is none.
Part = BeforeValidator(part_body)


class ReasonBody(Out):
    reason: Said


class FigureBody(Out):
    value: float | None
    ci95: Interval | None
    reason: Said | None = Field(description="Why the interval alone is missing.")
    holds: list[IntervalPart] = Field(default=[], description="What the interval holds.")


@of_record(Ecdf)
class EcdfBody(Out):
    """Shares of a sample that are <= value, with a 95 % band that holds everywhere at once; it includes
    sampling only.
    """


@of_record(Density)
class DensityBody(Out):
    pass


EcdfPart = Annotated[EcdfBody | ReasonBody, Part]
DensityPart = Annotated[DensityBody | ReasonBody, Part]


class ErrorFiguresBody(Out):
    """Errors of one group of measurements, measured minus known; each figure with its interval."""

    group: str
    n: int
    figures: dict[str, FigureBody]
    reason: Said | None = Field(description="Why a figure or its interval is missing.")
    words: Said | None = Field(
        description="What the intervals of all but correlations and skewness hold, and for which roads."
    )


def error_figures(group: str, errors: ErrorGroup) -> dict[str, Any]:
    """A group of errors as it goes out."""
    figures = {
        key: {
            "value": value,
            "ci95": part_body(errors.ci95[key], None),
            "reason": _no_interval(errors, key),
            "holds": errors.holds.get(key, ()) if errors.ci95[key] is not None else (),
        }
        for key, value in errors.figures.items()
    }
    return {"group": group, "n": errors.n, "figures": figures, "reason": errors.reason, "words": errors.words}


def _no_interval(one: ErrorGroup, key: str) -> Said | None:
    """Why one figure alone has no interval."""
    if one.reason is not None or one.figures[key] is None or one.ci95[key] is not None:
        return None
    return Said("stat-too-few-errors")
