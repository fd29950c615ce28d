"""Which model of the catalogue a vehicle can be."""

from fastapi import APIRouter

from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.quality.which_model import service
from sightline.quality.which_model.records import WhichModel

router = APIRouter()


@router.get("/vehicles/{vehicle_id}/which-model")
def which_model(vehicle_id: PathId, who: Viewer, session: Reading) -> WhichModel:
    """Models that fit what was measured, ranked by lengths alone, and whether the one filled in can fit."""
    return service.which_model(session, vehicle_id)
