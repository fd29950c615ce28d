"""What every process needs: settings, database, media store and frame server, opened once."""

import os
import shutil
import tempfile
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from threading import RLock
from typing import Protocol, TypeVar, cast

from sqlalchemy import Engine
from sqlalchemy.orm import Session

from sightline.infra.database.engine import (
    SHORT_IDLE_S,
    Beside,
    InSurvey,
    SessionFactory,
    make_engine,
    reading,
    session_factory,
    sync,
    writing,
)
from sightline.infra.scratch import Scratch, sweep
from sightline.media.store.local import MediaStore
from sightline.media.store.opening import open_store
from sightline.media.video.decode_host import DecodeHost
from sightline.media.video.frames import FrameServer
from sightline.settings import Settings

#: how long a process may still believe what it read when another changed it; there, changes count at once
BELIEVED_S = 2.0
FRAME_MEMORY_BYTES = 256 * 1024**2
FRAME_DISK_BYTES = 2 * 1024**3
_SCRATCH = "scratch"


class Part(Protocol):
    """What a slice keeps open as long as the process's services are."""

    def close(self) -> None:
        """End its threads and give its files back."""


P = TypeVar("P", bound=Part)


@dataclass(frozen=True, eq=False)
class Services:
    """One process's open doors. Shared by threads; every part of it is safe for that."""

    settings: Settings
    engine: Engine
    sessions: SessionFactory
    media: MediaStore
    frames: FrameServer
    _parts: dict[Callable[["Services"], Part], Part] = field(default_factory=dict)
    _making: RLock = field(default_factory=RLock)
    #: for caches and scratch, where the data folder is on a medium that cannot be written
    _aside: Path | None = None

    def reading(self) -> AbstractContextManager[Session]:
        """A session that sees one state of the database and never commits."""
        return reading(self.sessions)

    def writing(
        self, within: InSurvey | Beside | None = None, *, unsynced: bool = False
    ) -> AbstractContextManager[Session]:
        """The write transaction of this thread; committed when the block ends, rolled back on any error.

        `within`: the only survey that it writes to, so that other surveys need not wait (`SIGN_IN` and
        `ANSWERS`: none).
        `unsynced`: on the disk for good only once `sync` has returned.
        """
        return writing(self.sessions, within, unsynced=unsynced)

    def sync(self) -> None:
        """Returns when everything that was committed before is on the disk."""
        sync(self.sessions)

    def part(self, make: Callable[["Services"], P]) -> P:
        """What `make(services)` gives: made the first time it is asked for, closed with the services."""
        with self._making:
            if make not in self._parts:
                self._parts[make] = make(self)
            return cast(P, self._parts[make])

    @property
    def read_only(self) -> bool:
        """Whether the data folder is on a medium that cannot be written."""
        return self._aside is not None

    @property
    def scratch(self) -> Path:
        """This process's folder for files on their way to somewhere else, on the disk of the data folder."""
        return self.part(_scratch).folder()

    def close(self) -> None:
        """Give files and connections back."""
        with self._making:
            for part in reversed(self._parts.values()):
                part.close()
        self.frames.close()
        self.engine.dispose()
        if self._aside is not None:
            shutil.rmtree(self._aside, ignore_errors=True)


def open_services(settings: Settings, *, decode_in_child: bool = True, serving: bool = False) -> Services:
    """Open database and media store, and remove what killed processes left. Migrates and starts nothing.

    `serving`: people wait for what it writes, so that no write of it may keep the others waiting for long.
    `decode_in_child`: a hostile file may end the child in which stills are decoded, never this process.
    """
    engine = make_engine(settings.database_url)
    sessions = session_factory(engine, idle_s=SHORT_IDLE_S if serving else None)
    aside = None
    if settings.data_dir.is_dir() and not os.access(settings.data_dir, os.W_OK):
        aside = Path(tempfile.mkdtemp(prefix="sightline-"))
    else:
        sweep(settings.data_dir / _SCRATCH)
    cache = (aside or settings.data_dir) / "cache"
    store = open_store(settings.media_url, cache / "media")
    pictures = DecodeHost(FRAME_MEMORY_BYTES * 3 // 4) if decode_in_child else None
    server = FrameServer(cache, FRAME_MEMORY_BYTES, FRAME_DISK_BYTES, pictures=pictures)
    return Services(settings, engine, sessions, store, server, _aside=aside)


def _scratch(services: Services) -> Scratch:
    return Scratch((services._aside or services.settings.data_dir) / _SCRATCH)
