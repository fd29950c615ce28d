"""Facts of a made-up survey, for reports."""

from __future__ import annotations

from datetime import UTC, date, datetime

from sightline.enums import LengthUnit
from sightline.export.report.facts import (
    CalibrationFacts,
    Checksum,
    Exclusion,
    ExpectedHeight,
    InsetFacts,
    LensParameter,
    PoseFacts,
    RecordingFacts,
    ReportFacts,
)
from sightline.geometry.insets import USUAL_INSETS
from sightline.results.survey_statistics import Statistics, StatisticsOptions
from sightline.surveys.photographs.records import PhotographFile
from sightline.surveys.place import Place

_LENS = (
    ("fx_px", 1210.44, 1.13),
    ("fy_px", 1209.87, 1.12),
    ("cx_px", 961.2, 1.9),
    ("cy_px", 538.8, 1.7),
    ("k1", -0.3121, 0.0021),
    ("k2", 0.1174, 0.0064),
    ("p1", 0.00051, 0.00011),
    ("p2", -0.00032, 0.00012),
    ("k3", -0.0213, 0.0049),
)


def facts(
    statistics: Statistics,
    *,
    survey: str = "Rouen south, spring",
    photos: tuple[PhotographFile, ...] = (),
    exclusions: int = 9,
    unit: LengthUnit = "m",
    choices: StatisticsOptions = StatisticsOptions(),
) -> ReportFacts:
    """A survey with two recordings, one camera, two poses."""
    return ReportFacts(
        survey=survey,
        site="N138, kilometre 4.2, direction of Rouen",
        description="Heights of eyes and taillights on a divided road, as an example.",
        statistics=statistics,
        as_in_the_paper=statistics,
        choices=choices,
        as_of=datetime(2026, 5, 4, 13, 12, 9, tzinfo=UTC),
        place=Place(
            latitude_deg=49.44315,
            longitude_deg=1.09932,
            road_class="dual carriageway",
            speed_limit_mps=90 / 3.6,
            street_lamps="none",
            time_zone="Europe/Paris",
        ),
        first_day=date(2026, 4, 20),
        last_day=date(2026, 5, 3),
        counts=(("recordings", 2), ("vehicles", 412), ("measurements", 1228), ("accepted", 1200)),
        photos=photos,
        recordings=tuple(
            RecordingFacts(
                name,
                "Axis 211W",
                light,
                5400,
                180.0,
                1920,
                1080,
                "9f2c" * 16,
                start,
                "Europe/Paris",
                "overcast",
            )
            for name, light, start in (
                ("lane-1-day.mkv", "daytime", "2026-04-18T08:10:00.000+02:00"),
                ("lane-1-dusk.mkv", "low_light", "2026-04-18T21:05:00.000+02:00"),
            )
        ),
        calibrations=(
            CalibrationFacts(
                "Axis 211W",
                1,
                date(2026, 4, 19),
                "from 24 pictures of a checkerboard",
                "brown",
                1920,
                1080,
                0.183,
                22,
                24,
                tuple(LensParameter(*one) for one in _LENS),
                ("The lower left corner of the picture holds no corner of the board.",),
                True,
            ),
        ),
        poses=tuple(_pose(k, name) for k, name in ((1, "lane-1-day.mkv"), (2, "lane-1-dusk.mkv"))),
        insets=tuple(
            InsetFacts(name, inset, u, note)
            for name, (inset, u, note) in USUAL_INSETS.items()
            if name != "other"
        ),
        exclusions=tuple(
            Exclusion(
                1000 + k, f"{k + 1}, Peugeot 3008 2019", "driver_eye", "rejected", "The driver leans forward."
            )
            for k in range(exclusions)
        ),
        code_versions=("0.1.0+ab52b2c00f11",),
        audit_events=4821,
        audit_head="4be1" * 16,
        checksums=tuple(
            Checksum(path, "0a1b" * 16)
            for path in ("audit.csv", "measurements.csv", "vehicles.csv", "poses.csv")
        ),
        unit=unit,
    )


def _pose(number: int, recording: str) -> PoseFacts:
    return PoseFacts(
        number,
        recording,
        "Axis 211W",
        1,
        120,
        271,
        1.502,
        "6 × 4 inner corners of 100 mm",
        0.615,
        0.003,
        0.005,
        3.02,
        0.041,
        (ExpectedHeight(2.0, 0.0142), ExpectedHeight(3.0, 0.0161), ExpectedHeight(5.0, None)),
        (),
    )
