"""Following a vehicle through its pass: asked for while measuring, nothing is stored."""

from fastapi import APIRouter

from sightline.infra.web.deps import PathId, Viewer, Wired
from sightline.measurements.bodies import FollowWanted
from sightline.measurements.following import service
from sightline.measurements.routes import clicks_of

router = APIRouter()


@router.post("/vehicles/{vehicle_id}/follow")
def follow_through_pass(
    vehicle_id: PathId, body: FollowWanted, who: Viewer, services: Wired
) -> service.FollowedAnswer:
    """Where the points are on every usable frame of the pass, which were dropped and why, and the height of
    it all. Nothing is stored: a measurement with `follow` is followed again and keeps what is found.
    """
    clicks = clicks_of(body, body.target)
    return service.follow_vehicle(services, vehicle_id, clicks, body.second_contact, actor=who.id)
