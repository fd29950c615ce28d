"""Facts of a made-up survey, for reports."""

from __future__ import annotations

from datetime import UTC, date, datetime

from sightline.enums import LengthUnit
from sightline.export.report.facts import ReportFacts, Row
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
            {
                "name": name,
                "camera": "Axis 211W",
                "lighting": light,
                "frame_count": 5400,
                "duration_s": 180.0,
                "width_px": 1920,
                "height_px": 1080,
                "sha256": "9f2c" * 16,
                "started_at": datetime.fromisoformat(start),
                "time_zone": "Europe/Paris",
                "weather": "overcast",
            }
            for name, light, start in (
                ("lane-1-day.mkv", "daytime", "2026-04-18T08:10:00.000+02:00"),
                ("lane-1-dusk.mkv", "low_light", "2026-04-18T21:05:00.000+02:00"),
            )
        ),
        calibrations=(
            {
                "camera_name": "Axis 211W",
                "id": 1,
                "created_at": datetime(2026, 4, 19, 9, tzinfo=UTC),
                "source": "from 24 pictures of a checkerboard",
                "model": "brown",
                "width_px": 1920,
                "height_px": 1080,
                "rms_px": 0.183,
                "views_used": 22,
                "views_given": 24,
                "parameters": [{"name": name, "value": value, "u": u} for name, value, u in _LENS],
                "warnings": ("The lower left corner of the picture holds no corner of the board.",),
                "trusted": True,
            },
        ),
        poses=tuple(_pose(k, name) for k, name in ((1, "lane-1-day.mkv"), (2, "lane-1-dusk.mkv"))),
        insets=tuple(
            {"target": name, "inset_m": inset, "u_inset_m": u, "note": note}
            for name, (inset, u, note) in USUAL_INSETS.items()
            if name != "other"
        ),
        exclusions=tuple(
            exclusion(1000 + k, f"{k + 1}, Peugeot 3008 2019", "driver_eye", "The driver leans forward.")
            for k in range(exclusions)
        ),
        code_versions=("0.1.0+ab52b2c00f11",),
        audit_events=4821,
        audit_head="4be1" * 16,
        checksums=dict.fromkeys(("audit.csv", "measurements.csv", "vehicles.csv", "poses.csv"), "0a1b" * 16),
        unit=unit,
    )


def exclusion(number: int, vehicle: str, target: str, reason: str, state: str = "rejected") -> Row:
    """A row of exclusions.csv."""
    return {
        "measurement_id": number,
        "vehicle_number": vehicle,
        "target": target,
        "state": state,
        "reason": reason,
        "reason_code": None,
    }


def _pose(number: int, recording: str) -> Row:
    return {
        "id": number,
        "recording": recording,
        "camera": "Axis 211W",
        "calibration_id": 1,
        "first_frame": 120,
        "last_frame": 271,
        "camera_height_m": 1.502,
        "board_columns": 6,
        "board_rows": 4,
        "square_m": 0.1,
        "reference_height_m": 0.615,
        "u_reference_height_m": 0.003,
        "u_lean_rad": 0.005,
        "board_distance_m": 3.02,
        "rms_px": 0.041,
        "expected": [
            {"distance_m": 2.0, "U95_height_m": 0.0142},
            {"distance_m": 3.0, "U95_height_m": 0.0161},
            {"distance_m": 5.0, "U95_height_m": None},
        ],
        "warnings": (),
    }
