"""What a click on a recording needs to become a height, in one query: pose, insets, the person's sigma."""

from collections.abc import Mapping
from dataclasses import dataclass

from sqlalchemy import ScalarSelect, select
from sqlalchemy.orm import Session

from sightline.infra.database.rows import missing
from sightline.measurements.tables import click_sigmas
from sightline.poses.tables import road_poses
from sightline.recordings.tables import recordings
from sightline.surveys.records import Inset
from sightline.surveys.tables import surveys


@dataclass(frozen=True, slots=True)
class ClickContext:
    """`pose_id` and `calibration_id` are None while the recording has no road pose.

    `own_sigma_px`: what was chosen for this person's clicks from their repeats; None: the usual one.
    """

    recording_id: int
    survey_id: int
    name: str
    pose_id: int | None
    calibration_id: int | None
    size_px: tuple[int | None, int | None]
    insets: Mapping[str, Inset]
    own_sigma_px: float | None


def click_context(session: Session, recording_id: int, person_id: int | None = None) -> ClickContext:
    """The context of a person's clicks on a recording. Raises NotFound (also when it was deleted)."""
    query = (
        select(
            recordings.c.survey_id,
            recordings.c.name,
            recordings.c.pose_id,
            road_poses.c.calibration_id,
            recordings.c.width_px,
            recordings.c.height_px,
            surveys.c.insets,
            _own_sigma(person_id).label("own_sigma_px"),
        )
        .join(surveys, surveys.c.id == recordings.c.survey_id)
        .outerjoin(road_poses, road_poses.c.id == recordings.c.pose_id)
        .where(recordings.c.id == recording_id, recordings.c.deleted_at.is_(None))
    )
    row = session.execute(query).one_or_none()
    if row is None:
        raise missing("recording", recording_id)
    insets = {target: Inset(**values) for target, values in row.insets.items()}
    pose, size_px = (row.pose_id, row.calibration_id), (row.width_px, row.height_px)
    return ClickContext(recording_id, row.survey_id, row.name, *pose, size_px, insets, row.own_sigma_px)


def _own_sigma(person_id: int | None) -> ScalarSelect[float | None]:
    """The newest choice for the person in the recording's survey (see `click_sigmas`)."""
    newest = (
        select(click_sigmas.c.sigma_px)
        .where(click_sigmas.c.survey_id == recordings.c.survey_id, click_sigmas.c.person_id == person_id)
        .order_by(click_sigmas.c.id.desc())
        .limit(1)
    )
    return newest.correlate(recordings).scalar_subquery()
