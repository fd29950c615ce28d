"""Whether the server is there."""

from fastapi import APIRouter

from sightline.infra.version import code_version
from sightline.infra.web.bodies import Out
from sightline.infra.web.deps import OPEN

router = APIRouter()


class Health(Out):
    ok: bool
    version: str


@router.get("/health", dependencies=[OPEN])
async def health() -> Health:
    """Answers as soon as the server is up; needs no sign-in."""
    return Health(ok=True, version=code_version())
