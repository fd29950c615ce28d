"""Keeps a package of the present version, to be verified by every later one (test_released.py).

Run at each landing that changes what packages hold, from a clean checkout with its pages built:

    python -m pytest tests/export/keep_released.py

It writes `released/VERSION.tar.xz` beside this file: a survey with every kind of work on video, heights in
line scans computed again and put back, and a rig that is calibrated. The file is not collected with the
tests.
"""

import io
import tarfile
from collections.abc import Callable
from pathlib import Path

from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.infra.version import code_version
from tests.scans.test_rig_calibrations import table
from tests.scans.test_scan_again import LARGE, SMALL, again, click, in_survey, judge, rod, say_inset, undo
from tests.support import scans_samples
from tests.support.app import Client
from tests.support.ground import Ground
from tests.support.packages import ground, worked, written

__all__ = ["ground", "worked"]

KEPT = Path(__file__).with_name("released")
_MOST_BYTES = 600_000


def test_keep(
    operator: Client,
    reviewer: Client,
    worked: Ground,
    services: Services,
    work: Callable[[], list[Job]],
    tmp_path: Path,
) -> None:
    version = code_version()
    assert "dirty" not in version and "unknown" not in version, "keep a package of a commit"
    survey_id = worked.survey_id
    with services.writing() as session:
        scanned = scans_samples.measured(session, in_survey(survey_id))
    operator.put(f"/scans/{scanned.scan_id}/line-pose", rod())
    lane = {"distance_m": 5.5, "u_distance_m": 0.1, "version": _version(operator, scanned.scan_id)}
    rig = operator.post(f"/scans/{scanned.scan_id}/rig-calibrations", params=lane, **table())
    assert rig.status_code == 201, rig.text
    one = click(operator, scanned.vehicle_id)
    judge(reviewer, one, "accepted")
    say_inset(operator, survey_id, SMALL)
    again(operator, survey_id, work)
    say_inset(operator, survey_id, LARGE)
    undo(operator, again(operator, survey_id, work)["computing_id"], work)
    place = written(services, survey_id, tmp_path / "export")
    assert (place / "index.html").is_file(), "build the pages first"
    target = KEPT / f"{version}.tar.xz"
    target.write_bytes(packed(place))
    assert target.stat().st_size < _MOST_BYTES


def _version(client: Client, scan_id: int) -> int:
    version: int = client.seen(f"/scans/{scan_id}")["version"]
    return version


def packed(place: Path) -> bytes:
    """The folder as a .tar.xz, whose bytes follow from the files alone."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w:xz", preset=9) as archive:
        for path in sorted(path for path in place.rglob("*") if path.is_file()):
            entry = tarfile.TarInfo(path.relative_to(place).as_posix())
            entry.size = path.stat().st_size
            archive.addfile(entry, io.BytesIO(path.read_bytes()))
    return out.getvalue()
