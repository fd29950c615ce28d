"""Whether the database's pages are whole, looked at beside the work: a large file takes a while to read."""

import threading
import time

from sightline.errors import SightlineError
from sightline.infra.database.pages import require_whole_pages
from sightline.infra.services import Services

#: how long a start, or whoever asks first, waits for the answer; a file of some 500 MB is read in it
PATIENCE_S = 1.0
EVERY_S = 3600.0


class PageWatch:
    """Reads every page of a SQLite database in a thread of its own, again an hour after the last time."""

    def __init__(self, services: Services) -> None:
        self._services = services
        self._turn = threading.Lock()
        self._found: SightlineError | None = None
        self._looked_at = 0.0
        self._looking: threading.Thread | None = None

    def require_whole(self) -> None:
        """Raises Damaged, naming the tables, by what was seen last; DatabaseAway if nothing could be."""
        with self._turn:
            due = self._looking is None or time.monotonic() - self._looked_at > EVERY_S
            if due and not (self._looking and self._looking.is_alive()):
                self._looking = threading.Thread(target=self._look, name="pages", daemon=True)
                self._looked_at = time.monotonic()
                self._looking.start()
            looking = self._looking
        assert looking is not None
        looking.join(PATIENCE_S if due else 0)
        if self._found is not None:
            raise self._found

    def close(self) -> None:
        """Nothing to give back: the thread only reads, and ends with the process."""

    def _look(self) -> None:
        try:
            with self._services.reading() as session:
                require_whole_pages(session.connection(), quick=True)
        except SightlineError as error:
            self._found = error
        else:
            self._found = None
