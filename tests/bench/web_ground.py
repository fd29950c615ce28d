"""The ground of bench_web: a demonstration survey, a server on it, a session, clips in 1080p and 4K."""

from __future__ import annotations

import json
import os
import shutil
import sqlite3
import statistics
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from bench_media import Draw
from playwright.sync_api import Browser, sync_playwright

from sightline.demo.made import TRUTH
from sightline.infra.services import open_services
from sightline.media.video.writer import write_mp4
from sightline.people.service import FIRST_ADMIN, new_sign_in_link
from sightline.settings import Settings
from tests.browser.conftest import chromium_path
from tests.browser.server import Server, start
from tests.real.client import Client

CLIP_RATE, CLIP_GOP = 25, 250
_DATABASES = (".db", ".db-wal", ".db-shm")


def prepare(folder: Path) -> float | None:
    """A finished demonstration in `folder`: a copy of SIGHTLINE_BENCH_DATA, else made; seconds it took."""
    given = os.environ.get("SIGHTLINE_BENCH_DATA")
    if given:
        _copy(Path(given), folder)
        return None
    started = time.perf_counter()
    with serving("demo", folder) as server:
        client = signed_in(server, folder)
        while not client.get("/session").get("demo_survey_id"):
            time.sleep(0.1)
        return time.perf_counter() - started


def _copy(source: Path, target: Path) -> None:
    """The data folder as a server may have it open just now; without what it only keeps for speed."""
    shutil.copytree(
        source,
        target,
        dirs_exist_ok=True,
        ignore=lambda _, names: [
            name for name in names if name in ("cache", "scratch") or name.endswith(_DATABASES)
        ],
    )
    with (
        closing(sqlite3.connect(source / "sightline.db")) as here,
        closing(sqlite3.connect(target / "sightline.db")) as there,
    ):
        here.backup(there)


@contextmanager
def serving(command: str, folder: Path) -> Iterator[Server]:
    """`sightline COMMAND` while the block runs."""
    server = start(command, folder)
    try:
        server.wait(120)
        yield server
    finally:
        server.stop()


def cold_starts(folder: Path, count: int = 3) -> list[float]:
    """Seconds from the command to the first answer, each."""
    found = []
    for _ in range(count):
        started = time.perf_counter()
        with serving("serve", folder):
            found.append(time.perf_counter() - started)
            time.sleep(1)  # the worker starts too, and ends in order
    return found


def sign_in_link(folder: Path, email: str = FIRST_ADMIN[1]) -> str:
    """A fresh one-time link, for the admin if nobody is named."""
    services = open_services(Settings(data_dir=folder))
    try:
        return new_sign_in_link(services, email)
    finally:
        services.close()


def signed_in(server: Server, folder: Path) -> Client:
    """A client of the API with the admin's session."""
    client = Client(server.url)
    client.sign_in(sign_in_link(folder))
    return client


def clip_recording(
    client: Client, survey_id: int, folder: Path, size: tuple[int, int], count: int, draw: Draw
) -> int:
    """The id of an ingested recording of so many pixels and frames with a key frame every ten seconds."""
    path = folder / f"bench-{draw.__name__}-{size[1]}p.mp4"
    write_mp4(path, draw(count, *size), CLIP_RATE, crf=23, gop=CLIP_GOP)
    recording_id = client.upload(survey_id, path)
    client.ready(recording_id)
    return recording_id


def measurable(vehicles: list[dict[str, Any]]) -> list[tuple[int, dict[str, Any]]]:
    """(number, frame of the truth) of vehicles with contact and all targets in sight, driver near."""
    document = json.loads(TRUTH.read_text())["scenes"]
    wanted = {"contact_rear", "roof", "driver_eye", "taillight"}
    open_ = {one["number"] for one in vehicles if one["state"] == "to_do"}
    found = []
    for one in document["day"]["passes"]:
        whole = [f for f in one["frames"] if wanted <= set(f["pixels"]) and not wanted & set(f["hidden"])]
        if whole and one["number"] in open_:
            best = min(whole, key=lambda f: abs(f["frame"] - one["best_frame"]))
            found.append((int(one["number"]), best))
    return found


@contextmanager
def chromium() -> Iterator[Browser]:
    """The browser of the tests."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium_path(), args=["--no-sandbox", "--disable-gpu"]
        )
        try:
            yield browser
        finally:
            browser.close()


def median_ms(seconds: list[float]) -> float:
    """Median in ms."""
    return 1000 * statistics.median(seconds)
