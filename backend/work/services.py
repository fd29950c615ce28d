"""What every shell needs to work: settings, database, media store and frame server, opened once a process."""

from contextlib import AbstractContextManager
from dataclasses import dataclass

from sqlalchemy import Engine
from sqlalchemy.orm import Session

from backend.media.frames import FrameServer
from backend.media.store import MediaStore, open_store
from backend.settings import Settings
from backend.storage import database
from backend.work.stills import Stills

FRAME_MEMORY_BYTES = 256 * 1024**2
FRAME_DISK_BYTES = 2 * 1024**3


@dataclass(frozen=True, eq=False)
class Services:
    """One process's open doors. Shared by threads; every part of it is safe for that."""

    settings: Settings
    engine: Engine
    sessions: database.SessionFactory
    media: MediaStore
    frames: FrameServer
    stills: Stills

    def reading(self) -> AbstractContextManager[Session]:
        """A session that sees one state of the database and never commits."""
        return database.reading(self.sessions)

    def writing(self) -> AbstractContextManager[Session]:
        """The write transaction of this thread; committed when the block ends, rolled back on any error."""
        return database.writing(self.sessions)

    def close(self) -> None:
        """Give files and connections back."""
        self.frames.close()
        self.engine.dispose()


def open_services(settings: Settings) -> Services:
    """Open the database and the media store. Migrates nothing and starts nothing."""
    engine = database.make_engine(settings.database_url)
    sessions = database.session_factory(engine)
    cache = settings.data_dir / "cache"
    store = open_store(settings.media_url, cache / "media")
    server = FrameServer(cache, FRAME_MEMORY_BYTES, FRAME_DISK_BYTES)
    return Services(
        settings=settings,
        engine=engine,
        sessions=sessions,
        media=store,
        frames=server,
        stills=Stills(sessions, store, server),
    )
