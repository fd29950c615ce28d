"""Finding and measuring the vehicles of a scan, as a job; what people placed or took out stays as it is."""

from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from sightline.enums import Cause, ScanMethod
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.version import code_version
from sightline.linescan import faults
from sightline.linescan.finding import Finder
from sightline.linescan.parts import STOOD, STOPPED, Motion, Rig
from sightline.linescan.passing import is_told
from sightline.linescan.rig import gain, misalignment
from sightline.messages.said import Said
from sightline.scans.records import RunSummary, Scan, ScanRunValues, ScanValues, ScanVehicle, same_motion
from sightline.scans.service import FIND, open_strips
from sightline.scans.store import get_scan, rig_columns
from sightline.scans.vehicles.measure import Readers, measure_passage, measured_again, measured_at
from sightline.scans.vehicles.measurement_store import append_scan_measurements
from sightline.scans.vehicles.motion import lane_by_person, values_of, with_people
from sightline.scans.vehicles.run_store import add_scan_run
from sightline.scans.vehicles.store import (
    create_scan_vehicles,
    list_scan_vehicles,
    scan_vehicles_placed_by_hand,
)

SAME_SHARE = 0.5
NEIGHBOURS = 4
Report = Callable[[float, Said], None]
_AGAIN = Said("job-vehicles-again")


@dataclass(frozen=True, eq=False)
class Search:
    """What was found: motions in the order of passing, and what is to be said of the recording."""

    motions: tuple[Motion, ...] = ()
    notes: tuple[Said, ...] = ()


@dataclass(frozen=True, eq=False)
class Planned:
    """What is to be stored: a new vehicle (None) or a revision of one, as it was when it was planned."""

    vehicle: ScanVehicle | None
    motion: Motion
    cause: Cause


@registry.handler(FIND, long=True)
def find_vehicles(context: JobContext) -> Finish:
    """Look through both strips once and measure every vehicle; all is stored with the job's end."""
    services = context.services
    scan_id = context.job.scan_id
    assert scan_id is not None
    with services.reading() as session:
        scan = get_scan(session, scan_id)
        known = list_scan_vehicles(session, scan_id, deleted=True)
        by_hand = scan_vehicles_placed_by_hand(session, scan_id)
    method: ScanMethod = context.payload["method"]
    readers = open_strips(services, scan)
    searched = Search()
    if context.payload.get("search", True):
        searched = search(context.progress, scan.rig, method, readers)
    plans, discarded = plan(context.progress, searched, known, by_hand, scan.rig, method, readers)

    def finish(session: Session) -> Mapping[str, Any]:
        place = {"job_id": context.job.id, "actor": context.actor}
        return store(session, scan, method, searched, plans, discarded, **place)

    return finish


def search(report: Report, rig: Rig, method: ScanMethod, readers: Readers) -> Search:
    """Every vehicle of the strips, measured as soon as it has passed; memory is bounded."""
    finder = Finder(readers[0].rows, rig, readers[0].bits)
    motions: list[Motion] = []
    for done, passages in _passages(finder, readers):
        measured = [(one, measure_passage(one, rig, method, readers)) for one in passages]
        motions += [motion for one, motion in measured if is_told(one, motion)]
        report(0.9 * done / readers[0].lines, Said("job-vehicles-found", count=len(motions)))
    motions.sort(key=lambda one: one.crossings.front_line_1)
    return Search(tuple(motions), tuple(faults.notes_of(finder)))


def _passages(finder: Finder, readers: Readers) -> Iterator[tuple[int, list[Any]]]:
    done = 0
    for first, second in zip(readers[0].chunks(), readers[1].chunks(), strict=True):
        done += len(first)
        yield done, finder.push(first, second)
    yield done, finder.finish()


def plan(
    report: Report,
    searched: Search,
    known: Sequence[ScanVehicle],
    by_hand: frozenset[int],
    rig: Rig,
    method: ScanMethod,
    readers: Readers,
) -> tuple[list[Planned], int]:
    """What to store, and how many found vehicles had been taken out by a person."""
    plans: list[Planned] = []
    matched: set[int] = set()
    discarded = 0
    there_already = Known(known)
    for motion in searched.motions:
        there = there_already.same_as(motion)
        if there is None:
            plans.append(Planned(None, motion, "found"))
        elif there.deleted:
            discarded += 1
        elif there.id not in by_hand and there.id not in matched:
            matched.add(there.id)
            chosen = lane_by_person(there.measurement)
            if chosen is not None:
                motion = measured_at(motion.crossings, rig, method, readers, chosen, motion)
            plans.append(Planned(there, motion, "again"))
    again = [one for one in known if not one.deleted and one.id not in matched and one.measurement]
    for count, vehicle in enumerate(again):
        report(0.9 + 0.09 * count / len(again), _AGAIN)
        assert vehicle.measurement is not None
        motion = measured_again(vehicle.measurement, rig, method, readers)
        plans.append(Planned(vehicle, motion, "again"))
    return plans, discarded


def store(
    session: Session,
    scan: Scan,
    method: ScanMethod,
    searched: Search,
    plans: Sequence[Planned],
    discarded: int,
    *,
    job_id: int | None,
    actor: int | None,
) -> dict[str, Any]:
    """Write the run and what it changes. What somebody changed while it ran stays as they left it."""
    rig = scan.rig
    motions = [planned.motion for planned in plans]
    run = add_scan_run(
        session,
        scan.id,
        run_values(method, rig, motions, len(searched.motions), searched.notes),
        job_id=job_id,
        actor=actor,
    )
    now = list_scan_vehicles(session, scan.id, deleted=True)
    by_id, there_already = {one.id: one for one in now}, Known(now)
    new: list[ScanValues] = []
    again: list[tuple[int, ScanValues]] = []
    overtaken = 0
    for planned in plans:
        values = values_of(planned.motion, rig, planned.cause, run_id=run.id)
        if planned.vehicle is None:
            if there_already.same_as(planned.motion) is not None:
                overtaken += 1
                continue
            new.append(values)
            continue
        current = by_id.get(planned.vehicle.id)
        before = planned.vehicle.measurement
        if current is None or current.version != planned.vehicle.version or before is None:
            overtaken += 1
            continue
        values = with_people(replace(values, placed_by=before.values.placed_by), before.values)
        if not same_motion(before.values, values):
            again.append((planned.vehicle.id, values))
    # all at once: whoever else writes waits for the end of this
    made = create_scan_vehicles(session, scan.id, len(new), origin="found", actor=actor)
    append_scan_measurements(session, scan.id, [*zip(made, new, strict=True), *again], actor=actor)
    added, revised = len(new), len(again)
    counts = {"added": added, "measured_again": revised, "discarded": discarded, "overtaken": overtaken}
    return {
        "scan_id": scan.id,
        "run_id": run.id,
        "found": len(searched.motions),
        **counts,
        "message": _summarise_run(len(searched.motions), added, revised, overtaken),
    }


class Known:
    """The vehicles that are there, looked up by where they are in strip 1."""

    def __init__(self, vehicles: Sequence[ScanVehicle]) -> None:
        placed = [(one.measurement.values.front_line_1, one) for one in vehicles if one.measurement]
        placed.sort(key=lambda pair: pair[0])
        self._fronts = [front for front, _ in placed]
        self._vehicles = [one for _, one in placed]

    def same_as(self, motion: Motion) -> ScanVehicle | None:
        """The vehicle with which this one shares half of the shorter span, None where there is none. Others
        pass within the span of one that stands: where either does, their fronts are as near as that.
        """
        at = bisect_left(self._fronts, motion.crossings.front_line_1)
        near = self._vehicles[max(0, at - NEIGHBOURS) : at + NEIGHBOURS]
        # one that stands before one that was taken out
        near.sort(key=lambda one: one.deleted)
        return next((one for one in near if _shared(motion, one)), None)


def _shared(motion: Motion, known: ScanVehicle) -> bool:
    if known.measurement is None:
        return False
    values, seen = known.measurement.values, motion.crossings
    shorter = min(seen.rear_line_1 - seen.front_line_1, values.rear_line_1 - values.front_line_1)
    if {motion.reason, values.reason} & {STOPPED, STOOD}:
        return abs(seen.front_line_1 - values.front_line_1) <= SAME_SHARE * shorter
    shared = min(seen.rear_line_1, values.rear_line_1) - max(seen.front_line_1, values.front_line_1)
    return shared >= SAME_SHARE * shorter


def run_values(
    method: ScanMethod, rig: Rig, motions: Sequence[Motion], count: int, notes: Sequence[Said]
) -> ScanRunValues:
    """What a run of the finder says that measured these motions."""
    return ScanRunValues(
        method=method,
        rig=rig_columns(rig),
        found=count,
        measured=sum(one.status == "ok" for one in motions),
        summary=summary_of(motions),
        warnings=list(notes),
        code_version=code_version(),
    )


def summary_of(motions: Sequence[Motion]) -> RunSummary:
    """What the traffic says of the cameras."""
    shift, light = misalignment(motions), gain(motions)
    return RunSummary(
        misalignment_px=shift.value,
        u_misalignment_px=shift.u,
        misalignment_words=shift.warning or shift.reason,
        vehicles=shift.n,
        gain=light.value,
        u_gain=light.u,
    )


def _summarise_run(found: int, added: int, revised: int, overtaken: int) -> list[Said]:
    said = [Said("scan-vehicles-found", found=found, added=added, revised=revised)]
    return [*said, Said("scan-vehicles-left", count=overtaken)] if overtaken else said
