"""Measurements: each click pair is stored at once; a correction is a new revision."""

from collections.abc import AsyncIterator
from dataclasses import replace
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request

from sightline.enums import Target
from sightline.infra.database import Session
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, writing_to
from sightline.infra.web.quantities import AtRevision
from sightline.measurements import service, store
from sightline.measurements.bodies import (
    ChangedMeasurement,
    ClicksIn,
    MeasurementBody,
    NewMeasurement,
    measurement_body,
)
from sightline.measurements.records import ClickedFrame, Clicks

router = APIRouter()


async def _writing_to_vehicle(
    vehicle_id: PathId, request: Request, services: Wired
) -> AsyncIterator[Session]:
    async with writing_to(request, services, partial(store.survey_of_vehicle, vehicle_id=vehicle_id)) as made:
        yield made


async def _writing_to_measurement(
    measurement_id: PathId, request: Request, services: Wired
) -> AsyncIterator[Session]:
    find = partial(store.survey_of_measurement, series_id=measurement_id)
    async with writing_to(request, services, find) as made:
        yield made


OfVehicle = Annotated[Session, Depends(_writing_to_vehicle, scope="function")]
OfMeasurement = Annotated[Session, Depends(_writing_to_measurement, scope="function")]


def clicks_of(body: ClicksIn, target: Target) -> Clicks:
    """What the body says was clicked."""
    return Clicks(
        target=target,
        frame=body.frame,
        contact=body.contact,
        target_point=body.target_point,
        more_frames=tuple(
            ClickedFrame(frame=further.frame, contact=further.contact, target_point=further.target_point)
            for further in body.more_frames
        ),
        sigma_px=body.sigma_px,
        inset_m=body.inset_m,
        u_inset_m=body.u_inset_m,
    )


@router.post("/vehicles/{vehicle_id}/measurements", status_code=201)
def add_measurement(
    vehicle_id: PathId, body: NewMeasurement, who: Operator, session: OfVehicle
) -> MeasurementBody:
    """Store one height; sending the same `client_key` again gives back the one that is stored.

    A height that cannot be had is stored too, with its reason. Without a road pose this is a conflict.
    """
    stored = service.store_measurement(
        session,
        vehicle_id,
        str(body.client_key),
        replace(clicks_of(body, body.target), made=body.made),
        repeat_of=body.repeat_of,
        actor=who.id,
    )
    return measurement_body(stored)


@router.get("/measurements/{measurement_id}")
def get_measurement(measurement_id: PathId, who: Viewer, session: Reading) -> MeasurementBody:
    """The current revision, withdrawn or not."""
    return measurement_body(store.get_measurement(session, measurement_id))


@router.put("/measurements/{measurement_id}")
def revise_measurement(
    measurement_id: PathId, body: ChangedMeasurement, who: Operator, session: OfMeasurement
) -> MeasurementBody:
    """A new revision; sigma and inset left out are the survey's, as while clicking.

    Further frames left out are taken away: what is sent is what the revision stands on.
    """
    target = body.target or store.get_measurement(session, measurement_id).values.target
    changed = service.store_revision(
        session, measurement_id, body.revision, clicks_of(body, target), actor=who.id
    )
    return measurement_body(changed)


@router.delete("/measurements/{measurement_id}")
def withdraw_measurement(
    measurement_id: PathId,
    revision: Annotated[int, Query(ge=1, le=2**31 - 1, description="The revision that you saw.")],
    who: Operator,
    session: OfMeasurement,
) -> MeasurementBody:
    """A new revision that takes the measurement out of lists and counts; nothing is erased."""
    gone = store.withdraw_measurement(session, measurement_id, seen_revision=revision, actor=who.id)
    return measurement_body(gone)


@router.post("/measurements/{measurement_id}/restore")
def restore_measurement(
    measurement_id: PathId, body: AtRevision, who: Operator, session: OfMeasurement
) -> MeasurementBody:
    """A new revision that brings a withdrawn measurement back."""
    back = store.restore_measurement(session, measurement_id, seen_revision=body.revision, actor=who.id)
    return measurement_body(back)
