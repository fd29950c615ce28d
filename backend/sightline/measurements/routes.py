"""Measurements: each click pair is stored at once; a correction is a new revision."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from typing import Annotated

from fastapi import APIRouter, Depends, Query
from fastapi.concurrency import run_in_threadpool

from sightline.enums import Target
from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.infra.database.engine import SurveyOf
from sightline.infra.services import Services
from sightline.infra.web.deps import Operator, PathId, Reading, SignedIn, Viewer, Wired, Writes
from sightline.infra.web.person import Person
from sightline.infra.web.quantities import AtRevision
from sightline.measurements import service, store
from sightline.measurements.assist.service import is_from
from sightline.measurements.bodies import (
    ChangedMeasurement,
    ClicksIn,
    FurtherClicks,
    MeasurementBody,
    NewMeasurement,
    OnFrameIn,
    measurement_body,
)
from sightline.measurements.following.service import followed_text
from sightline.measurements.records import ClickedFrame, Clicks, Measurement, Origin

router = APIRouter()
_Body = NewMeasurement | ChangedMeasurement


async def _find_origin(
    vehicle_id: PathId, body: NewMeasurement, who: SignedIn, services: Wired
) -> tuple[Origin, str | None]:
    """How the points came about, held against what Sightline finds, and what is followed from them: found
    before anything is written, not for what is stored already.

    Raises Conflict where the contact is not where Sightline takes the click.
    """
    if body.follow is None and body.snapped_from is None:
        return Origin(made=body.made), None
    return await run_in_threadpool(_find, vehicle_id, body, who, services)


def _find(
    vehicle_id: int, body: NewMeasurement, who: Person, services: Services
) -> tuple[Origin, str | None]:
    with services.reading() as session:
        if store.is_stored_key(session, str(body.client_key)):
            return Origin(made=body.made), None
    origin = _snapped(services, vehicle_id, body)
    followed = _follow(services, vehicle_id, body, body.target, who)
    return (origin if body.made == "clicked" else replace(origin, made=body.made)), followed


async def _found_of_change(
    measurement_id: PathId, body: ChangedMeasurement, who: SignedIn, services: Wired
) -> tuple[Origin, str | None]:
    """`_find_origin` of a revision; a contact that stays is what it was."""
    if body.follow is None and body.snapped_from is None:
        return Origin(), None
    return await run_in_threadpool(_find_of_change, measurement_id, body, who, services)


def _find_of_change(
    measurement_id: int, body: ChangedMeasurement, who: Person, services: Services
) -> tuple[Origin, str | None]:
    with services.reading() as session:
        before = store.get_measurement(session, measurement_id)
    same = (body.frame, body.contact) == (before.values.frame, before.values.contact)
    origin = Origin() if same else _snapped(services, before.vehicle_id, body)
    return origin, _follow(services, before.vehicle_id, body, body.target or before.values.target, who)


def _follow(services: Services, vehicle_id: int, body: _Body, target: Target, who: Person) -> str | None:
    if body.follow is None:
        return None
    clicks, second = clicks_of(body, target), body.follow.second_contact
    return followed_text(services, vehicle_id, clicks, second, actor=who.id)


def _snapped(services: Services, vehicle_id: int, body: _Body) -> Origin:
    click = body.snapped_from
    if click is None:
        return Origin()
    if not is_from(services, vehicle_id, body.frame, click, body.contact):
        raise Conflict("measurements-click-elsewhere")
    return Origin(made="snapped", snapped_from_x_px=click[0], snapped_from_y_px=click[1])


def clicks_of(body: OnFrameIn, target: Target) -> Clicks:
    """What the body says was clicked."""
    return Clicks(
        target=target,
        more_frames=clicked_frames(body.more_frames) if isinstance(body, ClicksIn) else (),
        **{name: getattr(body, name) for name in OnFrameIn.model_fields},
    )


def clicked_frames(more: Sequence[FurtherClicks]) -> tuple[ClickedFrame, ...]:
    """The further frames of a body."""
    return tuple(
        ClickedFrame(frame=one.frame, contact=one.contact, target_point=one.target_point) for one in more
    )


@router.post("/vehicles/{vehicle_id}/measurements", status_code=201)
async def add_measurement(
    vehicle_id: PathId,
    body: NewMeasurement,
    who: Operator,
    found: Annotated[tuple[Origin, str | None], Depends(_find_origin)],
    writes: Writes,
) -> MeasurementBody:
    """Store one height; sending the same `client_key` again gives back the one that is stored.

    A height that cannot be had is stored too, with its reason. Without a road pose this is a conflict. So is
    a target that stands measured: that conflict carries the measurement, as every other answer shows it.
    """
    clicks = replace(clicks_of(body, body.target), **asdict(found[0]), followed=found[1])

    def work(session: Session) -> MeasurementBody:
        key, again = str(body.client_key), body.repeat_of
        return _answer_with_body(
            lambda: service.store_measurement(session, vehicle_id, key, clicks, repeat_of=again, actor=who.id)
        )

    return await writes.to(SurveyOf("vehicles", vehicle_id), work)


@router.get("/measurements/{measurement_id}")
def get_measurement(measurement_id: PathId, who: Viewer, session: Reading) -> MeasurementBody:
    """The current revision, withdrawn or not."""
    return measurement_body(store.get_measurement(session, measurement_id))


@router.put("/measurements/{measurement_id}")
async def revise_measurement(
    measurement_id: PathId,
    body: ChangedMeasurement,
    who: Operator,
    found: Annotated[tuple[Origin, str | None], Depends(_found_of_change)],
    writes: Writes,
) -> MeasurementBody:
    """A new revision; sigma and inset left out are the survey's, as while clicking.

    Further frames left out are taken away: what is sent is what the revision stands on.
    """

    def work(session: Session) -> MeasurementBody:
        before = store.require_measurement_revision(session, measurement_id, body.revision)
        clicks = clicks_of(body, body.target or before.values.target)
        clicks = replace(clicks, **asdict(found[0]), followed=found[1])
        return _answer_with_body(lambda: service.store_revision(session, before, clicks, actor=who.id))

    return await writes.to(SurveyOf("measurement_series", measurement_id), work)


@router.delete("/measurements/{measurement_id}")
async def withdraw_measurement(
    measurement_id: PathId,
    revision: Annotated[int, Query(ge=1, le=2**31 - 1, description="The revision that you saw.")],
    who: Operator,
    writes: Writes,
) -> MeasurementBody:
    """A new revision that takes the measurement out of lists and counts; nothing is erased."""

    def work(session: Session) -> MeasurementBody:
        return measurement_body(
            store.withdraw_measurement(session, measurement_id, seen_revision=revision, actor=who.id)
        )

    return await writes.to(SurveyOf("measurement_series", measurement_id), work)


@router.post("/measurements/{measurement_id}/restore")
async def restore_measurement(
    measurement_id: PathId, body: AtRevision, who: Operator, writes: Writes
) -> MeasurementBody:
    """A new revision that brings a withdrawn measurement back."""

    def work(session: Session) -> MeasurementBody:
        return _answer_with_body(
            lambda: store.restore_measurement(
                session, measurement_id, seen_revision=body.revision, actor=who.id
            )
        )

    return await writes.to(SurveyOf("measurement_series", measurement_id), work)


def _answer_with_body(work: Callable[[], Measurement]) -> MeasurementBody:
    """What is stored, as it goes out; so does the measurement that a conflict carries."""
    try:
        return measurement_body(work())
    except Conflict as error:
        if isinstance(error.current, Measurement):
            error.current = measurement_body(error.current)
        raise
