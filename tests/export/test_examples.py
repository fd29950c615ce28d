"""The examples in docs/examples read a package, and find in it what the tables hold."""

import csv
import io
import shutil
import subprocess
import sys
from pathlib import Path
from statistics import median

import pytest

from tests.support.packages import ground, package, rows, worked

__all__ = ["ground", "package", "worked"]

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"
R = shutil.which("Rscript")


def run(*command: str | Path) -> list[dict[str, str]]:
    """What an example prints; warnings of either language are failures."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    return list(csv.DictReader(io.StringIO(done.stdout)))


def quantile(heights: list[float], share: float) -> float:
    """Type 8 of Hyndman and Fan 1996, by their formula."""
    place = share * (len(heights) + 1 / 3) + 1 / 3
    low = min(max(int(place), 1), len(heights))
    high = min(low + 1, len(heights))
    part = min(max(place - low, 0.0), 1.0)
    return sorted(heights)[low - 1] * (1 - part) + sorted(heights)[high - 1] * part


def expected(place: Path) -> list[dict[str, str]]:
    found: dict[str, list[dict[str, str]]] = {}
    for row in rows(place, "measurements.csv"):
        if row["verdict"] in ("accepted", "fixed") and (row["status"], row["withdrawn"]) == ("ok", "false"):
            found.setdefault(row["target"], []).append(row)
    assert found, "the package has accepted heights"
    told = []
    for target, group in sorted(found.items()):
        heights = [float(row["height_m"]) for row in group]
        figures = {f"p{p}_m": f"{quantile(heights, p / 100):.4f}" for p in (15, 50, 85)}
        u95 = f"{median(float(row['U95_height_m']) for row in group):.4f}"
        told.append({"target": target, "count": str(len(group)), **figures, "median_U95_m": u95})
    return told


def test_pandas_reads_a_package(package: Path) -> None:
    assert run(sys.executable, EXAMPLES / "read_package.py", package) == expected(package)


@pytest.mark.skipif(R is None, reason="R is not installed (sudo apt install r-base-core)")
def test_r_reads_a_package(package: Path) -> None:
    assert run(str(R), "--vanilla", EXAMPLES / "read_package.R", package) == expected(package)
