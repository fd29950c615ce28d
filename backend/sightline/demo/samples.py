"""Files of the demonstration to try with, where one's own will go: lab pictures, a clip, a catalogue."""

import csv
import io
import zipfile
from dataclasses import asdict, dataclass
from typing import Annotated

from pydantic import Field

from sightline.demo.made import catalogue, lab_images, truth
from sightline.infra.database import Session
from sightline.recordings.store import list_recordings
from sightline.surveys.store import demo_survey_id

_COLUMNS = (
    *("make", "model", "year_from", "year_to", "category"),
    *("length_m", "width_m", "height_m", "wheelbase_m", "source"),
)


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


def samples(session: Session) -> Samples:
    """What a newcomer can try with here."""
    survey_id = demo_survey_id(session)
    if survey_id is None:
        return Samples(pictures=None, clip=None)
    ready = [one.id for one in list_recordings(session, survey_id) if one.state == "ready"]
    board = truth().lab
    pictures = SamplePictures(
        count=len(lab_images()), columns=board.columns, rows=board.rows, square_m=board.square_m
    )
    return Samples(pictures=pictures, clip=min(ready, default=None))


def pictures_zip() -> bytes:
    """The lab pictures as one file."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:  # JPEG is packed already
        for path in lab_images():
            archive.write(path, path.name)
    return out.getvalue()


def catalogue_file() -> bytes:
    """The invented models as a CSV that an import reads."""
    out = io.StringIO(newline="")
    writer = csv.DictWriter(out, _COLUMNS, extrasaction="ignore")
    writer.writeheader()
    writer.writerows(asdict(row) for row in catalogue())
    return out.getvalue().encode()
