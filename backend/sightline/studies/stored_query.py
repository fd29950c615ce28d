"""What a study reads of this installation's own surveys: the rows that their packages would carry.

Lengths are those of a package, to the micrometre, so that a study gives the same here and from packages.
"""

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import get_args

import numpy as np
from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.arrays import Ints
from sightline.enums import AcceptedVerdict, StatisticsTarget
from sightline.poses.tables import road_poses
from sightline.results.measured_columns_query import TARGETS, VERDICTS, Heights, load_measured_columns

_COUNTED = tuple(VERDICTS.index(word) for word in get_args(AcceptedVerdict))


class StoredTables:
    """The accepted heights of some surveys, (N,), from one state of the database."""

    def __init__(self, session: Session, survey_ids: Sequence[int]) -> None:
        measured = load_measured_columns(session, survey_ids)
        rows = measured.where(np.isin(measured.verdict, _COUNTED) & ~measured.check_target)
        place = np.full(max(survey_ids) + 1, -1, dtype=np.int64)
        place[list(survey_ids)] = np.arange(len(survey_ids))
        self._rows = replace(rows, survey_id=place[rows.survey_id])
        self._surveys = len(survey_ids)
        order = np.lexsort((self._rows.measurement_id, self._rows.survey_id))
        self._order = order[self._rows.counts[order]]

    def counted(self) -> tuple[Ints, Ints]:
        """Of each survey, (P,) each: how many count, and how many do not, for they are out of its sample."""
        whole = np.bincount(self._rows.survey_id, minlength=self._surveys)
        own = np.bincount(self._rows.survey_id[self._rows.counts], minlength=self._surveys)
        return own, whole - own

    def vehicles(self) -> tuple[Ints, Ints, Ints]:
        """(survey, category, lighting), (V,) each, of every vehicle with a counted height."""
        rows = self._rows.where(self._order)
        _, first = np.unique(rows.vehicle_id, return_index=True)
        first = first[np.lexsort((rows.vehicle_id[first], rows.survey_id[first]))]
        return rows.survey_id[first], rows.category[first], rows.lighting[first]

    def heights(self, target: StatisticsTarget) -> Heights:
        """The counted heights of one target, by survey and number."""
        chosen = self._order[self._rows.target[self._order] == TARGETS.index(target)]
        return Heights(**{one.name: getattr(self._rows, one.name)[chosen] for one in fields(Heights)})


def surveys_with_poses(session: Session, survey_ids: Sequence[int]) -> set[int]:
    """Those that have a road pose."""
    query = select(road_poses.c.survey_id).where(road_poses.c.survey_id.in_(survey_ids)).distinct()
    return set(session.execute(query).scalars())
