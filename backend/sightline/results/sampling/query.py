"""What became of the passes of a survey: read in one query, judged by what the survey asks for and takes."""

from typing import Any

from sqlalchemy import ColumnElement, Select, and_, case, func, select
from sqlalchemy.orm import Session

from sightline.measurements.query import is_current, is_first, judges, verdict
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.recordings.tables import recordings
from sightline.statistics.sampling import PassAnswers, is_in_sample
from sightline.surveys.records import Survey
from sightline.vehicles.records import NOT_VISIBLE
from sightline.vehicles.store import LIGHT, headways_of
from sightline.vehicles.tables import vehicles


def with_answers(*own: ColumnElement[Any]) -> Select[Any]:
    """Living vehicles with `id`, `light`, `own`, why each target cannot be seen, and 1 by each target that is
    measured, else 0; a rejected height measures nothing, nor do clicks that give none.
    """
    v, m = vehicles.c, measurements.c
    each = (v.id, LIGHT, *own, *(v[name] for name in NOT_VISIBLE.values()))
    stands = (verdict != "rejected") & (m.status == "ok")
    has = [
        func.max(case(((m.target == target) & stands, 1), else_=0)).label(target) for target in NOT_VISIBLE
    ]
    return (
        select(*each, *has)
        .join(recordings, recordings.c.id == v.recording_id)
        .outerjoin(measurement_series, and_(measurement_series.c.vehicle_id == v.id, is_first))
        .outerjoin(measurements, and_(m.series_id == measurement_series.c.id, is_current, ~m.withdrawn))
        .outerjoin(reviews, judges)
        .where(v.deleted_at.is_(None))
        .group_by(*each)
    )


def pass_answers(session: Session, survey: Survey) -> list[PassAnswers]:
    """Every pass of a survey that was not deleted, but those of check targets."""
    v = vehicles.c
    query = with_answers(v.number, v.recording_id, v.category, v.discarded)
    query = query.where(v.survey_id == survey.id, ~v.check_target).order_by(v.number)
    rows = session.execute(query).mappings().all()
    rule = survey.sampling
    free = rule.free_flowing_s is not None
    headway_s = headways_of(session, {row["recording_id"] for row in rows}) if free else {}
    sets = {one.category: one.class_set for one in survey.classes}
    return [
        PassAnswers(
            lighting=row["light"],
            class_set=sets.get(row["category"]),
            in_sample=is_in_sample(rule, row["number"], headway_s.get(row["id"])),
            discarded=row["discarded"] is not None,
            asked=survey.asked.of(row["light"]),
            measured=frozenset(target for target in NOT_VISIBLE if row[target]),
            not_visible=frozenset(target for target, name in NOT_VISIBLE.items() if row[name] is not None),
        )
        for row in rows
    ]
