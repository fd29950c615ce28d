"""What the report shows. Whoever has the database fills it in; the drawing asks nobody.

Lengths are metres, angles radians, `u_` is a standard uncertainty (k = 1). Texts are people's own words: the
drawing shows them as they are, whatever signs they hold. An empty tuple or None stands for "there is
none", and the report says so in words.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import date, datetime

from sightline.enums import LengthUnit
from sightline.export.verdicts import VerdictCounts
from sightline.messages.said import Said
from sightline.results.survey_statistics import Statistics, StatisticsOptions
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import ScanStatistics
from sightline.statistics.sampling import Response, Sampling
from sightline.surveys.photographs.records import PhotographFile
from sightline.surveys.place import Place


@dataclass(frozen=True)
class RecordingFacts:
    """One recording; `sha256` of its file."""

    name: str
    camera: str
    lighting: str
    frames: int | None
    duration_s: float | None
    width_px: int | None
    height_px: int | None
    sha256: str
    started_at: str = ""
    time_zone: str = ""
    weather: str = ""


@dataclass(frozen=True)
class LensParameter:
    """One number of a lens model; u is None where it is not known."""

    name: str
    value: float
    u: float | None


@dataclass(frozen=True)
class CalibrationFacts:
    """A calibration that measurements rest on. `source`: images, clip, import, or words of one's own."""

    camera: str
    number: int
    made_on: date
    source: str
    model: str
    width_px: int
    height_px: int
    rms_px: float | None
    views_used: int
    views_given: int
    parameters: tuple[LensParameter, ...]
    warnings: tuple[Said, ...] = ()
    trusted: bool = False


@dataclass(frozen=True)
class ExpectedHeight:
    """How well a height is expected to be known at a distance; None where the picture shows no road there."""

    distance_m: float
    U95_height_m: float | None


@dataclass(frozen=True)
class PoseFacts:
    """A road pose. `board` in words ("6 x 4 inner corners of 100 mm"), None where there was none."""

    number: int
    recording: str
    camera: str
    calibration: int
    first_frame: int
    last_frame: int
    camera_height_m: float
    board: str | None
    reference_height_m: float | None
    u_reference_height_m: float | None
    u_lean_rad: float | None
    distance_m: float | None
    rms_px: float | None
    expected: tuple[ExpectedHeight, ...] = ()
    warnings: tuple[Said, ...] = ()


@dataclass(frozen=True)
class InsetFacts:
    """How far behind the side plane a target is taken to lie. `note`: where the number comes from."""

    target: str
    inset_m: float
    u_inset_m: float
    note: str = ""


@dataclass(frozen=True)
class Exclusion:
    """A measurement that counts for no result. `state`: rejected, withdrawn, not measurable, to review."""

    measurement: int
    vehicle: str
    target: str
    state: str
    reason: Said | str


@dataclass(frozen=True)
class RigFacts:
    """A line-scan recording and the rig that took it. `misalignment_px` None: estimated from the traffic."""

    name: str
    source: str
    lighting: str
    lines: int | None
    rows_px: int | None
    baseline_m: float
    u_baseline_m: float
    line_rate_hz: float
    u_line_rate_ratio: float
    divergence_rad: float
    u_divergence_rad: float
    distance_m: float | None
    misalignment_px: float | None
    u_misalignment_px: float


@dataclass(frozen=True, eq=False)
class ScanFacts:
    """The line scans of a survey. `methods`: how many counted vehicles each method measured."""

    rigs: tuple[RigFacts, ...]
    statistics: ScanStatistics
    methods: tuple[tuple[str, int], ...] = ()
    heights: tuple[ScannedHeights, ...] = ()


@dataclass(frozen=True)
class Checksum:
    """A file of the package."""

    path: str
    sha256: str


@dataclass(frozen=True, eq=False)
class ReportFacts:
    """Everything that the report shows.

    `as_of`: when the last event of the audit chain happened; a report holds no date of the clock, so that the
    same state gives the same bytes. `counts`: words and numbers for the title block. `exclusions_total`: how
    many there are, where `exclusions` holds only the first; None: all are there. `checksums`: files of the
    package other than the report. `selection`: the vehicles it is of, in words; None: all. `language`: that
    of the report, in which its words are already. `as_in_the_paper`: the statistics with insets of 0 and
    whole centimetres. `not_visible`: targets that could not be seen; `out_of_date`: heights whose facts have
    changed.
    """

    survey: str
    site: str
    statistics: Statistics
    choices: StatisticsOptions
    as_in_the_paper: Statistics | None = None
    description: str = ""
    as_of: datetime | None = None
    first_day: date | None = None
    last_day: date | None = None
    place: Place = field(default_factory=Place)
    selection: str | None = None
    counts: tuple[tuple[str, int], ...] = ()
    photos: tuple[PhotographFile, ...] = ()
    recordings: tuple[RecordingFacts, ...] = ()
    calibrations: tuple[CalibrationFacts, ...] = ()
    poses: tuple[PoseFacts, ...] = ()
    insets: tuple[InsetFacts, ...] = ()
    exclusions: tuple[Exclusion, ...] = ()
    exclusions_total: int | None = None
    not_visible: int = 0
    out_of_date: int = 0
    scans: ScanFacts | None = None
    sampling: Sampling = field(default_factory=Sampling)
    response: tuple[Response, ...] = ()
    verdicts: VerdictCounts = field(default_factory=VerdictCounts)
    code_versions: tuple[str, ...] = ()
    audit_events: int = 0
    audit_head: str = ""
    checksums: tuple[Checksum, ...] = ()
    unit: LengthUnit = "m"
    language: str = "en"
