"""Files of the demonstration to try with, where one's own will go: lab pictures, a clip, a catalogue.

The renderer is loaded when a file is asked for, not when a server starts.
"""

from __future__ import annotations

import csv
import io
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from pydantic import Field

from sightline.errors import NotFound
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.recordings.store import list_recordings
from sightline.surveys.store import demo_survey_id

_LAB = "lab"


@dataclass(frozen=True, slots=True)
class SamplePictures:
    """Pictures of a checkerboard, and what the board is."""

    count: int
    columns: Annotated[int, Field(description="Inner corners.")]
    rows: Annotated[int, Field(description="Inner corners.")]
    square_m: float


@dataclass(frozen=True, slots=True)
class Samples:
    """What there is to try with; null while the demonstration is not made."""

    pictures: SamplePictures | None
    clip: Annotated[int | None, Field(description="The recording whose video may be downloaded.")]


def samples(session: Session, services: Services) -> Samples:
    """What a newcomer can try with here."""
    survey_id = demo_survey_id(session)
    if survey_id is None:
        return Samples(pictures=None, clip=None)
    count = len(_pictures(services))
    found = [one.id for one in list_recordings(session, survey_id) if one.state == "ready"]
    return Samples(pictures=_board(count) if count else None, clip=min(found, default=None))


def pictures_zip(services: Services) -> bytes:
    """The lab pictures as one file. Raises NotFound while the demonstration is not made."""
    out = io.BytesIO()
    found = _pictures(services)
    if not found:
        raise NotFound("demo-no-sample-pictures")
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:  # PNG is packed already
        for path in found:
            archive.write(path, path.name)
    return out.getvalue()


def catalogue_file() -> bytes:
    """The invented models as a CSV that an import reads."""
    from sightline.simulation.models import catalogue

    rows = catalogue()
    out = io.StringIO(newline="")
    writer = csv.DictWriter(out, list(rows[0]))
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue().encode()


def _pictures(services: Services) -> list[Path]:
    folder = services.settings.data_dir / "demonstration" / _LAB
    return sorted(folder.glob("*.png")) if folder.is_dir() else []


def _board(count: int) -> SamplePictures:
    from sightline.simulation.board import LAB_COLUMNS, LAB_ROWS, LAB_SQUARE_M

    return SamplePictures(count=count, columns=LAB_COLUMNS, rows=LAB_ROWS, square_m=LAB_SQUARE_M)
