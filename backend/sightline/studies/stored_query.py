"""What a study reads of this installation's own surveys: the rows that their packages would carry.

Lengths are those of a package, to the micrometre, so that a study gives the same here and from packages.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.enums import StatisticsTarget
from sightline.poses.tables import road_poses
from sightline.results.measured_columns_query import TARGETS, VERDICTS, Measured, load_measured_columns
from sightline.statistics.sampling import is_in_sample
from sightline.studies.records import Ints, StudiedHeights
from sightline.surveys.store import get_survey
from sightline.vehicles.store import headways_of
from sightline.vehicles.tables import vehicles

_COUNTED = tuple(VERDICTS.index(word) for word in ("accepted", "fixed"))
_LENGTHS = ("height_m", "u_height_m", "u_clicks_m", "u_by_inset_m", "inset_m", "u_inset_m")


class StoredTables:
    """The accepted heights of some surveys, (N,), from one state of the database."""

    def __init__(self, session: Session, survey_ids: Sequence[int]) -> None:
        measured = load_measured_columns(session, survey_ids)
        self._rows = measured.where(np.isin(measured.verdict, _COUNTED))
        place = np.full(max(survey_ids) + 1, -1, dtype=np.int64)
        place[list(survey_ids)] = np.arange(len(survey_ids))
        self._survey = place[self._rows.survey_id]
        self._surveys = len(survey_ids)
        taken = _vehicles_in_samples(session, survey_ids)
        self._taken = taken[np.minimum(self._rows.vehicle_id, len(taken) - 1)]
        order = np.lexsort((self._rows.measurement_id, self._survey))
        self._order = order[self._taken[order]]

    def counted(self) -> tuple[Ints, Ints]:
        """Of each survey, (P,) each: how many count, and how many do not, for they are out of its sample."""
        whole = np.bincount(self._survey, minlength=self._surveys)
        own = np.bincount(self._survey[self._taken], minlength=self._surveys)
        return own, whole - own

    def vehicles(self) -> tuple[Ints, Ints, Ints]:
        """(survey, category, lighting), (V,) each, of every vehicle with a counted height."""
        rows, survey = self._rows.where(self._order), self._survey[self._order]
        _, first = np.unique(rows.vehicle_id, return_index=True)
        first = first[np.lexsort((rows.vehicle_id[first], survey[first]))]
        return survey[first], rows.category[first], rows.lighting[first]

    def heights(self, target: StatisticsTarget) -> StudiedHeights:
        """The counted heights of one target, by survey and number."""
        chosen = self._order[self._rows.target[self._order] == TARGETS.index(target)]
        rows: Measured = self._rows.where(chosen)
        return StudiedHeights(
            package=self._survey[chosen],
            pose=rows.pose_id,
            category=rows.category,
            lighting=rows.lighting,
            class_set=rows.class_set,
            reference_m=rows.known_m,
            **{name: getattr(rows, name) for name in _LENGTHS},
        )


def surveys_with_poses(session: Session, survey_ids: Sequence[int]) -> set[int]:
    """Those that have a road pose."""
    query = select(road_poses.c.survey_id).where(road_poses.c.survey_id.in_(survey_ids)).distinct()
    return set(session.execute(query).scalars())


def _vehicles_in_samples(session: Session, survey_ids: Sequence[int]) -> NDArray[np.bool_]:
    """By vehicle's number, whether it counts: in the sample of its survey, and a pass to be measured."""
    v = vehicles.c
    last = session.execute(select(func.max(v.id))).scalar_one() or 0
    taken = np.zeros(last + 2, dtype=np.bool_)  # the last place is nobody's
    for survey_id in survey_ids:
        rule = get_survey(session, survey_id).sampling
        query = select(v.id, v.number, v.recording_id).where(
            v.survey_id == survey_id, v.deleted_at.is_(None), v.discarded.is_(None), ~v.check_target
        )
        rows = session.execute(query).all()
        headway_s = headways_of(session, {one.recording_id for one in rows}) if rule.free_flowing_s else {}
        taken[[one.id for one in rows if is_in_sample(rule, one.number, headway_s.get(one.id))]] = True
    return taken
