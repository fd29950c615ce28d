"""A study from its first request to its verified package, by the API: a seeded fleet of known heights.

The clicks come from a projection of its own, written out below; heights, intervals, statistics, error table
and packages are then held against the fleet's truth. `tests/bench/bench_whole_study.py` runs it at full size.
"""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from uuid import UUID

import numpy as np
import pytest

from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.video.writer import write_mp4
from tests.export.report.pdf_text import words
from tests.media.clips import painted
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, Client, upload
from tests.support.ground import add_pose, flat_camera, lay_ground
from tests.support.packages import rows

# Vehicles by day and in low light: small studies here, Dupuis et al.'s 400 and 250 in the bench.
ASKED = os.environ.get("SIGHTLINE_STUDY_VEHICLES", "")
STUDIES = (
    [tuple(int(one) for one in ASKED.split(","))]
    if ASKED
    else [(8, 5), *(pytest.param(one, marks=pytest.mark.proof) for one in ((14, 9), (28, 18)))]
)
LIGHTS = ("daytime", "low_light")
SECOND = {"daytime": "driver_eye", "low_light": "taillight"}
STARTS = {"daytime": "2026-05-03T08:10:00", "low_light": "2026-05-03T21:05:00"}
SIGMA_PX = 0.7
HIDDEN_ONE_IN = 7
# category: share, roof, eye, lower edge of the taillight, metres
FLEET = {
    "hatchback": (0.45, 1.47, 1.16, 0.72),
    "saloon": (0.20, 1.44, 1.13, 0.76),
    "suv": (0.25, 1.66, 1.38, 0.86),
    "van": (0.10, 1.92, 1.60, 0.80),
}


@dataclass(frozen=True)
class True_:
    """One vehicle as it is: its direction, how far away it passes and its heights, metres."""

    number: int
    lighting: str
    category: str
    direction: str
    distance_m: float
    heights_m: dict[str, float]


def fleet(sizes: tuple[int, ...]) -> list[True_]:
    """Vehicles of a seeded fleet, 2 to 5 m from the camera."""
    rng = np.random.default_rng(20261122)
    made = []
    for lighting, count in zip(LIGHTS, sizes, strict=True):
        for _ in range(count):
            shares = [share for share, *_ in FLEET.values()]
            category = str(rng.choice(list(FLEET), p=shares))
            _, roof, eye, lamp = FLEET[category]
            roof = round(roof + rng.normal(0.0, 0.04), 3)
            heights = {"roof": roof, "driver_eye": eye + rng.normal(0.0, 0.045)}
            heights["taillight"] = lamp + rng.normal(0.0, 0.05)
            direction = str(rng.choice(["left", "right"]))
            made.append(
                True_(len(made) + 1, lighting, category, direction, float(rng.uniform(2.0, 5.0)), heights)
            )
    return made


def seen(x_m: float, depth_m: float, z_m: float) -> tuple[float, float]:
    """Where a point appears: a pinhole of 150 px, level, 1.5 m above the road, in the middle of 320 x 240."""
    return 159.5 + 150.0 * x_m / depth_m, 119.5 - 150.0 * (z_m - 1.5) / depth_m


class Study:
    """The work of a study, done by requests alone; only the road pose is stored past the API."""

    def __init__(self, operator: Client, reviewer: Client, services: Services, folder: Path) -> None:
        self.operator, self.reviewer = operator, reviewer
        self.services, self.folder = services, folder
        self.rng = np.random.default_rng(7)
        self.sizes: tuple[int, ...] = ()
        self.survey_id = 0
        self.recordings: dict[str, int] = {}
        self.insets: dict[str, Any] = {}

    def set_up(self, work: Callable[[], list[Job]], sizes: tuple[int, ...]) -> None:
        """The survey with its sides, targets, place and quotas; a recording by day and one in low light."""
        self.sizes = sizes
        sides = {"traffic_side": "right", "steering_side": "left", "camera_place": "verge"}
        place = {"latitude_deg": 49.44, "longitude_deg": 1.1, "time_zone": "Europe/Paris"}
        made = self.operator.made(
            "/surveys",
            {"name": "Protocol", "site": "lane 1", "open_to_all": True, "traffic": sides, "place": place},
        )
        self.survey_id, self.insets = made["id"], made["insets"]
        quotas = [{"lighting": one, "wanted": n} for one, n in zip(LIGHTS, sizes, strict=True)]
        change = {"name": made["name"], "site": "lane 1", "version": 1, "sampling": {"quotas": quotas}}
        assert self.operator.put(f"/surveys/{self.survey_id}", change).status_code == 200
        ground = None
        for n, lighting in enumerate(LIGHTS):
            path = self.folder / f"{lighting}.mp4"
            write_mp4(path, (painted(k + 20 * n, FRAME_WIDTH, FRAME_HEIGHT) for k in range(12)), 25)
            recording = upload(self.operator, self.survey_id, path)
            assert {job.state for job in work()} == {"done"}
            if ground is None:
                ground = lay_ground(self.services, self.survey_id, recording)
            else:
                add_pose(self.services, recording, ground.calibration_id, flat_camera())
            start = {"local": STARTS[lighting], "time_zone": "Europe/Paris"}
            facts = {"lighting": lighting, "start": start, "camera_id": ground.camera_id}
            assert self.operator.put(f"/recordings/{recording}", facts).status_code == 200
            self.recordings[lighting] = recording

    def measure(self, true: True_) -> dict[str, dict[str, Any]]:
        """A vehicle marked, clicked on and judged; its stored measurements by target."""
        frame = true.number % 8
        known = {
            **{"first_frame": frame, "last_frame": frame + 2, "make": "Invented", "model": true.category},
            **{"category": true.category, "direction": true.direction},
            **{"manufacturer_height_m": true.heights_m["roof"], "u_manufacturer_height_m": 0.0},
        }
        car = self.operator.made(f"/recordings/{self.recordings[true.lighting]}/vehicles", known)
        stored = {}
        for target in ("roof", SECOND[true.lighting]):
            if target == "driver_eye" and true.number % HIDDEN_ONE_IN == 0:
                unseen = {"driver_eye_not_visible": "glare", "version": car["version"]}
                answer = self.operator.put(f"/vehicles/{car['id']}", unseen)
                assert answer.status_code == 200, answer.text
                continue
            stored[target] = self._clicked(car["id"], true, target, frame)
        return stored

    def _clicked(self, vehicle_id: int, true: True_, target: str, frame: int) -> dict[str, Any]:
        # looking across from the right verge, who goes to the left has the wheel on the near side
        side = "near" if true.direction == "left" else "far"
        usual = self.insets[f"driver_eye_{side}" if target == "driver_eye" else target]
        inset_m = usual["inset_m"] + self.rng.normal(0.0, usual["u_inset_m"])
        points = (
            seen(-0.8, true.distance_m, 0.0),
            seen(0.1, true.distance_m + inset_m, true.heights_m[target]),
        )
        contact, point = ([float(c + self.rng.normal(0.0, SIGMA_PX)) for c in one] for one in points)
        body = {
            "client_key": str(UUID(int=int(self.rng.integers(2**62)), version=4)),
            **{"target": target, "frame": frame, "contact": contact, "target_point": point},
            "sigma_px": SIGMA_PX,
        }
        made: dict[str, Any] = self.operator.made(f"/vehicles/{vehicle_id}/measurements", body)
        verdict = {"revision": 1, "verdict": "accepted"}
        self.reviewer.made(f"/measurements/{made['id']}/reviews", verdict)
        return made

    def package(self, work: Callable[[], list[Job]], place: Path, **chosen: Any) -> Path:
        """A package built by the API and unpacked."""
        self.operator.made(f"/surveys/{self.survey_id}/exports", chosen)
        assert [one.state for one in work()] == ["done"]
        made = self.operator.seen(f"/surveys/{self.survey_id}/exports")[0]
        with zipfile.ZipFile(io.BytesIO(self.operator.http.get(made["url"]).content)) as archive:
            archive.extractall(place)
        return place


@pytest.mark.once
@pytest.mark.parametrize("sizes", STUDIES)
def test_a_study_is_made_by_the_api_and_agrees_with_its_fleet(
    sizes: tuple[int, ...],
    operator: Client,
    reviewer: Client,
    services: Services,
    work: Callable[[], list[Job]],
    tmp_path: Path,
) -> None:
    study = Study(operator, reviewer, services, tmp_path)
    study.set_up(work, sizes)
    truth = fleet(sizes)
    stored = [study.measure(one) for one in truth]

    errors = _errors(truth, stored)
    for target, found in errors.items():
        error, u = found.T
        n = len(error)
        print(
            f"{target}: n {n}, bias {1000 * error.mean():+.1f} mm, SD {1000 * error.std(ddof=1):.1f} mm, "
            f"within U95 {100 * np.mean(np.abs(error) < 1.96 * u):.1f} %"
        )
        assert np.abs(error.mean()) < 4.0 * np.sqrt(np.mean(u**2) / n)
        assert np.mean(np.abs(error) < 1.96 * u) > 0.95 - 4.0 * np.sqrt(0.95 * 0.05 / n)
        assert 0.5 < np.sqrt(np.mean((error / u) ** 2)) < 1.0 + 4.0 / np.sqrt(2 * n)

    _sample(study)
    _statistics(study, truth, errors)
    _packages(study, truth, work, tmp_path)


def _errors(truth: list[True_], stored: list[dict[str, Any]]) -> dict[str, Any]:
    """By target measured minus true height and its u, (N, 2)."""
    found: dict[str, list[tuple[float, float]]] = {}
    for one, mine in zip(truth, stored, strict=True):
        for target, made in mine.items():
            assert made["status"] == "ok", made["reason"]
            assert made["filmed_at"].startswith(
                "2026-05-03T08:10" if one.lighting == "daytime" else "2026-05-03T21:05"
            )
            if target == "driver_eye":
                assert made["side"] == ("near" if one.direction == "left" else "far")
            error = made["height_m"] - one.heights_m[target]
            found.setdefault(target, []).append((error, made["u_height_m"]))
    return {target: np.array(pairs) for target, pairs in found.items()}


def _sample(study: Study) -> None:
    """Every quota is full: an eye that cannot be seen is an answer."""
    found = study.operator.seen(f"/surveys/{study.survey_id}/sample")
    assert [(one["lighting"], one["wanted"]) for one in found["quotas"]] == list(
        zip(LIGHTS, study.sizes, strict=True)
    )
    answered = [one for one in found["response"] if one["target"] is None and one["class_set"] == "all"]
    by_light = {one["lighting"]: one for one in answered}
    for lighting, count in zip(LIGHTS, study.sizes, strict=True):
        assert by_light[lighting]["passes"] == count
        assert by_light[lighting]["open"] == 0
    hidden = sum(n % HIDDEN_ONE_IN == 0 for n in range(1, study.sizes[0] + 1))
    eyes = next(
        one
        for one in found["response"]
        if (one["lighting"], one["target"], one["class_set"]) == ("daytime", "driver_eye", "all")
    )
    assert (eyes["measured"], eyes["not_visible"]) == (study.sizes[0] - hidden, hidden)


def _statistics(study: Study, truth: list[True_], errors: dict[str, Any]) -> None:
    found = study.operator.seen(f"/statistics?survey={study.survey_id}&rounding=none")
    by_day, in_low_light = study.sizes
    assert found["counted"]["vehicles"] == by_day + in_low_light
    groups = {one["group"]: one for one in found["errors"]["groups"]}
    roofs = errors["roof"][:, 0]
    for group, mine in (("daytime", roofs[:by_day]), ("low_light", roofs[by_day:]), ("overall", roofs)):
        assert groups[group]["n"] == len(mine)
        assert groups[group]["figures"]["mae_m"]["value"] == pytest.approx(np.abs(mine).mean(), abs=2e-6)
    eyes = next(one for one in found["targets"] if one["target"] == "driver_eye")
    true = [one.heights_m["driver_eye"] for one in truth if one.lighting == "daytime"]
    true = [h for n, h in enumerate(true, start=1) if n % HIDDEN_ONE_IN]
    assert eyes["corrected"]["mean_m"] == pytest.approx(np.mean(true), abs=4 * 0.02 / np.sqrt(len(true)))
    at_night = study.operator.seen(f"/statistics?survey={study.survey_id}&lighting=low_light")
    assert at_night["counted"]["vehicles"] == in_low_light
    assert (
        study.operator.seen(f"/statistics?survey={study.survey_id}&filmed_to=2026-05-02")["counted"][
            "vehicles"
        ]
        == 0
    )


def _packages(study: Study, truth: list[True_], work: Callable[[], list[Job]], folder: Path) -> None:
    whole = study.package(work, folder / "whole", crops=len(truth) < 100)
    assert len(rows(whole, "vehicles.csv")) == len(truth)
    report = " ".join(words((whole / "report.pdf").read_bytes()).split())
    assert "2026-05-03 08:10 to 21:05 (Europe/Paris)" in report
    checked = verify_package(FolderFiles(whole))
    assert checked.ok, checked.problem
    chosen = {"lighting": "low_light", "class_sets": ["passenger_cars"]}
    limited = study.package(work, folder / "limited", crops=False, **chosen)
    kept = [one for one in truth if one.lighting == "low_light" and one.category != "van"]
    error = rows(limited, "statistics/error_table.csv")
    assert {row["n"] for row in error if row["group"] == "overall"} == {str(len(kept))}
    checked = verify_package(FolderFiles(limited))
    assert checked.ok, checked.problem
