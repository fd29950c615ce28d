"""How a long piece of work learns that nobody wants it any more."""

from __future__ import annotations

from collections.abc import Callable

from sightline.errors import Conflict

Cancelled = Callable[[], bool]


class IngestCancelled(Conflict):
    """Somebody asked for the ingest to stop; nothing of it is kept."""

    kind = "cancelled"


def check_cancelled(is_cancelled: Cancelled, name: str) -> None:
    """Raise IngestCancelled if the work on the file called `name` is no longer wanted."""
    if is_cancelled():
        raise IngestCancelled("media-ingest-cancelled-nothing-kept", name=name)
