"""What a click on a recording needs to become a height, in one query: pose, insets, sigma and the frames."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from sqlalchemy import ScalarSelect, Select, and_, bindparam, exists, select
from sqlalchemy.orm import Session

from sightline.enums import Category
from sightline.geometry.sides import FoundSide, TrafficFacts, driver_side
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import missing
from sightline.measurements.tables import click_sigmas
from sightline.poses.tables import road_poses
from sightline.recordings.frames.records import Frame
from sightline.recordings.frames.store import missing_frame
from sightline.recordings.frames.tables import frames
from sightline.recordings.tables import recordings
from sightline.surveys.records import Inset, insets_of
from sightline.surveys.store import TRAFFIC, traffic_of_row
from sightline.surveys.tables import surveys
from sightline.vehicles.proposing.tables import proposals
from sightline.vehicles.records import NOT_VISIBLE
from sightline.vehicles.tables import vehicles

_SOME = 500


@dataclass(frozen=True, slots=True, kw_only=True)
class ClickContext:
    """`pose_id` and `calibration_id` are None while the recording has no road pose.

    `side`: where the driver of the vehicle sits, or of any in the lane beside the camera where no vehicle is
    named; None where nobody knows. `not_visible`: its targets that were said not to be visible.
    `proposed`: whether anything was ever proposed of the vehicle, in force or not.
    `own_sigma_px`: what was chosen for this person's clicks from their repeats; None: the usual one.
    """

    recording_id: int
    survey_id: int
    name: str
    pose_id: int | None
    calibration_id: int | None
    size_px: tuple[int | None, int | None]
    insets: Mapping[str, Inset]
    side: FoundSide | None
    not_visible: frozenset[str]
    discarded: bool
    category: Category | None
    own_sigma_px: float | None = None
    proposed: bool = False
    frames: Mapping[int, Frame] = field(default_factory=dict)

    def frame(self, n: int) -> Frame:
        """One of the frames asked for. Raises NotFound where the recording has no such frame."""
        if n not in self.frames:
            raise missing_frame(self.recording_id, n)
        return self.frames[n]


def click_context(
    session: Session, recording_id: int, person_id: int | None = None, *, vehicle_id: int | None = None
) -> ClickContext:
    """The context of a person's clicks in a recording, on a vehicle of it; without frames.

    Raises NotFound (also when the recording was deleted).
    """
    asked = {"of_recording": recording_id, "of_person": person_id, "of_vehicle": vehicle_id}
    return _context(session, _on_recording(), {**asked, "clicked": ()}, "recording", recording_id)


def click_context_of_vehicle(
    session: Session, vehicle_id: int, person_id: int, frame_numbers: Sequence[int]
) -> ClickContext:
    """`click_context` of a vehicle's recording. Raises NotFound (also when the vehicle was deleted)."""
    asked = {"of_person": person_id, "of_vehicle": vehicle_id, "clicked": frame_numbers}
    return _context(session, _on_vehicle(), asked, "vehicle", vehicle_id)


# Made once: making a statement anew takes longer than the database does to answer it.
@cache
def _on_recording() -> Select[Any]:
    return _query().where(recordings.c.id == bindparam("of_recording"))


@cache
def _on_vehicle() -> Select[Any]:
    its_recording = select(vehicles.c.recording_id).where(
        vehicles.c.id == bindparam("of_vehicle"), vehicles.c.deleted_at.is_(None)
    )
    return _query().where(recordings.c.id == its_recording.scalar_subquery())


def _query() -> Select[Any]:
    on_vehicle = and_(vehicles.c.id == bindparam("of_vehicle"), vehicles.c.recording_id == recordings.c.id)
    clicked_on = and_(
        frames.c.recording_id == recordings.c.id, frames.c.n.in_(bindparam("clicked", expanding=True))
    )
    return (
        select(
            recordings.c.id.label("recording_id"),
            recordings.c.survey_id,
            recordings.c.name,
            recordings.c.pose_id,
            road_poses.c.calibration_id,
            recordings.c.width_px,
            recordings.c.height_px,
            *(surveys.c.insets, *(surveys.c[name] for name in TRAFFIC)),
            *(vehicles.c.direction, vehicles.c.driver_side, vehicles.c.discarded, vehicles.c.category),
            *(vehicles.c[name] for name in NOT_VISIBLE.values()),
            _own_sigma().label("own_sigma_px"),
            exists().where(proposals.c.vehicle_id == vehicles.c.id).label("proposed"),
            *(frames.c.n, frames.c.pts, frames.c.time_s, frames.c.key, frames.c.crc32),
        )
        .join(surveys, surveys.c.id == recordings.c.survey_id)
        .outerjoin(road_poses, road_poses.c.id == recordings.c.pose_id)
        .outerjoin(vehicles, on_vehicle)
        .outerjoin(frames, clicked_on)
        .where(recordings.c.deleted_at.is_(None))
    )


def _context(
    session: Session, query: Select[Any], asked: Mapping[str, Any], word: str, row_id: int
) -> ClickContext:
    rows = session.execute(query, asked).all()
    if not rows:
        raise missing(word, row_id)
    row = rows[0]
    return context_of_row(
        row,
        insets_of(row.insets),
        traffic_of_row(row._mapping),
        own_sigma_px=row.own_sigma_px,
        proposed=bool(row.proposed),
        frames={of.n: record_of(Frame, of._mapping) for of in rows if of.n is not None},
    )


def context_of_row(row: Any, insets: Mapping[str, Inset], traffic: TrafficFacts, **more: Any) -> ClickContext:
    """The context of clicks on the vehicle of a row, with what the survey says and what is known besides."""
    return ClickContext(
        recording_id=row.recording_id,
        survey_id=row.survey_id,
        name=row.name,
        pose_id=row.pose_id,
        calibration_id=row.calibration_id,
        size_px=(row.width_px, row.height_px),
        insets=insets,
        not_visible=frozenset(
            target for target, name in NOT_VISIBLE.items() if row._mapping[name] is not None
        ),
        discarded=row.discarded is not None,
        side=driver_side(row.driver_side, row.direction, traffic),
        category=row.category,
        **more,
    )


def frames_by_number(session: Session, recording_id: int, numbers: Sequence[int]) -> dict[int, Frame]:
    """Some of a recording's frames; those that it does not have are left out."""
    by_number: dict[int, Frame] = {}
    for at in range(0, len(numbers), _SOME):
        query = select(*(frames.c[name] for name in ("n", "pts", "time_s", "key", "crc32"))).where(
            frames.c.recording_id == recording_id, frames.c.n.in_(numbers[at : at + _SOME])
        )
        by_number |= {row.n: Frame(**row._mapping) for row in session.execute(query)}
    return by_number


def _own_sigma() -> ScalarSelect[float | None]:
    """The newest choice for `of_person` in the recording's survey (see `click_sigmas`)."""
    newest = (
        select(click_sigmas.c.sigma_px)
        .where(
            click_sigmas.c.survey_id == recordings.c.survey_id,
            click_sigmas.c.person_id == bindparam("of_person"),
        )
        .order_by(click_sigmas.c.id.desc())
        .limit(1)
    )
    return newest.correlate(recordings).scalar_subquery()
