"""A small line-scan recording for the tests: simulated traffic, uploaded as two TIFF files."""

import base64
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import tifffile

from sightline.infra.services import Services
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, ScanTruth, traffic, truths
from tests.support.app import TUS, Client, error_of, send
from tests.support.working import run_jobs

SITE = ScanSite(rows=64, line_rate_hz=2441.4, misalignment_px=0.4)
RIG = {"baseline_m": SITE.baseline_m, "line_rate_hz": SITE.line_rate_hz, "u_baseline_m": 0.0003}


@cache
def pictures(count: int = 3) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any], tuple[ScanTruth, ...]]:
    """Both strips (lines, rows) of a few vehicles, and what is true of them."""
    cars = traffic(5, count, speeds_mps=(14.0, 24.0))
    first, second = strips(SITE, cars)
    return first, second, truths(SITE, cars)


def upload_strip(client: Client, survey_id: int, content: bytes, name: str) -> int:
    """Upload a strip whole; the id of its upload."""
    told = {"filename": name, "purpose": "strip"}
    metadata = ",".join(f"{key} {base64.b64encode(value.encode()).decode()}" for key, value in told.items())
    headers = {**TUS, "Upload-Length": str(len(content)), "Upload-Metadata": metadata}
    made = client.http.post(f"/api/surveys/{survey_id}/uploads", headers=headers)
    assert made.status_code == 201, error_of(made)
    location = made.headers["Location"]
    answer = send(client, location, 0, content)
    assert answer.status_code == 204 and "Sightline-Recording" not in answer.headers
    return int(location.rsplit("/", 1)[1])


def tiff(path: Path, lines: np.ndarray[Any, Any]) -> bytes:
    """A strip as a file with time along its width."""
    tifffile.imwrite(path, np.ascontiguousarray(lines.T), compression="zstd")
    return path.read_bytes()


def uploads(client: Client, survey_id: int, folder: Path) -> dict[str, int]:
    """Both strips uploaded."""
    first, second, _ = pictures()
    return {
        "first_upload": upload_strip(client, survey_id, tiff(folder / "a.tif", first), "gate-1.tif"),
        "second_upload": upload_strip(client, survey_id, tiff(folder / "b.tif", second), "gate-2.tif"),
    }


def add_scan(operator: Client, services: Services, survey_id: int, folder: Path) -> int:
    """The recording taken in and its vehicles measured; its id."""
    made = operator.made(
        f"/surveys/{survey_id}/scans", {**RIG, **uploads(operator, survey_id, folder), "name": "Gate"}
    )
    assert (made["state"], made["job"]["kind"], made["lines"]) == ("reading", "scan_read", None)
    for _ in range(2):
        assert {job.state for job in run_jobs(services)} == {"done"}
    return int(made["id"])
