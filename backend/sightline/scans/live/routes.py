"""Live streams of line-scan cameras, to be looked at."""

from datetime import datetime

from fastapi import APIRouter

from sightline.coverage import expanded
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.scans.live.bodies import LiveScanBody, LiveStreamBody, LiveVehicleBody
from sightline.scans.live.service import LiveStream, live_streams
from sightline.scans.vehicles.listing import ShownVehicle
from sightline.surveys.store import get_survey

router = APIRouter()


@router.get("/surveys/{survey_id}/live")
def get_live(survey_id: PathId, who: Viewer, session: Reading) -> list[LiveStreamBody]:
    """The streams of a survey, newest first, each with its health, last vehicles and flow."""
    get_survey(session, survey_id)
    return [_stream_body(one) for one in live_streams(session, survey_id)]


def _stream_body(one: LiveStream) -> LiveStreamBody:
    scan = one.scan
    return LiveStreamBody.model_validate(
        {
            **{name: getattr(scan, name) for name in LiveScanBody.model_fields},
            **{name: getattr(scan, name) for name in ("source", "heard_at", "line_rate_hz", "health")},
            "state": one.state,
            "until": one.until,
            "vehicles": [_vehicle_body(vehicle, at) for vehicle, at in one.vehicles],
            "flow": one.flow,
            "earlier": [LiveScanBody.model_validate(before) for before in one.earlier],
        }
    )


def _vehicle_body(one: ShownVehicle, at: datetime) -> LiveVehicleBody:
    values = one.vehicle.measurement and one.vehicle.measurement.values
    return LiveVehicleBody(
        id=one.vehicle.id,
        number=one.vehicle.number,
        front_at=at,
        direction=values.direction if values else None,
        lane=values.lane if values else None,
        axles=values.axles if values else None,
        speed_mps=values.speed_mps if values else None,
        U95_speed_mps=expanded(values.u_speed_mps) if values else None,
        length_m=values.length_m if values else None,
        U95_length_m=expanded(values.u_length_m) if values else None,
        time_gap_s=one.gap.time_gap_s if one.gap else None,
        status=values.status if values else None,
        reason=values.reason if values else None,
    )
