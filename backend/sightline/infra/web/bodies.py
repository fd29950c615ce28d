"""Bodies that every route module shares: the strict base, the error, points, who, and the job."""

import dataclasses
from collections.abc import Callable, Mapping
from fnmatch import fnmatchcase
from types import NoneType
from typing import Annotated, Any, TypeVar, cast, get_args, get_type_hints

from pydantic import BaseModel, ConfigDict, Field, computed_field, create_model, field_validator
from pydantic_core import PydanticCustomError

from sightline.arrays import Floats
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.messages.said import Said, SaidInWords

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
            raise PydanticCustomError("nul", "a text cannot hold the NUL character")
        return value


Body = TypeVar("Body", bound=BaseModel)


def of_record(
    record: type[Any], *but: str, given: Mapping[str, Any] = {}, optional: bool = False
) -> Callable[[type[Body]], type[Body]]:
    """A body that has, beside its own fields, those of a record or document `but` for some, with defaults.

    `given`: the types of fields by a pattern of their names, with the limits of what comes in or what is said
    of what goes out; else they are the record's, arrays as lists. `optional`: each may be left out.
    """
    hints, plain = get_type_hints(record, include_extras=True), get_type_hints(record)
    defaults = dict.fromkeys(hints, dataclasses.MISSING)
    if dataclasses.is_dataclass(record):
        defaults = {one.name: one.default for one in dataclasses.fields(record)}

    def field_of(field: str, default: Any) -> tuple[Any, Any]:
        kind = next((kind for name, kind in given.items() if fnmatchcase(field, name)), None)
        none_too = NoneType in get_args(plain[field])
        if kind is None:
            kind = hints[field] if none_too or not optional else hints[field] | None
        elif optional or none_too:
            kind = kind | None
        kind = list[float] if kind == Floats else kind
        default = ... if default is dataclasses.MISSING else default
        return kind, None if optional else default

    def made(body: type[Body]) -> type[Body]:
        known = {*but, *body.model_fields}
        fields: Any = {one: field_of(one, default) for one, default in defaults.items() if one not in known}
        about: Any = {"__base__": body, "__module__": body.__module__, "__doc__": body.__doc__}
        return cast(type[Body], create_model(body.__name__, **about, **fields))

    return made


def example(**body: Any) -> ConfigDict:
    """The configuration of a body that comes in, with an example of it; a test sends each to the app."""
    return ConfigDict(json_schema_extra={"examples": [body]})


class Out(BaseModel):
    """A body that goes out; built straight from the storage room's frozen records."""

    model_config = ConfigDict(from_attributes=True)


class ErrorDetail(Out):
    kind: str = Field(description="What sort of refusal: bad_input, not_found, conflict, ...")
    code: str = Field(description="The sentence's name in the catalogue of messages.")
    values: dict[str, str | int | float | SaidInWords] = Field(description="What the sentence holds.")
    message: str = Field(description="The sentence in English: what is wrong and what to do.")


class ErrorBody(Out):
    """Every error of every route; a conflict may carry what is there now."""

    error: ErrorDetail
    current: Any | None = None  # left out where nothing is there, and the description says so (`openapi`)


_ITS_WORK = ("payload", "created_by", "started_at", "attempts", "worker", "cancel_requested", "study_id")


@of_record(Job, *_ITS_WORK, "outages", "not_before")
class JobBody(Out):
    error: Annotated[Said | None, Field(description="Why it failed.")]

    @computed_field  # type: ignore[prop-decorator]
    @property
    def cancellable(self) -> bool:
        """Whether it may be cancelled: it is not over, and of a kind that people cancel."""
        job = cast(Job, self)
        return job.state in ("queued", "running") and job.kind not in registry.housekeeping()

    @field_validator("result", check_fields=False)
    @classmethod
    def _with_words(cls, value: dict[str, Any] | None) -> dict[str, Any] | None:
        """Its `message` is stored as codes, and answered with their sentences."""
        if value is None or not isinstance(value.get("message"), list):
            return value
        return {**value, "message": [Said.read(one).body for one in value["message"]]}
