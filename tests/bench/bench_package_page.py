"""How long a package's page takes: `python tests/bench/bench_package_page.py [PACKAGE [COUNT]]`, in Chromium.

The measurements of a package (of a small demonstration unless told) are repeated until there are COUNT
(10,000), each with its budget and with an event of its own in a chain that is hashed anew, but neither sealed
nor signed, which the page says. It is opened from its folder. Asked: the first rows within 3 s. Rows that
repeat pack better than real ones.
"""

from __future__ import annotations

import csv
import io
import shutil
import sys
import tempfile
from itertools import count as numbers
from itertools import cycle, islice
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from playwright.sync_api import sync_playwright

from sightline.export.package_tables import tables_of
from sightline.export.page import write_audit_script, write_page
from sightline.infra.csv_package.files import FolderFiles, Staging, read_rows, sum_of
from tests.browser.conftest import chromium_path
from tests.load.hostile.run import package_in
from tests.support.packages import rehash

GOAL_S, COUNT = 3.0, 10_000
Rows = list[dict[str, str]]


def written(place: Path, name: str, rows: Rows) -> None:
    out = io.StringIO()
    writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n", extrasaction="ignore")
    writer.writeheader()
    writer.writerows(rows)
    (place / name).write_text(out.getvalue(), encoding="utf-8")


def enlarged(place: Path, count: int) -> None:
    """The package with `count` measurements; statistics and pictures stay those of the small one."""
    files = FolderFiles(place)
    measured = list(read_rows(files, "tables/measurements.csv"))
    events = list(read_rows(files, "audit.csv"))
    of_id: dict[str, dict[str, str]] = {
        row["entity_id"]: row for row in events if row["entity"] == "measurement"
    }
    parts: dict[str, Rows] = {}
    for row in read_rows(files, "tables/budget.csv"):
        parts.setdefault(row["measurement_id"], []).append(row)
    table: Rows = []
    budget: Rows = []
    chain: Rows = [row for row in events[:-1] if row["entity"] != "measurement"]
    for id_, row in zip(numbers(1), islice(cycle(measured), count), strict=False):
        table.append({**row, "id": str(id_)})
        budget += [{**part, "measurement_id": str(id_)} for part in parts.get(row["id"], [])]
        chain.append({**of_id[row["id"]], "entity_id": str(id_)})
    for number, event in enumerate(chain, start=1):
        event["number"] = str(number)
    written(place, "tables/measurements.csv", table)
    written(place, "tables/budget.csv", budget)
    written(place, "audit.csv", rehash([*chain, {**events[-1], "number": str(len(chain) + 1)}], 1))


def main(package: Path, count: int) -> int:
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as started:
        place = Path(shutil.copytree(package, Path(folder) / "package"))
        enlarged(place, count)
        staging = Staging(place)
        staging.written = {path: sum_of(staging.files(), path) for path in staging.files().paths}
        write_page(staging, tables_of(2), "en")
        write_audit_script(staging)
        sizes = [staging.written[name].size / 1e6 for name in ("index.html", "audit.js", "audit.csv")]
        browser = started.chromium.launch(
            executable_path=chromium_path(), args=["--no-sandbox", "--disable-gpu"]
        )
        page = browser.new_page()
        start = perf_counter()
        page.goto(f"file://{place}/index.html")
        page.wait_for_selector("[data-measurement]")
        shown_s = perf_counter() - start
        page.wait_for_selector('html[data-checked="true"]', timeout=120_000)
        checked_s = perf_counter() - start
        for one in page.locator("[data-check]").all():
            print(f"  {one.get_attribute('data-state')}: {one.inner_text()}")
        browser.close()
    print(
        f"page of {count} measurements ({sizes[0]:.1f} MB, audit.js {sizes[1]:.1f} MB for a chain of "
        f"{sizes[2]:.1f} MB): shown in {shown_s:.2f} s, asked {GOAL_S} s; all checked in {checked_s:.2f} s",
        flush=True,
    )
    return 0


if __name__ == "__main__":
    chosen, number = (*sys.argv[1:], *("", str(COUNT))[len(sys.argv) - 1 :])
    with tempfile.TemporaryDirectory() as made:
        sys.exit(main(Path(chosen) if chosen else package_in(Path(made)), int(number)))
