"""What the report shows. Whoever has the database fills it in; the drawing asks nobody.

Lengths are metres, angles radians, `u_` is a standard uncertainty (k = 1). Texts are people's own words: the
drawing shows them as they are, whatever signs they hold. An empty tuple or None stands for "there is
none", and the report says so in words.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import date, datetime
from typing import Any

from sightline.enums import LengthUnit
from sightline.export.verdicts import VerdictCounts
from sightline.results.survey_statistics import Statistics, StatisticsOptions
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import ScanStatistics
from sightline.statistics.sampling import Response, Sampling
from sightline.surveys.photographs.records import PhotographFile
from sightline.surveys.place import Place

#: A row of a table of the package by its columns (`package_facts.table_rows`), and what is told beside it.
Row = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class ScanFacts:
    """The line scans of a survey: `rigs`, a row of line_scans.csv each, or one a lane. `methods`: how many
    counted vehicles each method measured.
    """

    rigs: tuple[Row, ...]
    statistics: ScanStatistics
    methods: tuple[tuple[str, int], ...] = ()
    heights: tuple[ScannedHeights, ...] = ()


@dataclass(frozen=True, eq=False)
class ReportFacts:
    """Everything that the report shows.

    `recordings`, the `calibrations` and `poses` that heights rest on, `insets` and `exclusions` are rows of
    the package's tables; a recording has the name of its `camera` beside it, a pose that and its recording's.

    `as_of`: when the last event of the audit chain happened; a report holds no date of the clock, so that the
    same state gives the same bytes. `counts`: words and numbers for the title block. `exclusions_total`: how
    many there are, where `exclusions` holds only the first; None: all are there. `checksums`: SHA-256 by path
    of the other files of the package. `selection`: the vehicles it is of, in words; None: all. `language`:
    that of the report, in which its words are already. `as_in_the_paper`: the statistics with insets of 0 and
    whole centimetres. `not_visible`: targets of the vehicles that count that could not be seen;
    `out_of_date`: heights in the results whose facts have changed.
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
    recordings: tuple[Row, ...] = ()
    calibrations: tuple[Row, ...] = ()
    poses: tuple[Row, ...] = ()
    insets: tuple[Row, ...] = ()
    exclusions: tuple[Row, ...] = ()
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
    checksums: Mapping[str, str] = field(default_factory=dict)
    unit: LengthUnit = "m"
    language: str = "en"
