"""Evidence of one line-scanned vehicle: made of its stored measurement, both strips and the chain, signed."""

import re

from sightline.enums import JsonObject
from sightline.errors import BadInput, Conflict
from sightline.export.evidence.decision import decision_of
from sightline.export.evidence.document import audit_of, facts_of
from sightline.export.evidence.page import program_of_page, written_page
from sightline.export.evidence.pictures import pictures_of
from sightline.export.evidence.records import Evidence, Rule
from sightline.export.evidence.store import events_about, note_evidence
from sightline.export.evidence.translated import translations_of
from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import known_keys, take_key
from sightline.infra.audit.hashing import content_hash
from sightline.infra.audit.records import Who
from sightline.infra.audit.signing import SigningKey, signing_key
from sightline.infra.database import Session
from sightline.infra.database.types import now
from sightline.infra.services import Services
from sightline.linescan.gaps import Leaders
from sightline.linescan.rig import rig_from
from sightline.messages import SOURCE
from sightline.messages.said import Said
from sightline.people.store import get_person
from sightline.scans.records import ScanMeasurement, ScanVehicle
from sightline.scans.service import open_strips
from sightline.scans.store import get_scan
from sightline.scans.vehicles.motion import crossings_of, motion_of
from sightline.scans.vehicles.review_store import scan_reviews_of_vehicle
from sightline.scans.vehicles.store import get_scan_vehicle, list_scan_vehicles
from sightline.surveys.store import get_survey


def make_evidence(
    services: Services, vehicle_id: int, rule: Rule | None, *, language: str = SOURCE, actor: int | None
) -> Evidence:
    """The file of a vehicle as it is now, held against a rule (None: none), noted in the survey's chain; its
    page opens in a language.

    Raises NotFound, BadInput (never measured, a rule that cannot be, pages not built), Conflict (measured
    again meanwhile), Damaged (strips, key).
    """
    page = program_of_page()
    with services.reading() as session:
        vehicle = get_scan_vehicle(session, vehicle_id)
        scan = get_scan(session, vehicle.scan_id)
    measurement = _measured(vehicle)
    pictures = pictures_of(open_strips(services, scan), measurement.values)
    key = signing_key(services.settings)
    with services.writing() as session:
        vehicle = get_scan_vehicle(session, vehicle_id)
        if _measured(vehicle).id != measurement.id:
            raise Conflict("scans-vehicle-measured-meanwhile")
        before = _find_leader(session, vehicle)
        document = _stated(session, vehicle, before, page, actor)
        document["pictures"] = [one.facts for one in pictures]
        document["decision"] = decision_of(document, rule)
        document |= {"language": language, "said": translations_of(document)}
        document |= _vouched(session, vehicle, before, key, actor)
        sha256 = content_hash(document)
        made = {"measurement_id": measurement.id, "sha256": sha256, "key": key.public}
        note_evidence(session, vehicle_id, made, actor=actor)
        content = written_page(document, key.sign(document), pictures)
    return Evidence(filename=_filename(document), content=content, document=document, sha256=sha256)


def _measured(vehicle: ScanVehicle) -> ScanMeasurement:
    if vehicle.measurement is None:
        raise BadInput("evidence-not-measured", number=vehicle.number)
    return vehicle.measurement


def _stated(
    session: Session, vehicle: ScanVehicle, before: ScanVehicle | None, page: str, actor: int | None
) -> JsonObject:
    scan = get_scan(session, vehicle.scan_id)
    return facts_of(
        get_survey(session, vehicle.survey_id),
        scan,
        vehicle,
        _measured(vehicle),
        before,
        made_at=now().isoformat(timespec="microseconds"),
        made_by=None if actor is None else Who(actor, get_person(session, actor).name),
        page=page,
    )


def _find_leader(session: Session, vehicle: ScanVehicle) -> ScanVehicle | None:
    """The vehicle that a gap is measured to (`gaps.Leaders`), of those measured; None where none is known."""
    leaders = Leaders(rig_from(_measured(vehicle).values.rig))
    there = [
        (one, one.measurement.values)
        for one in list_scan_vehicles(session, vehicle.scan_id)
        if one.measurement
    ]
    for one, values in there:
        leader = leaders.leader(crossings_of(values), motion_of(values))
        if one.id == vehicle.id:
            return None if isinstance(leader, Said) else there[leader[0] - 1][0]
    return None


def _vouched(
    session: Session, vehicle: ScanVehicle, before: ScanVehicle | None, key: SigningKey, actor: int | None
) -> JsonObject:
    """Where the chain stood with its events about this vehicle, and the keys up to the one that signs."""
    take_key(session, key, actor=actor)
    shown = [_measured(vehicle), *([_measured(before)] if before else [])]
    judged = {number for one in shown for number in (one.id, one.verdict_of_id)}
    reviews = {
        review.id
        for one in shown
        for review in scan_reviews_of_vehicle(session, one.vehicle_id)
        if review.measurement_id in judged
    }
    measurements = [one.id for one in shown]
    events = events_about(session, vehicle.survey_id, vehicle.scan_id, measurements, reviews)
    audit = audit_of(vehicle.survey_id, trail.head(session, vehicle.survey_id), events)
    return {"audit": audit, "keys": known_keys(session), "key": key.public}


def _filename(document: JsonObject) -> str:
    plain = re.sub(r"[^A-Za-z0-9]+", "-", document["scan"]["name"]).strip("-").lower() or "scan"
    made = document["made_at"][:19].replace("-", "").replace(":", "").replace("T", "-")
    return f"evidence-{plain}-vehicle-{document['vehicle']['number']}-{made}.html"
