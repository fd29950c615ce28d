"""The page of a study in Chromium: `python tests/bench/bench_study_page.py [HEIGHTS]`, seconds.

A survey of so many heights (1e6) on a SQLite of its own; the study of it is computed once, as its job does,
and its page then opened: until its percentiles are there, and until its first figure is drawn. Goal: 3 s.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.infra.database.engine import make_engine, migrate, session_factory
from sightline.infra.services import open_services
from sightline.settings import Settings
from sightline.studies.records import StudyFacts, StudySurvey
from sightline.studies.store import create_study
from sightline.studies.stored import ask_to_compute
from tests.bench.seed import seed
from tests.bench.web_ground import chromium, serving, sign_in_link
from tests.support.working import run_jobs

_GOAL_S = 3.0
SEEDED = "olga@example.org"  # one of the people whom the seed brings
FLEET_CSV = "category,share\nhatchback,0.4\nsaloon,0.2\nsuv,0.3\nvan,0.1\n"


def computed(folder: Path, count: int) -> None:
    """The study of a seeded survey, computed; says how long that took."""
    engine = make_engine(Settings(data_dir=folder).database_url)
    migrate(engine)
    survey_id = seed(session_factory(engine), count).survey.id
    engine.dispose()
    services = open_services(Settings(data_dir=folder))
    with services.writing() as session:
        facts = StudyFacts("A million", surveys=(StudySurvey(survey_id, "Hill"),), fleet_csv=FLEET_CSV)
        study = create_study(session, facts, actor=None)
        ask_to_compute(session, study.id, actor=None)
    begun = time.perf_counter()
    (job,) = run_jobs(services)
    took = time.perf_counter() - begun
    services.close()
    assert job.result is not None, job.error
    print(f"{job.result['heights']} heights count: computed with package and report in {took:.1f} s")


def main(count: int) -> int:
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as name, chromium() as browser:
        folder = Path(name)
        computed(folder, count)
        with serving("serve", folder) as server:
            page = browser.new_context(base_url=server.url).new_page()
            page.goto(sign_in_link(folder, SEEDED))
            page.wait_for_url(lambda address: "sign-in" not in address)
            page.goto("/studies", wait_until="networkidle")
            begun = time.perf_counter()
            page.get_by_role("link", name="A million").click()
            page.get_by_test_id("study-percentiles").wait_for(timeout=120_000)
            table = time.perf_counter() - begun
            page.locator("[data-testid^=figure-] svg").first.wait_for(timeout=120_000)
            figure = time.perf_counter() - begun
    load = os.getloadavg()[0]
    print(
        f"page: {table:.2f} s to the table, {figure:.2f} s to a figure (goal {_GOAL_S:.0f}); load {load:.1f}"
    )
    return int(figure > _GOAL_S)


if __name__ == "__main__":
    sys.exit(main(int(float(sys.argv[1])) if len(sys.argv) > 1 else 1_000_000))
