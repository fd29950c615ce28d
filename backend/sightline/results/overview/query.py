"""Counts and steps of surveys, computed in a fixed number of queries however many surveys there are."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, get_args

from sqlalchemy import ColumnElement, Select, and_, case, func, select
from sqlalchemy.orm import Session

from sightline.cameras.tables import cameras
from sightline.enums import AcceptedVerdict, StepKey
from sightline.infra.web.person import Seen
from sightline.measurements.query import is_current, is_first, verdict, waits, with_verdict
from sightline.measurements.tables import measurement_series, measurements
from sightline.messages.said import Said
from sightline.recordings.tables import recordings
from sightline.results.overview.package_query import changes_since_packages
from sightline.results.overview.records import ChangesSince, Step, SurveyCounts, SurveyOverview
from sightline.results.sampling.query import pass_answers, with_answers
from sightline.results.tables import exports
from sightline.scans.progress_query import SURVEY_IDS, scan_progress_of
from sightline.scans.records import ScanProgress
from sightline.surveys import store as surveys
from sightline.surveys.records import Survey
from sightline.vehicles.records import NOT_VISIBLE
from sightline.vehicles.tables import vehicles


@dataclass(frozen=True, slots=True)
class _Facts:
    calibrated_cameras: int
    cameras: int
    ready: int
    failed: int
    confirmed: int
    posed: int
    exports: int


_ALIVE: ColumnElement[bool] = vehicles.c.deleted_at.is_(None)
_STANDING = [is_current, is_first, ~measurements.c.withdrawn, _ALIVE]


def survey_overview(session: Session, survey_id: int) -> SurveyOverview:
    """One survey with its counts and steps. Raises NotFound."""
    return _overviews(session, [surveys.get_survey(session, survey_id)])[0]


def survey_overviews(session: Session, seen: Seen = None) -> tuple[SurveyOverview, ...]:
    """Every survey that a person sees, newest first; a fixed number of queries however many there are."""
    return _overviews(session, surveys.list_surveys(session, seen))


def _overviews(session: Session, of: Sequence[Survey]) -> tuple[SurveyOverview, ...]:
    if not of:
        return ()
    survey_ids = [survey.id for survey in of]
    tables = [_by_survey(session, query, survey_ids) for query in _fact_queries()]
    newest = [facts["newest_export"] for facts in tables[-1].values()]
    since = changes_since_packages(session, newest)
    tables.append(_answered_vehicles(session, of))
    scanned = scan_progress_of(session, survey_ids)
    overviews = []
    for survey in of:
        facts: dict[str, int] = {}
        for table in tables:
            facts.update(table.get(survey.id, {}))
        since_newest = since.get(facts.get("newest_export", 0))
        overviews.append(_overview(survey, facts, scanned[survey.id], since_newest))
    return tuple(overviews)


def _overview(
    survey: Survey, facts: dict[str, int], scans: ScanProgress, since: ChangesSince | None
) -> SurveyOverview:
    counts = SurveyCounts(**{name: facts.get(name, 0) for name in SurveyCounts.__slots__})
    rest = _Facts(**{name: facts.get(name, 0) for name in _Facts.__slots__})
    # with line scans alone nobody need calibrate a camera: no step is the next one
    only_scans = scans.scans > 0 and rest.cameras == 0 and counts.recordings == 0
    steps = _steps(counts, rest, only_scans, scans, since)
    return SurveyOverview(survey, _with_lines(counts, scans), steps, scans, since)


def _with_lines(of_frames: SurveyCounts, scans: ScanProgress) -> SurveyCounts:
    """Verdicts on heights of frames and of line scans together, as Review counts them."""
    return replace(
        of_frames,
        to_review=of_frames.to_review + scans.heights_to_review,
        accepted=of_frames.accepted + scans.heights_accepted,
        rejected=of_frames.rejected + scans.heights_rejected,
    )


def _sum(condition: ColumnElement[bool]) -> ColumnElement[Any]:
    return func.coalesce(func.sum(case((condition, 1), else_=0)), 0)


@cache
def _fact_queries() -> tuple[Select[Any], ...]:
    """Built once: building them takes longer than asking."""
    return _camera_facts(), _recording_facts(), _measurement_facts(), _package_facts()


def _grouped(survey_id: Any, where: Iterable[ColumnElement[bool]], **named: Any) -> Select[Any]:
    columns = [value.label(name) for name, value in named.items()]
    query = select(survey_id.label("survey_id"), *columns).where(survey_id.in_(SURVEY_IDS), *where)
    return query.group_by(survey_id)


def _camera_facts() -> Select[Any]:
    calibrated = _sum(cameras.c.current_calibration_id.is_not(None))
    return _grouped(cameras.c.survey_id, [], cameras=func.count(), calibrated_cameras=calibrated)


def _recording_facts() -> Select[Any]:
    ready = recordings.c.state == "ready"
    return _grouped(
        recordings.c.survey_id,
        [recordings.c.deleted_at.is_(None)],
        recordings=func.count(),
        ready=_sum(ready),
        failed=_sum(recordings.c.state == "failed"),
        confirmed=_sum(and_(ready, recordings.c.lighting.is_not(None), recordings.c.started_at.is_not(None))),
        posed=_sum(and_(ready, recordings.c.pose_id.is_not(None))),
    )


def _package_facts() -> Select[Any]:
    newest = func.max(exports.c.id)
    return _grouped(exports.c.survey_id, [], exports=func.count(), newest_export=newest)


def _measurement_facts() -> Select[Any]:
    survey_id = measurement_series.c.survey_id
    return (
        with_verdict(
            survey_id,
            func.count().label("measurements"),
            _sum(waits).label("to_review"),
            _sum(verdict.in_(get_args(AcceptedVerdict))).label("accepted"),
            _sum(verdict == "rejected").label("rejected"),
        )
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(survey_id.in_(SURVEY_IDS), *_STANDING)
        .group_by(survey_id)
    )


def _answered_vehicles(session: Session, of: Sequence[Survey]) -> dict[int, dict[str, int]]:
    """By survey: vehicles of its sample and its check targets, those of which all that is asked for is
    answered, and targets said not to be visible.

    Vehicles are counted by what they have, a few dozen ways, and judged by what their survey asks for; where
    a survey takes a sample, each pass is looked at.
    """
    by_id = {survey.id: survey for survey in of}
    by_survey: dict[int, dict[str, int]] = {
        survey.id: {"vehicles": 0, "vehicles_measured": 0, "not_visible": 0} for survey in of
    }
    for row in session.execute(_answers_query(), {SURVEY_IDS.key: list(by_id)}).mappings():
        survey, counts = by_id[row["survey_id"]], by_survey[row["survey_id"]]
        hidden = {target for target, name in NOT_VISIBLE.items() if row[name] is not None}
        counts["not_visible"] += row["count"] * len(hidden)
        if not (row["check_target"] or survey.sampling.takes_all):
            continue
        counts["vehicles"] += row["count"]
        if hidden | {target for target in NOT_VISIBLE if row[target]} >= set(survey.asked.of(row["light"])):
            counts["vehicles_measured"] += row["count"]
    for survey in of:
        if not survey.sampling.takes_all:
            ends = [one.end for one in pass_answers(session, survey)]
            answered = ends.count("measured") + ends.count("not_visible")
            by_survey[survey.id]["vehicles"] += answered + ends.count("open")
            by_survey[survey.id]["vehicles_measured"] += answered
    return by_survey


@cache
def _answers_query() -> Select[Any]:
    """How many vehicles have what, by survey."""
    of_survey = vehicles.c.survey_id
    wanted = (of_survey.in_(SURVEY_IDS), vehicles.c.discarded.is_(None))
    each = with_answers(of_survey, vehicles.c.check_target).where(*wanted).subquery()
    ways = [column for column in each.c if column.name != "id"]
    return select(*ways, func.count().label("count")).group_by(*ways)


def _by_survey(session: Session, query: Select[Any], survey_ids: Sequence[int]) -> dict[int, dict[str, int]]:
    return {
        row["survey_id"]: {str(key): int(value) for key, value in row.items() if key != "survey_id"}
        for row in session.execute(query, {SURVEY_IDS.key: survey_ids}).mappings()
    }


def _steps(
    counts: SurveyCounts, facts: _Facts, only_scans: bool, scans: ScanProgress, since: ChangesSince | None
) -> tuple[Step, ...]:
    """The order of the work: what is done, the one that is next, those begun and those that wait for it.

    `counts` are of frames. `since`: what the newest package lacks; one that lacks anything is outdated, and
    its step not done.
    """
    outdated = since is not None and since.makes_outdated
    steps: list[tuple[StepKey, bool, bool, list[Said]]] = [
        ("camera", facts.calibrated_cameras > 0, facts.cameras > 0, _camera_words(facts)),
        (
            "recordings",
            0 < facts.ready == facts.confirmed,
            counts.recordings > 0,
            _recording_words(counts, facts),
        ),
        ("pose", 0 < facts.ready == facts.posed, facts.posed > 0, _pose_words(facts)),
        (
            "vehicles",
            0 < counts.vehicles == counts.vehicles_measured,
            counts.vehicles > 0,
            _vehicle_words(counts),
        ),
        (
            "review",
            counts.measurements > 0
            and counts.to_review + counts.rejected + scans.heights_to_review + scans.heights_rejected == 0,
            counts.measurements + scans.heights_to_review > 0,
            _review_words(counts, scans),
        ),
        ("results", facts.exports > 0 and not outdated, outdated, _result_words(facts)),
    ]
    following = None if only_scans else next((key for key, done, *_ in steps if not done), None)
    return tuple(
        Step(key, "done" if done else "next" if key == following else "begun" if begun else "waiting", words)
        for key, done, begun, words in steps
    )


def _camera_words(facts: _Facts) -> list[Said]:
    if facts.calibrated_cameras:
        return [Said("overview-calibrated", count=facts.calibrated_cameras)]
    return [Said("overview-calibrate") if facts.cameras else Said("overview-add-camera")]


def _recording_words(counts: SurveyCounts, facts: _Facts) -> list[Said]:
    if facts.ready:
        said = [Said("overview-ready", count=facts.ready, all=counts.recordings)]
        left = facts.ready - facts.confirmed
        return [*said, Said("overview-confirm", count=left)] if left else said
    if facts.failed:
        return [Said("overview-not-imported")]
    return [Said("overview-importing") if counts.recordings else Said("overview-drop-video")]


def _pose_words(facts: _Facts) -> list[Said]:
    if facts.ready and facts.ready == facts.posed:
        return [Said("overview-posed")]
    left = facts.ready - facts.posed
    return [Said("overview-mark-board", count=left) if facts.ready else Said("overview-mark-board-later")]


def _vehicle_words(counts: SurveyCounts) -> list[Said]:
    if counts.vehicles == 0:
        return [Said("overview-find-vehicles")]
    unseen = [Said("overview-not-visible", count=counts.not_visible)] if counts.not_visible else []
    if counts.vehicles == counts.vehicles_measured:
        return [Said("overview-measured", count=counts.vehicles), *unseen]
    left = counts.vehicles - counts.vehicles_measured
    return [Said("overview-measure", left=left, count=counts.vehicles), *unseen]


def _review_words(counts: SurveyCounts, scans: ScanProgress) -> list[Said]:
    """What is open and what is accepted, of frames and of line scans apart: results are of frames."""
    words = []
    if counts.to_review:
        words.append(Said("overview-review", count=counts.to_review))
    if scans.heights_to_review:
        words.append(Said("overview-review-line-heights", count=scans.heights_to_review))
    if counts.rejected:
        words.append(Said("overview-remeasure", count=counts.rejected))
    if scans.heights_rejected:
        words.append(Said("overview-remeasure-line-heights", count=scans.heights_rejected))
    if scans.heights_accepted:
        words.append(Said("overview-accepted", count=counts.accepted, scans=scans.heights_accepted))
    if words:
        return words
    if counts.measurements:
        return [Said("overview-reviewed", count=counts.accepted)]
    return [Said("overview-nothing-to-review")]


def _result_words(facts: _Facts) -> list[Said]:
    built = facts.exports
    return [Said("overview-packages", count=built) if built else Said("overview-build-package")]
