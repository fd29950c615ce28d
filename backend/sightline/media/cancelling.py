"""How a long piece of work learns that nobody wants it any more."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from sightline.errors import Conflict, SightlineError

PROGRESS_EVERY_S = 0.25
Cancelled = Callable[[], bool]
Progress = Callable[[float], None]


class IngestCancelled(Conflict):
    """Somebody asked for the ingest to stop; nothing of it is kept."""

    kind = "cancelled"


_STOPPED = partial(IngestCancelled, "media-import-cancelled")


def check_cancelled(is_cancelled: Cancelled, name: str) -> None:
    """Raise IngestCancelled if the work on the file called `name` is no longer wanted."""
    if is_cancelled():
        raise _STOPPED(name=name)


@dataclass
class Watch:
    """Progress of reading a file by the share of its bytes; once nobody wants it, `stopped` is raised."""

    on_progress: Progress
    is_cancelled: Cancelled
    name: str
    size: int = 0
    stopped: Callable[..., SightlineError] = _STOPPED
    next_s: float = 0.0

    def look(self, position: int | None) -> None:
        """At every step of the reading, `position` bytes into the file."""
        if self.is_cancelled():
            raise self.stopped(name=self.name)
        now = time.monotonic()
        if position is not None and now >= self.next_s:
            self.next_s = now + PROGRESS_EVERY_S
            self.on_progress(min(0.99, position / max(self.size, 1)))
