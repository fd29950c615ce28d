"""Numbers that name a thing, in bodies and queries: each type says what its number is of.

    class NewPose(In):
        calibration_id: CalibrationId

From the types alone `Naming` finds what a request names beside its path, as the route itself will read it.
"""

from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Annotated, Any

from fastapi import Request
from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute
from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter, ValidationError, ValidationInfo
from pydantic_core import CoreSchema, core_schema

from sightline.infra.web.bodies import Id

#: A table and the number of a row.
Thing = tuple[str, int]
#: Where the description of the API says which table a number is of.
KEY = "x-names"

_ID = TypeAdapter(Id)


class Names:
    """Marks a number as that of a row of `table`."""

    def __init__(self, table: str) -> None:
        self.table = table

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.with_info_after_validator_function(self._note, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {**handler(schema), KEY: self.table}

    def _note(self, value: int, info: ValidationInfo) -> int:
        if info.context is not None:
            info.context.append((self.table, value))
        return value


CalibrationId = Annotated[Id, Names("calibrations")]
CameraId = Annotated[Id, Names("cameras")]
LotId = Annotated[Id, Names("lots")]
MeasurementId = Annotated[Id, Names("measurement_series")]
PhotographId = Annotated[Id, Names("survey_photographs")]
PoseId = Annotated[Id, Names("road_poses")]
RecordingId = Annotated[Id, Names("recordings")]
ScanVehicleId = Annotated[Id, Names("scan_vehicles")]
SurveyId = Annotated[Id, Names("surveys")]
UploadId = Annotated[Id, Names("uploads")]
VehicleId = Annotated[Id, Names("vehicles")]


class Naming:
    """What the queries and the body of one route may name."""

    def __init__(self, route: APIRoute) -> None:
        fields = {field.alias: _adapter(field.field_info) for field in _query_fields(route.dependant)}
        self._asked = {
            name: table for name, type_ in fields.items() for table in _tables(type_.json_schema())
        }
        body = None if route.body_field is None else _adapter(route.body_field.field_info)
        self._body = body if body is not None and any(_tables(body.json_schema())) else None

    def in_query(self, request: Request) -> Iterator[Thing]:
        """What the query names; what is no number is left to the route's own check."""
        for name, table in self._asked.items():
            for value in dict.fromkeys(request.query_params.getlist(name)):
                yield from named_thing(table, value)

    async def in_body(self, request: Request) -> tuple[Thing, ...]:
        """What the body names, also where the rest of it cannot be used."""
        if self._body is None:
            return ()
        found: list[Thing] = []
        with suppress(ValueError):  # the route refuses it, by the same types
            self._body.validate_python(await request.json(), context=found)
        return tuple(dict.fromkeys(found))


_known: dict[Callable[..., Any], Naming] = {}


def naming_of(route: APIRoute) -> Naming:
    """The same for every request of a route."""
    if route.endpoint not in _known:
        _known[route.endpoint] = Naming(route)
    return _known[route.endpoint]


def named_thing(table: str, value: str) -> Iterator[Thing]:
    """The row that a text names, read as the routes read numbers ("7.0" is 7); nothing where it is none."""
    try:
        yield table, _ID.validate_python(value)
    except ValidationError:
        return


def _adapter(field: Any) -> TypeAdapter[Any]:
    type_: Any = Annotated[field.annotation, *field.metadata] if field.metadata else field.annotation
    return TypeAdapter(type_)


def _query_fields(dependant: Dependant) -> Iterator[Any]:
    yield from dependant.query_params
    for inner in dependant.dependencies:
        yield from _query_fields(inner)


def _tables(schema: Any) -> Iterator[str]:
    """Every table that a JSON schema says its numbers are of."""
    if isinstance(schema, dict):
        if isinstance(schema.get(KEY), str):
            yield schema[KEY]
        schema = list(schema.values())
    if isinstance(schema, list):
        for part in schema:
            yield from _tables(part)
