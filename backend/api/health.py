"""Whether the server is there."""

from fastapi import APIRouter

from backend.api.bodies import Out
from backend.api.deps import OPEN
from backend.work.code_version import code_version

router = APIRouter()


class Health(Out):
    ok: bool
    version: str


@router.get("/health", dependencies=[OPEN])
async def health() -> Health:
    """Answers as soon as the server is up; needs no sign-in."""
    return Health(ok=True, version=code_version())
