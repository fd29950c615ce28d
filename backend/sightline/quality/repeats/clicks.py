"""What was clicked again, as clicks that can be compared: whose, on what, the height of that one frame."""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from itertools import groupby
from math import sqrt

from sightline.enums import Point, Target
from sightline.infra.audit.records import Who
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import answer
from sightline.measurements.records import BudgetPart, Clicks, Measurement, revision_of_clicks
from sightline.measurements.road_poses import road_pose
from sightline.quality.repeats.query import repeats_of_survey

CLICK_SOURCES = ("click, target", "click, contact")


@dataclass(frozen=True)
class Click:
    """One pair of clicks that was repeated or repeats another; heights None where there is none.

    u_clicks_m: the part of the budget that comes from the clicks, u_pixel_m: what it would be of clicks of
    1 px; the other parts are the same for all clicks on a frame. `first_contact`: of the measurement that was
    repeated; targets of a vehicle may share it.
    """

    measurement_id: int
    first_id: int
    first_contact: Point
    vehicle_id: int
    target: Target
    frame: int
    pose_id: int
    inset_m: float | None
    person: Who
    contact: Point
    target_point: Point
    height_m: float | None
    u_clicks_m: float | None
    u_pixel_m: float | None

    @property
    def _inset_m(self) -> float:
        """To be sorted by; an eye of unknown side has none."""
        return -1.0 if self.inset_m is None else self.inset_m

    @property
    def item(self) -> tuple[int, int, int, float]:
        """Heights with the same item differ by their clicks alone."""
        return self.first_id, self.frame, self.pose_id, self._inset_m

    @property
    def framed(self) -> tuple[int, int, float]:
        """Heights with the same of these, but other frames, differ by the frame too."""
        return self.first_id, self.pose_id, self._inset_m


def clicks_of_survey(session: Session, survey_id: int) -> tuple[Click, ...]:
    """The standing repeats of a survey with what they repeat before them; by repeated measurement."""
    series = [list(found) for _, found in groupby(repeats_of_survey(session, survey_id), lambda one: one.id)]
    by_first: dict[int, list[list[Measurement]]] = {}
    for revisions in series:
        current = revisions[-1]
        if current.repeat_of is not None and not current.withdrawn:
            by_first.setdefault(current.repeat_of, []).append(revisions)
    firsts = {revisions[-1].id: revisions for revisions in series if revisions[-1].repeat_of is None}
    out: list[Click] = []
    for first_id, again in by_first.items():
        if first_id in firsts:
            first = _standing_before(firsts[first_id], again[0])
            found = [(first, firsts[first_id]), *((revisions[-1], revisions) for revisions in again)]
            for one, revisions in found:
                if (who := revision_of_clicks(revisions, one).created_by) is not None:
                    out.append(_click(session, one, first, who))
    return tuple(out)


def height_of_first_frame(session: Session, measurement: Measurement) -> tuple[float | None, float | None]:
    """(height, its part from the clicks) in metres of the first frame's clicks alone; None without a height.

    Of a measurement on several frames or a whole pass too: a repeat is on one, and only like can be compared
    with like.
    """
    if not measurement.values.more_frames and measurement.values.followed is None:
        return measurement.values.height_m, _u_clicks(measurement.values.height_m, measurement.values.budget)
    values = measurement.values
    # of this frame alone
    clicks = filled_from(Clicks, values, frame=0, more_frames=(), followed=None)
    found = answer(road_pose(session, measurement.values.pose_id), clicks)
    return found.height_m, _u_clicks(found.height_m, found.budget)


def _u_clicks(height_m: float | None, budget: Iterable[BudgetPart]) -> float | None:
    parts = [entry["u_m"] for entry in budget if entry["source"] in CLICK_SOURCES]
    return sqrt(sum(u * u for u in parts)) if parts and height_m is not None else None


def _standing_before(revisions: list[Measurement], again: list[Measurement]) -> Measurement:
    """The points that stood when they were first repeated, computed again as often as the repeat was."""

    def standing(at: datetime) -> list[Measurement]:
        return [one for one in revisions if one.created_at <= at and not one.withdrawn]

    first = (standing(again[0].created_at) or revisions)[-1]
    alike = [
        one for one in standing(again[-1].created_at) if one.values.first_clicks == first.values.first_clicks
    ]
    return alike[-1] if alike else first


def _click(session: Session, measurement: Measurement, first: Measurement, person: Who) -> Click:
    height_m, u_clicks_m = height_of_first_frame(session, measurement)
    return filled_from(
        Click,
        measurement,
        measurement.values,
        measurement_id=measurement.id,
        first_id=first.id,
        first_contact=first.values.contact,
        person=person,
        height_m=height_m,
        u_clicks_m=u_clicks_m,
        u_pixel_m=None if u_clicks_m is None else u_clicks_m / measurement.values.sigma_px,
    )
