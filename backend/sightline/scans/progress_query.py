"""How far the work on the line scans of surveys is, in three queries however many surveys there are."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from functools import cache
from typing import Any

from sqlalchemy import BindParameter, Select, bindparam, func, select
from sqlalchemy.orm import Session

from sightline.messages.said import Said
from sightline.scans.heights.store import scan_height_states
from sightline.scans.query import scan_vehicle_states
from sightline.scans.records import ScanProgress, state_of
from sightline.scans.tables import scan_vehicles, scans

#: The surveys that a query built once is asked for.
SURVEY_IDS: BindParameter[int] = bindparam("survey_ids", expanding=True)


def scan_progress_of(session: Session, survey_ids: Sequence[int]) -> dict[int, ScanProgress]:
    """The line scans of each of those surveys."""
    by_survey: defaultdict[int, Counter[str]] = defaultdict(Counter)
    asked, (there, motions, heights) = {SURVEY_IDS.key: survey_ids}, _queries()
    for survey_id, state, count in session.execute(there, asked):
        by_survey[survey_id].update({"scans": count, state: count})
    for survey_id, status, verdict, count in session.execute(motions, asked):
        by_survey[survey_id].update({"vehicles": count, state_of(status, verdict): count})
    if by_survey:
        for survey_id, verdict, count in session.execute(heights, asked):
            by_survey[survey_id].update({"heights": count, f"heights_{state_of('ok', verdict)}": count})
    return {survey_id: _progress(by_survey[survey_id]) for survey_id in survey_ids}


@cache
def _queries() -> tuple[Select[Any], Select[Any], Select[Any]]:
    """Built once: scans by their state, their vehicles by motion and verdict, their heights by verdict."""
    here = scan_vehicles.c.survey_id.in_(SURVEY_IDS)
    there = (
        select(scans.c.survey_id, scans.c.state, func.count())
        .where(scans.c.survey_id.in_(SURVEY_IDS), scans.c.deleted_at.is_(None))
        .group_by(scans.c.survey_id, scans.c.state)
    )
    motions = _count_states(scan_vehicle_states(here), "status", "verdict")
    return there, motions, _count_states(scan_height_states(here), "verdict")


_COUNTED = tuple(name for name in ScanProgress.__slots__ if name not in ("state", "summary"))


def _count_states(states: Select[Any], *by: str) -> Select[Any]:
    """(survey, what they are told apart by, how many) of what stands in scans."""
    each = states.subquery()
    apart = (scans.c.survey_id, *(each.c[name] for name in by))
    return (
        select(*apart, func.count())
        .join(scans, scans.c.id == each.c.scan_id)
        .where(scans.c.deleted_at.is_(None))
        .group_by(*apart)
    )


def _progress(counts: Counter[str]) -> ScanProgress:
    if not counts:
        return ScanProgress("none", [Said("overview-no-scans")])
    of = {name: counts[name] for name in _COUNTED}
    open_work = _open(of, counts["failed"], counts["reading"])
    if open_work:
        return ScanProgress("open", open_work, **of)
    words = [Said("overview-scans-accepted", count=of["accepted"], all=of["vehicles"])]
    if of["not_measurable"]:
        words.append(Said("overview-scans-not-measurable", count=of["not_measurable"]))
    if of["heights"]:
        words.append(Said("overview-line-heights-accepted", count=of["heights_accepted"], all=of["heights"]))
    return ScanProgress("done", words, **of)


def _open(of: dict[str, int], failed: int, reading: int) -> list[Said]:
    """What is to be done, what stops the rest first."""
    words = []
    if failed:
        words.append(Said("overview-scans-not-imported", count=failed))
    if reading:
        words.append(Said("overview-scans-importing", count=reading))
    if of["ready"] and not of["vehicles"]:
        words.append(Said("overview-scans-find", count=of["ready"]))
    if of["to_review"]:
        words.append(Said("overview-scans-review", open=of["to_review"], count=of["vehicles"]))
    if of["heights_to_review"]:
        words.append(Said("overview-scans-review-heights", open=of["heights_to_review"], count=of["heights"]))
    return words
