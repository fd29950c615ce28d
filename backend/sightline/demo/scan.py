"""The demonstration's line-scan recording: simulated traffic past two line cameras.

Its vehicles are found and measured by this program; two people fill in facts, click wheels and review.
"""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from sightline.demo.made import ScanTruth, strip_of, truth
from sightline.demo.scan_heights import review_heights, store_heights
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.linescan.parts import Pixels, Rig
from sightline.media.cancelling import Cancelled, check_cancelled
from sightline.media.store.local import key_of
from sightline.media.strips.notes import StripNotes
from sightline.media.strips.stored_reader import StripReader
from sightline.media.strips.stored_writer import SUFFIX, store_strip
from sightline.messages.said import Said
from sightline.recordings.filming import Filming
from sightline.scans.clock import ScanClock
from sightline.scans.records import Changes, StripFacts, StripSource
from sightline.scans.records import ScanVehicle as StoredVehicle
from sightline.scans.references.records import ReferenceValues
from sightline.scans.references.store import append_scan_reference
from sightline.scans.store import create_scan, note_scan_read, update_scan
from sightline.scans.vehicles.find_job import Planned, Search, search, store
from sightline.scans.vehicles.measure import measured_at
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.motion import crossings_of, values_of, wheels_of, with_wheels
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.store import change_scan_vehicle, get_scan_vehicle, list_scan_vehicles

NAME = "Line scan, lane 1"
RIG = Rig(0.593, 2441.4, u_baseline_m=0.0003, u_line_rate_ratio=2e-5)
# As if a GPS clock had stamped line 0.
BEGUN_AT, TIME_ZONE, U_START_S = datetime(2025, 5, 14, 7, 29, 20, tzinfo=UTC), "Europe/Paris", 0.001
CLICK_NOISE_LINES = 1.5
SLIP_LINES = 38.0
U_RADAR_MPS = 0.2
REJECTED = "The rear boundary lies on the shadow behind the vehicle; place it where the bumper ends."
# by the order of passing: without facts, without wheels, accepted, with the slip
PLAIN, UNWHEELED, ACCEPTED, SLIPPED = (6,), (3,), range(7), 7


@dataclass(frozen=True, eq=False)
class ScanParts:
    """The recording, already in the media store, and what was found in it."""

    facts: StripFacts
    readers: tuple[StripReader, StripReader]
    found: Search

    @property
    def keys(self) -> tuple[str, str]:
        return self.facts.first_key, self.facts.second_key


class _Pictured:
    """One camera's simulated lines as a strip."""

    def __init__(self, name: str, lines: Pixels) -> None:
        self.name, self._lines = name, lines
        self.lines, self.rows = lines.shape
        self.dtype: np.dtype[Any] = lines.dtype
        self.notes = StripNotes(RIG.line_rate_hz)

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        size = lines or 4096
        return (self._lines[first : first + size] for first in range(0, self.lines, size))

    def close(self) -> None:
        """Nothing to give back."""


def make_scan(services: Services, is_cancelled: Cancelled) -> ScanParts:
    """Store and search the recording. Raises Stopped."""
    stored = []
    with tempfile.TemporaryDirectory(prefix="demonstration-scan-", dir=services.scratch) as folder:
        for camera in (1, 2):
            strip = _Pictured(f"camera {camera} of {NAME}", strip_of(camera))
            target = Path(folder) / f"{camera}{SUFFIX}"
            one = store_strip(strip, target, is_cancelled=is_cancelled)
            services.media.put_file(key_of(one.sha256, SUFFIX), target, link=True)
            stored.append(one)
    keys = [key_of(one.sha256, SUFFIX) for one in stored]
    first_reader, second_reader = (StripReader(services.media.local_path(key)) for key in keys)
    readers = (first_reader, second_reader)

    def report(_fraction: float, _message: Said) -> None:
        check_cancelled(is_cancelled, NAME)

    findings = search(report, RIG, "direct", readers)
    facts = StripFacts(
        first_key=keys[0],
        second_key=keys[1],
        first_sha256=stored[0].sha256,
        second_sha256=stored[1].sha256,
        rows_px=stored[0].rows,
        lines=stored[0].lines,
        bits=8,
        notes=[Said("scan-simulated")],
    )
    return ScanParts(facts, readers, findings)


def store_scan(session: Session, survey_id: int, parts: ScanParts, *, operator: int, reviewer: int) -> int:
    """Store the recording, its vehicles and what the two people did; the scan's id."""
    source = (
        StripSource("lane-1-first.tif", parts.facts.first_key, parts.facts.first_sha256),
        StripSource("lane-1-second.tif", parts.facts.second_key, parts.facts.second_sha256),
    )
    created = create_scan(
        session,
        survey_id,
        name=NAME,
        source=source,
        time_axis="width",
        rig=RIG,
        lighting="daytime",
        actor=None,
    )
    scan = note_scan_read(session, created.id, parts.facts, actor=None)
    clock = ScanClock(Filming(BEGUN_AT, TIME_ZONE), U_START_S)
    update_scan(session, created.id, {"clock": clock}, version=created.version, actor=operator)
    plans = [Planned(None, motion, "found") for motion in parts.found.motions]
    store(session, scan, "direct", parts.found, plans, 0, job_id=None, actor=None)
    rng, rng_of_radar = np.random.default_rng(20070507), np.random.default_rng(1995)
    for index, vehicle in enumerate(list_scan_vehicles(session, scan.id)):
        true = truth_of(vehicle)
        if true is None:
            continue
        if index not in PLAIN:
            change_scan_vehicle(session, vehicle.id, _facts(true), version=2, actor=operator)
        if index not in (*PLAIN, *UNWHEELED):
            _click_wheels(session, vehicle.id, true, rng, operator)
        if index == SLIPPED:
            _slip(session, vehicle.id, parts, operator)
        _judge(session, vehicle.id, index, reviewer)
        _refer(session, vehicle.id, true, rng_of_radar, operator)
    store_heights(session, scan.id, operator)
    review_heights(session, scan.id, reviewer)
    return scan.id


def _refer(session: Session, vehicle_id: int, true: ScanTruth, rng: np.random.Generator, actor: int) -> None:
    """A radar beside the cameras, as good as it says."""
    value = round(true.speed_mps + float(rng.normal(0.0, U_RADAR_MPS)), 3)
    said = ReferenceValues("speed", "radar", value=value, u=U_RADAR_MPS, device="Simulated radar")
    append_scan_reference(session, vehicle_id, said, seen_revision=0, actor=actor)


def truth_of(vehicle: StoredVehicle) -> ScanTruth | None:
    """What is true of a vehicle that was found; None where nothing is near."""
    if vehicle.measurement is None or vehicle.measurement.values.status != "ok":
        return None
    front = vehicle.measurement.values.front_line_1
    _, nearest = truth().scan.nearest(front)
    return nearest if abs(nearest.front_line_1 - front) < 100 else None


def _facts(true: ScanTruth) -> Changes:
    return {
        **{name: getattr(true, name) for name in ("make", "model", "year", "category")},
        "true_length_m": true.length_m,
        "u_true_length_m": 0.005,
        "true_wheelbase_m": true.wheelbase_m,
        "u_true_wheelbase_m": 0.005,
        "facts_source": "catalogue of the demonstration (invented)",
    }


def _click_wheels(
    session: Session, vehicle_id: int, true: ScanTruth, rng: np.random.Generator, actor: int
) -> None:
    before = get_scan_vehicle(session, vehicle_id).measurement
    assert before is not None
    lines = [round(line + float(rng.normal(0.0, CLICK_NOISE_LINES)), 1) for line in true.wheel_lines_1]
    values = replace(with_wheels(before.values, (lines[0], lines[1])), cause="wheels", placed_by=actor)
    append_scan_measurement(session, vehicle_id, replace(values, run_id=None), actor=actor)


def _slip(session: Session, vehicle_id: int, parts: ScanParts, actor: int) -> None:
    """The operator takes the shadow for the vehicle's rear, at both cameras."""
    before = get_scan_vehicle(session, vehicle_id).measurement
    assert before is not None
    right = crossings_of(before.values)
    wrong = replace(
        right, rear_line_1=right.rear_line_1 + SLIP_LINES, rear_line_2=right.rear_line_2 + SLIP_LINES
    )
    motion = measured_at(wrong, RIG, "direct", parts.readers)
    values = values_of(motion, RIG, "boundaries", placed_by=actor)
    values = with_wheels(values, wheels_of(before.values))
    append_scan_measurement(session, vehicle_id, values, actor=actor)


def _judge(session: Session, vehicle_id: int, index: int, reviewer: int) -> None:
    measured = get_scan_vehicle(session, vehicle_id).measurement
    assert measured is not None
    if index in ACCEPTED:
        add_scan_review(session, measured.id, verdict="accepted", actor=reviewer)
    elif index == SLIPPED:
        add_scan_review(session, measured.id, verdict="rejected", reason=REJECTED, actor=reviewer)
