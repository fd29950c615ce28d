"""The rig calibrated in a real browser: passes typed or dropped, looked at, put in force, taken back."""

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.linescan.test_rig_calibration import STANDS_M, Errors, by_board, planes

from .waits import keep_toasts, wait_until

NAMES = ("distance_m", "width_m", "u_width_m", "front_line_1", "rear_line_1", "front_line_2", "rear_line_2")


def seen(page: Page, scan_id: int) -> dict[str, Any]:
    found: dict[str, Any] = page.request.get(f"/api/scans/{scan_id}").json()
    return found


@pytest.mark.usefixtures("kept")
def test_a_rig_is_calibrated_and_taken_back(page: Page, survey_id: int, screenshots: Path) -> None:
    keep_toasts(page)
    scan = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    before = scan["rig"]
    page.goto(f"/surveys/{survey_id}/scan?scan={scan['id']}")
    page.get_by_role("button", name="Rig…", exact=True).click()
    page.get_by_role("button", name="Calibrate the rig…").click()
    dialog = page.get_by_role("dialog", name="Calibrate the rig")

    # typed: positions along a tape; two rows are too few, and it says so
    expect(dialog).to_contain_text("Enter the distance to the vehicles")
    dialog.get_by_label("Distance to lane (near side of vehicles)").fill("5.5")
    dialog.get_by_text("Staff along a tape").click()
    for row, (away, second) in enumerate([("3", "1.5962"), ("3", "1.5958"), ("9", "1.6022")], 1):
        dialog.get_by_label(f"Pass {row}, Distance, m").fill(away)
        dialog.get_by_label(f"Pass {row}, At camera 1, m").fill("1")
        dialog.get_by_label(f"Pass {row}, At camera 2, m").fill(second)
        if row < 3:
            dialog.get_by_label(f"Pass {row}, u", exact=True).last.fill("0.001")
    dialog.get_by_role("button", name="Compute").click()
    answer = dialog.get_by_test_id("rig-answer")
    expect(answer).to_contain_text("2 usable passes are too few")
    expect(answer).to_contain_text("Row 4 is skipped. The value u_position_m is missing")
    put = dialog.get_by_role("button", name="Apply")
    expect(put).to_be_disabled()
    dialog.get_by_label("Pass 3, u", exact=True).last.fill("0.001")
    expect(answer).to_have_count(0)
    dialog.get_by_role("button", name="Compute").click()
    expect(answer).to_contain_text("Baseline at the lane, 5.50 m")
    expect(answer).to_contain_text("Two distances cannot test")
    page.screenshot(path=screenshots / "rig-calibration-typed.png")

    # a board's lines from a CSV
    rows = [",".join(NAMES)]
    for told in STANDS_M:
        one = by_board(planes(baseline=before["baseline_m"]), told, Errors(None))
        rows.append(",".join(str(getattr(one, name)) for name in NAMES))
    file = {"name": "board.csv", "mimeType": "text/csv", "buffer": "\n".join(rows).encode()}
    dialog.locator("input[type=file]").set_input_files(file)
    expect(answer).to_contain_text("4 degrees of freedom")
    answer.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "rig-calibration-1440.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "rig-calibration-1024.png")
    put.click()
    expect(dialog).to_have_count(0)
    after = seen(page, scan["id"])["rig"]
    assert after["baseline_correlation"] < -0.5 and abs(after["divergence_rad"] - 0.0021) < 1e-5
    assert after["line_rate_hz"] == before["line_rate_hz"]

    page.get_by_role("button", name="Undo", exact=True).last.click()
    names = (
        "distance_m",
        "baseline_m",
        "u_baseline_m",
        "divergence_rad",
        "u_divergence_rad",
        "baseline_correlation",
    )

    def rig() -> dict[str, Any]:
        return {name: seen(page, scan["id"])["rig"][name] for name in names}

    wait_until(page, lambda: rig() == {name: before[name] for name in names}, rig)

    # it stays in the history, and can be in force again
    page.reload()
    page.get_by_role("button", name="Rig…", exact=True).click()
    page.get_by_role("button", name="Calibrate the rig…").click()
    history = dialog.get_by_test_id("rig-history")
    expect(history).to_contain_text("6 passes")
    again = history.get_by_role("button", name="Use calibration 1")
    expect(again).to_be_disabled()
    dialog.get_by_label("Distance to lane (near side of vehicles)").fill("5.5")
    again.click()
    expect(dialog).to_have_count(0)
    assert seen(page, scan["id"])["rig"]["baseline_correlation"] == after["baseline_correlation"]
