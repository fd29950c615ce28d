"""Lists of a survey of 100,000 heights: `python tests/bench/bench_lists.py [COUNT]`; milliseconds of each.

Every GET that names the survey, its recording or one of its vehicles, asked as the pages ask it, of an app in
this process: the fastest of three, and the size of the answer. Goals: 300 ms each, the review queue 100 ms.
`SIGHTLINE_BENCH_DATABASE_URL` for PostgreSQL.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from fastapi.testclient import TestClient  # noqa: E402

from sightline.app import create_app  # noqa: E402
from sightline.infra.database.engine import migrate  # noqa: E402
from sightline.infra.services import open_services  # noqa: E402
from sightline.people.store import create_sign_in_link  # noqa: E402
from sightline.settings import Settings  # noqa: E402
from tests.bench.seed import seed  # noqa: E402
from tests.people.test_roles import MATRIX  # noqa: E402
from tests.support.samples import Sample  # noqa: E402

LIMIT_MS, QUEUE_LIMIT_MS = 300.0, 100.0


def questions(one: Sample) -> Iterator[str]:
    """The addresses of all lists and pages of what the seed made."""
    known = {
        "survey_id": one.survey.id,
        "recording_id": one.recording.id,
        "vehicle_id": one.vehicle.id,
        "camera_id": one.camera.id,
    }
    for route in MATRIX:
        method, path = route.split(" ", 1)
        named = {part[1:-1] for part in path.split("/") if part.startswith("{")}
        if method == "GET" and named and named <= set(known):
            yield path.format(**known)


def asked(http: TestClient, path: str) -> tuple[int, float, int]:
    """Status, milliseconds of the fastest of three, bytes."""
    took: list[float] = []
    for _ in range(3):
        begun = time.perf_counter()
        answer = http.get(f"/api{path}")
        took.append(1e3 * (time.perf_counter() - begun))
    return answer.status_code, min(took), len(answer.content)


def main(count: int) -> int:
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as name:
        folder = Path(name)
        url = os.environ.get("SIGHTLINE_BENCH_DATABASE_URL", f"sqlite:///{folder / 'sightline.db'}")
        services = open_services(Settings(data_dir=folder, database_url=url))
        migrate(services.engine)
        one = seed(services.sessions, count)
        with services.writing() as session:
            token = create_sign_in_link(session, one.olga.id, actor=None)
        app = create_app(services=services)
        http = TestClient(app, headers={"X-Sightline": "1", "Accept-Encoding": "gzip"})
        http.post("/api/session/link", json={"token": token}).raise_for_status()
        missed = total = 0
        for path in questions(one):
            status, ms, size = asked(http, path)
            late = status == 200 and ms > (QUEUE_LIMIT_MS if "review" in path else LIMIT_MS)
            missed, total = missed + late, total + 1
            said = f"{ms:8.1f} ms {size:10,d} bytes  {status}  {path}"
            print(said + ("   <-- missed" if late else ""), flush=True)
        print(f"{count:,d} measurements, {services.engine.dialect.name}: {missed} of {total} missed")
        services.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 100_000))
