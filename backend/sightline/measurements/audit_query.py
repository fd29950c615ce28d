"""What the audit chain says of a measurement's place: its survey, its vehicle and what it repeats."""

from collections.abc import Iterator, Mapping
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit.vouched import Event, Fingerprint, register
from sightline.measurements.tables import measurement_series

_PLACE = ("vehicle_id", "scan_vehicle_id", "repeat_of")


def _promise(event: Event, promised: dict[int, str]) -> None:
    if (event.entity, event.action) == ("measurement", "create") and event.entity_id is not None:
        told = {name: event.after.get(name) for name in _PLACE}
        promised[event.entity_id] = _place_text({**told, "survey_id": event.survey_id})


def _stored_fingerprints(session: Session) -> Iterator[tuple[int, str]]:
    query = select(measurement_series).order_by(measurement_series.c.id).execution_options(yield_per=1000)
    with session.execute(query) as series:
        for row in series.mappings():
            yield row["id"], _place_text({name: row[name] for name in ("survey_id", *_PLACE)})


def _place_text(place: Mapping[str, Any]) -> str:
    return str(sorted(place.items()))


register(Fingerprint("series", _promise, _stored_fingerprints))
