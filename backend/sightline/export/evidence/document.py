"""What an evidence file says: one document, and those parts of it that follow from others by arithmetic.

`derived_parts` gives these parts from the rest of the document, so that a file is verified by the functions
that made it: the baseline at the vehicle, the gap to the vehicle before, the time of day. The decision is in
`decision`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from sightline.enums import JsonObject
from sightline.infra.audit.hashing import canonical_json, to_plain_json
from sightline.infra.audit.records import AuditEvent, AuditHead, Who, survey_chain
from sightline.infra.version import code_version
from sightline.linescan.clock import since_start_s
from sightline.linescan.gaps import gaps
from sightline.linescan.rig import baseline_of, rig_from
from sightline.messages import SOURCE
from sightline.messages.said import Said
from sightline.scans.clock import clock_of, passing_of
from sightline.scans.records import Scan, ScanMeasurement, ScanValues, ScanVehicle
from sightline.scans.store import rig_for
from sightline.scans.vehicles.motion import crossings_of, motion_of
from sightline.surveys.records import Survey

FORMAT = "sightline-evidence-1"
_SCAN = (
    "id",
    "name",
    "source",
    "first_name",
    "second_name",
    "first_source_sha256",
    "second_source_sha256",
    "first_sha256",
    "second_sha256",
    "rows_px",
    "lines",
    "bits",
    "notes",
)
_VEHICLE = ("id", "number", "origin", "make", "model", "year", "category", "lighting")
_VALUES = tuple(one.name for one in fields(ScanValues) if one.name != "profile")

Document = Mapping[str, Any]


def facts_of(
    survey: Survey,
    scan: Scan,
    vehicle: ScanVehicle,
    measured: ScanMeasurement,
    before: ScanVehicle | None,
    *,
    made_at: str,
    made_by: Who | None,
    page: str,
) -> JsonObject:
    """What the document states, and what follows from it."""
    stated = {
        "format": FORMAT,
        "made_at": made_at,
        "made_by": made_by,
        "program": code_version(),
        "page": page,
        "survey": {"id": survey.id, "name": survey.name, "site": survey.site},
        "scan": {name: getattr(scan, name) for name in _SCAN},
        "vehicle": {name: getattr(vehicle, name) for name in _VEHICLE},
        "measurement": _revision(measured),
        "review": _review(measured),
        "before": _json_of_leader(before),
        "rig_now": rig_for(scan.rig, measured.values.lane, measured.values.direction),
        "clock": None if scan.clock is None else scan.clock.columns(),
    }
    told: JsonObject = to_plain_json(stated)
    found = derived_parts(told)
    return {**told, **found, "words": words_of(scan.notes, measured.values, found["gap"])}


def audit_of(survey_id: int, head: AuditHead, events: Sequence[AuditEvent]) -> JsonObject:
    """Where the survey's chain stood, and whole events of it, as it hashes them."""
    return {
        "chain": survey_chain(survey_id),
        "count": head.count,
        "hash": head.hash,
        "events": [_event(one) for one in events],
    }


def derived_parts(document: Document) -> JsonObject:
    """The parts that follow from the others, as the document holds them."""
    return {"at_vehicle": _at_vehicle(document), "gap": _gap(document), "time": _time(document)}


def values_of_document(told: Document) -> ScanValues:
    """A stored motion of a document as a revision's values again, without its profile."""
    values = {name: told[name] for name in _VALUES}
    values["reason"] = values["reason"] and Said.read(values["reason"])
    values["warnings"] = [Said.read(one) for one in values["warnings"]]
    return ScanValues(profile=None, **values)


def _at_vehicle(document: Document) -> JsonObject:
    baseline_m, u_m = baseline_of(rig_from(document["measurement"]["rig"]))
    return {"baseline_m": baseline_m, "u_baseline_m": u_m}


def _gap(document: Document) -> JsonObject | None:
    """Without a headway, which runs from the front before: that may be another vehicle's."""
    if document["before"] is None:
        return None
    pair = [values_of_document(document[name]) for name in ("before", "measurement")]
    vehicles = [(crossings_of(one), motion_of(one), rig_from(one.rig)) for one in pair]
    found = gaps(vehicles, vehicles[1][2])
    gap: JsonObject = to_plain_json(asdict(found[1]))
    return {name: value for name, value in gap.items() if name != "headway_s"}


def words_of(
    notes: Sequence[Said], values: ScanValues, gap: JsonObject | None, language: str = SOURCE
) -> JsonObject:
    """What the codes of the import, of the motion and of the gap say; the page has no catalogue of them."""
    why = gap and gap["reason"]
    return {
        "reason": values.reason and values.reason.sentence(language),
        "warnings": [one.sentence(language) for one in values.warnings],
        "gap": why and Said.read(why).sentence(language),
        "notes": [one.sentence(language) for one in notes],
    }


def _time(document: Document) -> JsonObject:
    measured = document["measurement"]
    rig = measured["rig"]
    times: JsonObject = {"since_start_s": since_start_s(measured["front_line_1"], rig["line_rate_hz"])}
    clock = None if document["clock"] is None else clock_of(document["clock"])
    if clock is None:
        return {**times, "filmed_at": None, "u_filmed_at_s": None}
    motion = (measured["front_line_1"], measured["speed_mps"], measured["u_length_m"], rig)
    return {**times, **asdict(passing_of(clock, *motion))}


def _revision(measurement: ScanMeasurement) -> JsonObject:
    values = {name: getattr(measurement.values, name) for name in _VALUES}
    provenance = {
        "id": measurement.id,
        "revision": measurement.revision,
        "created_at": measurement.created_at,
        "created_by": measurement.created_by,
    }
    return {**provenance, **values}


def _review(one: ScanMeasurement) -> JsonObject:
    given = one.review
    return {"verdict": given.verdict, "reason": given.reason, "reviewer": given.reviewer, "at": given.at}


def _json_of_leader(vehicle: ScanVehicle | None) -> JsonObject | None:
    if vehicle is None or vehicle.measurement is None:
        return None
    this = {"vehicle_id": vehicle.id, "number": vehicle.number, "review": _review(vehicle.measurement)}
    return {**_revision(vehicle.measurement), **this}


def _event(event: AuditEvent) -> JsonObject:
    """An event's row, as the chain hashes it: before and after as canonical text."""
    same = ("chain", "number", "action", "entity", "entity_id", "survey_id", "previous_hash", "hash")
    return {
        **{name: getattr(event, name) for name in same},
        "at": to_plain_json(event.at),
        "actor_id": None if event.actor is None else event.actor.id,
        "before": None if event.before is None else canonical_json(event.before),
        "after": None if event.after is None else canonical_json(event.after),
    }
