"""Whether this machine's clock was set back: order is by number, but times and limits then look odd."""

import logging
import threading
import time
from dataclasses import dataclass
from datetime import datetime

from sightline.infra.database import types

log = logging.getLogger("sightline.clock")

#: less is a clock that is being steered, as it should be
LEAST_S = 1.0


@dataclass(frozen=True, slots=True)
class ClockSetBack:
    """The last time that the clock showed less than before, as the clock shows it since, and by how much."""

    noticed_at: datetime
    by_s: float


class ClockWatch:
    """Compares the clock with the seconds that went by; asked with every request."""

    def __init__(self) -> None:
        self._ahead_s = types.now().timestamp() - time.monotonic()
        self._lock = threading.Lock()
        self.set_back: ClockSetBack | None = None

    def look(self) -> None:
        """Note and log it if the clock went back since the last look."""
        with self._lock:
            shown = types.now()
            ahead_s = shown.timestamp() - time.monotonic()
            by_s, self._ahead_s = self._ahead_s - ahead_s, ahead_s
            if by_s >= LEAST_S:
                self._note(shown, by_s)

    def begin_behind(self, newest: datetime | None) -> None:
        """At a start: what is stored is of the past, or the clock went back; `newest` is its last moment."""
        with self._lock:
            shown = types.now()
            if newest is not None and (by_s := (newest - shown).total_seconds()) >= LEAST_S:
                self._note(shown, by_s)

    def _note(self, shown: datetime, by_s: float) -> None:
        self.set_back = ClockSetBack(shown, round(by_s, 1))
        log.warning(
            "the clock went back by %.1f s; nobody is signed out, what is stored keeps its order", by_s
        )
