"""How far the work on the line scans of surveys is, in three queries however many surveys there are."""

from collections.abc import Iterable, Sequence
from typing import Any

from sqlalchemy import Select, func, select
from sqlalchemy.orm import Session

from sightline.scans.heights.store import scan_height_states
from sightline.scans.query import scan_vehicle_states
from sightline.scans.records import ScanProgress, state_of
from sightline.scans.tables import scan_vehicles, scans

NOTHING = "None here. Two line cameras at a known baseline give speed, length and gaps."


def scan_progress_of(session: Session, survey_ids: Sequence[int]) -> dict[int, ScanProgress]:
    """The line scans of those surveys that have any, by survey."""
    found: dict[int, dict[str, int]] = {}
    there = (
        select(scans.c.survey_id, scans.c.state, func.count())
        .where(scans.c.survey_id.in_(survey_ids), scans.c.deleted_at.is_(None))
        .group_by(scans.c.survey_id, scans.c.state)
    )
    for survey_id, state, count in session.execute(there):
        _add(found, survey_id, ("scans", state), count)
    each = scan_vehicle_states(scan_vehicles.c.survey_id.in_(survey_ids)).subquery()
    vehicles = (
        select(scans.c.survey_id, each.c.status, each.c.verdict, func.count())
        .join(scans, scans.c.id == each.c.scan_id)
        .where(scans.c.deleted_at.is_(None))
        .group_by(scans.c.survey_id, each.c.status, each.c.verdict)
    )
    for survey_id, status, verdict, count in session.execute(vehicles):
        _add(found, survey_id, ("vehicles", state_of(status, verdict)), count)
    if found:
        for survey_id, verdict, count in session.execute(_heights(survey_ids)):
            _add(found, survey_id, ("heights", f"heights_{state_of('ok', verdict)}"), count)
    return {survey_id: _progress(counts) for survey_id, counts in found.items()}


_COUNTED = tuple(name for name in ScanProgress.__slots__ if name not in ("state", "summary"))


def no_scans() -> ScanProgress:
    """Of a survey without line scans."""
    return ScanProgress("none", NOTHING)


def _heights(survey_ids: Sequence[int]) -> Select[Any]:
    """(survey, verdict, how many) of the standing heights."""
    each = scan_height_states(scan_vehicles.c.survey_id.in_(survey_ids)).subquery()
    return (
        select(scans.c.survey_id, each.c.verdict, func.count())
        .join(scans, scans.c.id == each.c.scan_id)
        .where(scans.c.deleted_at.is_(None))
        .group_by(scans.c.survey_id, each.c.verdict)
    )


def _add(found: dict[int, dict[str, int]], survey_id: int, names: Iterable[str], count: int) -> None:
    counts = found.setdefault(survey_id, {})
    for name in names:
        counts[name] = counts.get(name, 0) + count


def _progress(counts: dict[str, int]) -> ScanProgress:
    of = {name: counts.get(name, 0) for name in _COUNTED}
    open_work = _open(of, counts.get("failed", 0), counts.get("reading", 0))
    if open_work:
        return ScanProgress("open", " ".join(open_work), **of)
    said = f"{of['accepted']} of {_number(of['vehicles'], 'detected vehicle')} accepted."
    if of["not_measurable"]:
        said += f" {of['not_measurable']} cannot be measured; see their reasons."
    if of["heights"]:
        said += f" {of['heights_accepted']} of {_number(of['heights'], 'height')} accepted."
    return ScanProgress("done", said, **of)


def _open(of: dict[str, int], failed: int, reading: int) -> list[str]:
    """What is to be done, what stops the rest first."""
    said = []
    if failed:
        said.append(f"{_number(failed, 'line scan')} could not be imported; see the reason and try again.")
    if reading:
        said.append(f"{_number(reading, 'line scan')} still being imported.")
    if of["ready"] and not of["vehicles"]:
        said.append(f"Find the vehicles of {_number(of['ready'], 'line scan')}.")
    if of["to_review"]:
        said.append(f"Review {of['to_review']} of {_number(of['vehicles'], 'vehicle')}.")
    if of["heights_to_review"]:
        said.append(f"Review {of['heights_to_review']} of {_number(of['heights'], 'height')}.")
    return said


def _number(count: int, word: str) -> str:
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
