"""From live lines of the demonstration's cameras to the live page, a vehicle's bench and its evidence."""

from __future__ import annotations

import json
import re
import subprocess
import threading
import time
from pathlib import Path

import numpy as np
from playwright.sync_api import Page, expect

from sightline.export.evidence.page import read_page
from sightline.export.evidence.verify import verify_evidence
from sightline.media.strips.stored_reader import StripReader
from tests.simulation.make import SITE
from tests.support.waiting import NEVER_S

from .server import SIGHTLINE, Server

FASTER = 4  # than the cameras were


def lines_of_the_demonstration(page: Page, server: Server, survey_id: int) -> bytes:
    scan = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    strips = []
    for sign in (scan["tiles_version"][:8], scan["tiles_version"][8:]):
        (path,) = server.data_dir.rglob(f"{sign}*.strip.tif")
        reader = StripReader(path)
        strips.append(reader.read(0, reader.lines))
    return np.stack(strips, axis=1).astype(np.uint8).tobytes()


def test_from_a_live_stream_to_an_evidence_file(
    page: Page, demonstration: Server, survey_id: int, screenshots: Path, tmp_path: Path
) -> None:
    lines = lines_of_the_demonstration(page, demonstration, survey_id)
    made = page.request.post("/api/surveys", data={"name": "Live road"}, headers={"X-Sightline": "1"}).json()
    page.goto(f"/surveys/{made['id']}/scans")
    page.get_by_role("link", name="Live", exact=True).click()
    expect(page.get_by_text("No stream yet")).to_be_visible()
    command = page.locator(".live-command").first
    expect(command).to_contain_text(
        f"sightline stream --rows 1024 --baseline 0.5 --line-rate 5000 --survey {made['id']}"
    )
    page.screenshot(path=screenshots / "live-empty.png")

    options = ["--rows", str(SITE.rows), "--baseline", str(SITE.baseline_m)]
    options += ["--line-rate", str(SITE.line_rate_hz), "--u-baseline", "0.0003"]
    options += ["--survey", "Live road", "--data-dir", str(demonstration.data_dir)]
    with subprocess.Popen(
        [str(SIGHTLINE), "stream", *options],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as stream:
        sender = threading.Thread(target=send, args=(stream, lines))
        sender.start()
        expect(page.get_by_test_id("live-vehicle-1")).to_contain_text("km/h")
        expect(page.get_by_text("recording", exact=True)).to_be_visible()
        expect(page.get_by_role("heading", name="Lines from a pipe")).to_be_visible()
        expect(page.get_by_test_id("live-health")).to_contain_text("0 / 0")
        expect(page.get_by_test_id("live-vehicle-3")).to_be_visible(timeout=120_000)
        page.screenshot(path=screenshots / "live.png")
        page.set_viewport_size({"width": 1024, "height": 768})
        page.screenshot(path=screenshots / "live-1024.png")
        page.set_viewport_size({"width": 1440, "height": 900})
        sender.join()
        said, problems = stream.communicate(timeout=NEVER_S)
    assert stream.returncode == 0, problems.decode()
    told = said.decode().splitlines()
    assert len(told) == 9

    expect(page.get_by_text("ended", exact=True)).to_be_visible()
    expect(page.get_by_test_id("live-vehicle-9")).to_be_visible()
    link = page.get_by_test_id("live-vehicle-3").get_by_role("link")
    expect(link).to_be_visible(timeout=120_000)
    page.screenshot(path=screenshots / "live-ended.png")
    link.click()
    expect(page).to_have_url(re.compile(r"scan\?scan=\d+&vehicle=\d+"))
    expect(page.get_by_test_id("scan-speed")).to_contain_text("km/h")
    expect(page.get_by_test_id("strips")).to_be_visible()
    page.screenshot(path=screenshots / "live-bench.png")

    page.get_by_role("button", name="Evidence file").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_text("Speed", exact=True).click()
    dialog.get_by_label("Limit: at most").fill("50")
    dialog.get_by_label("Source of the limit").fill("Sign at the entry")
    with page.expect_download() as file:
        dialog.get_by_role("button", name="Make the file").click()
    place = tmp_path / file.value.suggested_filename
    file.value.save_as(place)
    content = place.read_bytes()
    found = verify_evidence(content)
    assert found.ok, found.problems
    measured, as_told = read_page(content).document["measurement"], json.loads(told[2])
    assert measured["speed_mps"] == as_told["speed_mps"] and measured["length_m"] == as_told["length_m"]
    assert measured["direction"] == "camera_1_first" and len(measured["axle_lines"]) == 2


def send(stream: subprocess.Popen[bytes], lines: bytes) -> None:
    assert stream.stdin is not None
    a_second = 2 * SITE.rows * round(SITE.line_rate_hz)
    for start in range(0, len(lines), a_second):
        stream.stdin.write(lines[start : start + a_second])
        stream.stdin.flush()
        time.sleep(1 / FASTER)
    stream.stdin.flush()
