"""The demonstration's files as they were made: videos, laboratory images, line-scan strips, and their truth.

They lie in `made/`; `python -m tests.simulation.make` draws them. What is true of them is in `truth.json`,
read by those who click for the demonstration's people, and by tests.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from pathlib import Path

import numpy as np
from pydantic import TypeAdapter

from sightline.enums import AskedTarget, Category, Lighting, Point
from sightline.geometry.board import Board
from sightline.linescan.parts import Pixels
from sightline.media.images import read_image
from sightline.vehicles.catalogue.records import CatalogueRow

FOLDER = Path(__file__).with_name("made")
TRUTH = FOLDER / "truth.json"
SOURCE = "demonstration, invented"
#: Strips are cut into images of so many lines.
LINES = 16_384


@dataclass(frozen=True)
class Model:
    """An invented model of the demonstration's catalogue."""

    make: str
    model: str
    year_from: int
    year_to: int
    category: Category
    length_m: float
    width_m: float
    height_m: float
    wheelbase_m: float
    eye_height_m: float
    tail_lamp_m: float


@dataclass(frozen=True)
class FramePixels:
    """True distorted pixels of one frame: name of the spot -> (x, y); `hidden`: covered by the car."""

    frame: int
    pixels: dict[str, Point]
    hidden: tuple[str, ...] = ()

    def shows(self, name: str) -> bool:
        """Whether a spot is in the picture and can be seen."""
        return name in self.pixels and name not in self.hidden

    @property
    def contact(self) -> str | None:
        """The contact point to click: the rear wheel's where it is in the picture."""
        return next((name for name in ("contact_rear", "contact_front") if name in self.pixels), None)


@dataclass(frozen=True)
class PassTruth:
    """A vehicle that passes; `frames` are those with a contact and a target in the picture."""

    make: str
    model: str
    year: int
    category: Category
    manufacturer_height_m: float
    direction: int
    speed_mps: float
    first_frame: int
    last_frame: int
    best_frame: int
    best_frames: dict[str, int]
    frames: tuple[FramePixels, ...]


@dataclass(frozen=True)
class RoadBoard:
    """The board on the road: inner corners, and the height of the uppermost row of them."""

    columns: int
    rows: int
    square_m: float
    reference_height_m: float
    last_frame: int

    @property
    def board(self) -> Board:
        """As the detector wants it."""
        return Board(self.columns, self.rows, self.square_m)


@dataclass(frozen=True)
class SceneTruth:
    """One video: its file, its frames a second, the board in its first frames, and who passes."""

    video: str
    lighting: Lighting
    fps: int
    board: RoadBoard
    passes: tuple[PassTruth, ...]


@dataclass(frozen=True)
class HeldRod:
    """A rod in camera 1's plane: its distance, a line at which it stands, and (height, row) of its marks."""

    distance_m: float
    line: float
    marks: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class ScanTruth:
    """A vehicle of the line scan: places are (line, row) in strip 1, wheels the lines of their hubs there."""

    make: str
    model: str
    year: int
    category: Category
    length_m: float
    wheelbase_m: float
    speed_mps: float
    front_line_1: float
    wheel_lines_1: tuple[float, float]
    contact: Point
    targets: dict[AskedTarget, Point]


@dataclass(frozen=True)
class LineScanTruth:
    """The line scan: the rod held up before its first vehicle, and its vehicles in order of arrival."""

    rods: tuple[HeldRod, ...]
    vehicles: tuple[ScanTruth, ...]

    def nearest(self, front_line_1: float) -> tuple[int, ScanTruth]:
        """Which vehicle's front is nearest to a line of strip 1: its place in the order, and itself."""
        return min(enumerate(self.vehicles), key=lambda one: abs(one[1].front_line_1 - front_line_1))


@dataclass(frozen=True)
class Truth:
    """All that is true of the made files; `lab` is the board of the laboratory images."""

    models: tuple[Model, ...]
    lab: Board
    scenes: Mapping[str, SceneTruth]
    scan: LineScanTruth


@lru_cache(maxsize=1)
def truth() -> Truth:
    """What is true of the made files."""
    return TypeAdapter(Truth).validate_json(TRUTH.read_bytes())


def lab_images() -> list[Path]:
    """The laboratory images, in order."""
    return sorted(FOLDER.glob("lab-*.jpg"))


def strip_of(camera: int) -> Pixels:
    """The strip (lines, rows) of camera 1 or 2."""
    return np.concatenate([read_image(path) for path in sorted(FOLDER.glob(f"strip-{camera}-*.jpg"))])


def catalogue() -> list[CatalogueRow]:
    """The invented models as rows of the catalogue."""
    names = [one.name for one in fields(Model) if one.name in CatalogueRow.__dataclass_fields__]
    return [
        CatalogueRow(**{name: getattr(one, name) for name in names}, source=SOURCE) for one in truth().models
    ]
