"""How a long piece of work learns that nobody wants it any more."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from sightline.errors import Stopped

PROGRESS_EVERY_S = 0.25
Cancelled = Callable[[], bool]
Progress = Callable[[float], None]
_STOPPED = partial(Stopped, "media-import-cancelled")


def check_cancelled(is_cancelled: Cancelled, name: str) -> None:
    """Raise Stopped if the work on the file called `name` is no longer wanted."""
    if is_cancelled():
        raise _STOPPED(name=name)


@dataclass
class Watch:
    """Progress of reading a file by the share of its bytes; once nobody wants it, `stopped` is raised."""

    on_progress: Progress
    is_cancelled: Cancelled
    name: str
    size: int = 0
    stopped: Callable[..., Stopped] = _STOPPED
    next_s: float = 0.0

    def look(self, position: int | None) -> None:
        """At every step of the reading, `position` bytes into the file."""
        if self.is_cancelled():
            raise self.stopped(name=self.name)
        now = time.monotonic()
        if position is not None and now >= self.next_s:
            self.next_s = now + PROGRESS_EVERY_S
            self.on_progress(min(0.99, position / max(self.size, 1)))
