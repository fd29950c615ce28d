"""Whether the processes of one installation on PostgreSQL are set up alike, and their clocks agree.

Each names its connections with marks of its settings (PostgreSQL's `application_name`, which all see in
`pg_stat_activity`), and looks at the others' when it starts. A mark is a part of a hash and tells nothing.
"""

import hashlib
from datetime import datetime
from pathlib import Path
from typing import Any

from sqlalchemy import Engine, event, make_url, text

from sightline.errors import BadInput
from sightline.infra.audit.signing import signing_key
from sightline.infra.database.engine import translate_database_errors
from sightline.infra.database.types import now
from sightline.infra.private import made_once
from sightline.infra.web.secret import signing_secret
from sightline.settings import Settings

#: a file in each folder that processes share, with which they know it again
MARK_FILE = ".shared"
#: what clocks may differ by: sessions and jobs bear it
CLOCKS_S = 300.0
#: what has no part in a process's work has this mark
_UNUSED = "-"
_OURS = "'sightline ' || left(md5(current_schema()), 6)"
_NAME = f"SELECT set_config('application_name', {_OURS} || ' ' || %s, false)"
_NAMES = text(f"""
    SELECT application_name FROM pg_stat_activity
    WHERE datname = current_database() AND pid <> pg_backend_pid() AND starts_with(application_name, {_OURS})
""")
_CLOCK = text("SELECT clock_timestamp()")


def require_alike(engine: Engine, settings: Settings, *, app: bool) -> None:
    """Show this process's settings, and hold them against those of the processes that run.

    Raises BadInput for a setting that differs, by its name, and for a clock minutes off the database's.
    """
    if engine.dialect.name != "postgresql":
        return
    marks = show_settings(engine, settings, app=app)
    with translate_database_errors(), engine.connect() as connection:
        others = [name.split()[2:] for name in connection.execute(_NAMES).scalars()]
        shown: datetime = connection.execute(_CLOCK).scalar_one()
    off_s = abs((now() - shown).total_seconds())
    if off_s > CLOCKS_S:
        raise BadInput("infra-clocks-apart", minutes=round(off_s / 60))
    for place, (name, mark) in enumerate(marks.items()):
        theirs = {other[place] for other in others if len(other) == len(marks)} - {_UNUSED}
        if mark != _UNUSED and theirs - {mark}:
            raise BadInput("infra-setting-differs", name=name)


def show_settings(engine: Engine, settings: Settings, *, app: bool) -> dict[str, str]:
    """Give the engine's connections, from now on, the name that shows its settings; returns the marks."""
    if engine.dialect.name != "postgresql":
        return {}
    marks = {
        "SIGHTLINE_SECRET": _mark(signing_secret(settings)) if app else _UNUSED,
        "SIGHTLINE_SIGNING_KEY": _mark(signing_key(settings).public.encode()),
        "SIGHTLINE_MEDIA_URL": _mark(_media_place(settings.media_url)),
        "SIGHTLINE_UPLOADS_DIR": _mark(made_once(settings.uploads_dir / MARK_FILE)) if app else _UNUSED,
    }

    @event.listens_for(engine, "connect")
    def name(connection: Any, _record: Any) -> None:
        connection.execute(_NAME, [" ".join(marks.values())])
        connection.commit()

    engine.dispose()
    with translate_database_errors(), engine.connect():
        return marks


def _media_place(address: str) -> bytes:
    """What is the same for the same store, whatever name its server goes by from here."""
    if address.startswith("s3://"):
        place = make_url(address)
        return f"{place.host}/{(place.database or '').strip('/')}".encode()
    return made_once(Path(address.removeprefix("file://")) / MARK_FILE)


def _mark(content: bytes) -> str:
    return hashlib.sha256(b"sightline: a setting\0" + content).hexdigest()[:8]
