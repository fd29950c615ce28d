"""Bodies that every route module shares: the strict base, the error, points, who, and the job."""

from collections.abc import Callable, Iterable
from dataclasses import fields
from datetime import datetime
from operator import attrgetter
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ConfigDict, Field, field_validator

from sightline.enums import JobState

Finite = Annotated[float, Field(allow_inf_nan=False)]
Point = Annotated[tuple[Finite, Finite], Field(examples=[[320.5, 240.25]])]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Text = Annotated[str, Field(max_length=10_000)]
# Ids are 32-bit in PostgreSQL; a larger number is a malformed id, not a database error.
Id = Annotated[int, Field(ge=1, le=2**31 - 1)]
FrameNumber = Annotated[int, Field(ge=0, le=2**31 - 1)]


class In(BaseModel):
    """A body that comes in: unknown keys are refused, so that a misspelt one is never silently dropped."""

    model_config = ConfigDict(extra="forbid")

    @field_validator("*", mode="after")
    @classmethod
    def _without_nul(cls, value: Any) -> Any:
        """PostgreSQL's texts hold no NUL; SQLite's would, and could then not be moved there."""
        if isinstance(value, str) and "\x00" in value:
            raise ValueError("a text cannot hold the NUL character")
        return value


class Out(BaseModel):
    """A body that goes out; built straight from the storage room's frozen records."""

    # what has a default goes out all the same, and its description says so
    model_config = ConfigDict(from_attributes=True, json_schema_serialization_defaults_required=True)


B = TypeVar("B")
_Taker = tuple[list[str], Callable[[object], Iterable[object]]]
_TAKERS: dict[tuple[object, ...], list[_Taker]] = {}  # as many as there are kinds of answers


def made_of(body: type[B], *records: object, **more: object) -> B:
    """An answer (a dataclass) with what the records hold under its fields' names, and `more` besides.

    Of two records that hold a name the first counts. Raises TypeError where neither holds one.
    """
    key = (body, *(type(record) for record in records), *more)
    take = _TAKERS.get(key) or _TAKERS.setdefault(key, _takers(body, records, more))
    for record, (names, values_of) in zip(records, take, strict=True):
        more.update(zip(names, values_of(record), strict=True))
    return body(**more)


def _takers(body: Any, records: Iterable[Any], given: Iterable[str]) -> list[_Taker]:
    """Of each record the names that are taken from it, and what takes their values."""
    wanted = [field.name for field in fields(body) if field.name not in given]
    takers: list[_Taker] = []
    for record in records:
        held = {field.name for field in fields(record)}
        names = [name for name in wanted if name in held]
        wanted = [name for name in wanted if name not in held]
        takers.append((names, _values_getter(names)))
    return takers


def _values_getter(names: list[str]) -> Callable[[object], Iterable[object]]:
    """One call for all names of a record: a list of thousands of measurements is an ordinary answer."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda record: [getattr(record, name) for name in names]


class ErrorDetail(Out):
    code: str
    message: str = Field(description="One sentence that says what is wrong and what to do.")


class ErrorBody(Out):
    """Every error of every route; a conflict may carry what is there now."""

    # `current` is left out where nothing is there, and the description says so
    model_config = ConfigDict(json_schema_serialization_defaults_required=False)

    error: ErrorDetail
    current: Any | None = None


class JobBody(Out):
    id: int
    kind: str
    state: JobState
    progress: float
    message: str
    error: str | None
    result: dict[str, Any] | None
    survey_id: int | None
    recording_id: int | None
    scan_id: int | None = None
    created_at: datetime
    finished_at: datetime | None
