"""Many people clicking at once: `make soak` (python -m tests.load.soak [--seconds S] [--clients 1,8]).

Starts the real server on a copy of a small demonstration and prints, for each number of clients, stored
clicks a second, their median and 99th percentile, what else was answered, and the processor time that the
server spent on a click; then the same with people who look at frames and lists beside. Every click is one
revision: audit, budget and all. The clicks are counted again in the database at the end: as many as were
acknowledged. `--postgresql` puts a PostgreSQL of its own in the place of SQLite, `--apps 2` two servers
before it, between which people are divided.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import secrets
import shutil
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Awaitable, Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from uuid import uuid4

import httpx2
from sqlalchemy import make_url, text

from sightline.infra.database.engine import make_engine
from tests.browser.conftest import made_once, make_survey
from tests.browser.server import Server, start
from tests.load.cluster import Cluster
from tests.load.light import Answer, Light

LATE = "1"


@dataclass
class Told:
    """What came back: seconds of each answer, and how many of which status."""

    took_s: list[float] = field(default_factory=list)
    statuses: Counter[int] = field(default_factory=Counter)
    said: Counter[str] = field(default_factory=Counter)

    def note(self, answer: Answer) -> None:
        self.statuses[answer.status_code] += 1
        if answer.status_code >= 500:
            self.said[answer.text[:200]] += 1

    def quantile(self, share: float) -> float:
        ordered = sorted(self.took_s)
        return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else float("nan")


@dataclass
class Ground:
    urls: tuple[str, ...]
    cookies: Any
    survey: int
    recording: dict[str, Any]
    server_pids: tuple[int, ...]
    pause_s: float


def signed_in(server: Server) -> tuple[Any, int]:
    """The first administrator's cookie, and the demonstration's survey."""
    with httpx2.Client(base_url=server.url, headers={"X-Sightline": "1"}, timeout=60) as http:
        token = server.sign_in_link().split("token=")[1]
        http.post("/api/session/link", json={"token": token}).raise_for_status()
        while not (survey := http.get("/api/session").json().get("demo_survey_id")):
            time.sleep(0.5)
        return dict(http.cookies), int(survey)


async def vehicle_of(http: Light, ground: Ground) -> dict[str, Any]:
    """A vehicle with one stored roof, for one client to click again and again."""
    recording = ground.recording["id"]
    wanted = {"first_frame": 1, "last_frame": 9}
    made = await http.ask("POST", f"/api/recordings/{recording}/vehicles", wanted)
    assert made.status_code == 201, made.text
    clicks = {"frame": 5, "contact": [320.0, 400.0], "target_point": [320.0, 200.0], "inset_m": 0.3}
    body = {**clicks, "u_inset_m": 0.1, "target": "roof", "client_key": str(uuid4())}
    stored = await http.ask("POST", f"/api/vehicles/{made.json()['id']}/measurements", body)
    assert stored.status_code == 201, stored.text
    return {**body, "id": stored.json()["id"], "revision": stored.json()["revision"]}


async def click(http: Light, ground: Ground, told: Told, until: float) -> None:
    """One person: each click is another pixel, so each is a revision."""
    mine = await vehicle_of(http, ground)
    moved = 0
    while time.perf_counter() < until:
        moved += 1
        body = {name: mine[name] for name in ("frame", "contact", "inset_m", "u_inset_m", "revision")}
        body["target_point"] = [320.0 + (moved % 50) / 10, 200.0]
        started = time.perf_counter()
        answer = await http.ask("PUT", f"/api/measurements/{mine['id']}", body)
        told.took_s.append(time.perf_counter() - started)
        told.note(answer)
        if answer.status_code == 200:
            mine["revision"] += 1  # the next is refused where that is not so
        elif answer.status_code == 503:
            await asyncio.sleep(float(answer.header("Retry-After", LATE)))
        else:
            raise AssertionError(answer.text)


async def look(http: Light, ground: Ground, told: Told, until: float) -> None:
    """One person who plays the recording, `pause_s` a frame, and reads a list now and then."""
    count, number = int(ground.recording["frame_count"]), 0
    while time.perf_counter() < until:
        number += 1
        path = f"/api/recordings/{ground.recording['id']}/frames/{number * 7 % count}.jpg"
        if number % 25 == 0:
            path = f"/api/surveys/{ground.survey}/vehicles"
        started = time.perf_counter()
        answer = await http.ask("GET", path)
        took = time.perf_counter() - started
        told.took_s.append(took)
        told.note(answer)
        await asyncio.sleep(max(0.0, ground.pause_s - took))


async def under_load(ground: Ground, clickers: int, lookers: int, seconds: float) -> tuple[Told, Told]:
    clicked, seen = Told(), Told()
    until = time.perf_counter() + seconds
    people = [_person(click, ground, clicked, until, n) for n in range(clickers)]
    people += [_person(look, ground, seen, until, n) for n in range(lookers)]
    await asyncio.gather(*people)
    return clicked, seen


async def _person(
    work: Callable[[Light, Ground, Told, float], Awaitable[None]],
    ground: Ground,
    told: Told,
    until: float,
    number: int,
) -> None:
    async with Light(ground.urls[number % len(ground.urls)], ground.cookies) as http:
        await work(http, ground, told, until)


def processor_s(ground: Ground) -> float:
    """Seconds of processor time that the servers have spent (Linux)."""
    ticks = 0
    for pid in ground.server_pids:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


def resident_mb(ground: Ground) -> float:
    """Of all servers together."""
    pages = [int(Path(f"/proc/{pid}/statm").read_text().split()[1]) for pid in ground.server_pids]
    return sum(pages) * os.sysconf("SC_PAGE_SIZE") / 1e6


def report(ground: Ground, clickers: int, lookers: int, seconds: float) -> int:
    """Prints one row; how many clicks were acknowledged."""
    before = processor_s(ground)
    clicked, seen = asyncio.run(under_load(ground, clickers, lookers, seconds))
    spent = processor_s(ground) - before
    stored = clicked.statuses[200]
    row = f"{clickers:4d} clicking, {lookers:2d} looking: {stored / seconds:6.1f} clicks/s"
    row += f"  p50 {1000 * statistics.median(clicked.took_s):6.0f} ms"
    row += f"  p99 {1000 * clicked.quantile(0.99):6.0f} ms"
    row += f"  {1000 * spent / max(stored, 1):5.1f} ms of processor a click" if not lookers else ""
    if seen.took_s:
        row += f"  frames p50 {1000 * seen.quantile(0.5):.0f} p99 {1000 * seen.quantile(0.99):.0f} ms"
    others = {**clicked.statuses, **{f"read {k}": v for k, v in seen.statuses.items()}}
    print(f"{row}  {others}  {resident_mb(ground):.0f} MB  load {os.getloadavg()[0]:.1f}", flush=True)
    for sentence, count in (clicked.said + seen.said).most_common(3):
        print(f"     {count} times: {sentence}")
    return stored


def counted(database_url: str) -> int:
    """Revisions in the database."""
    engine = make_engine(database_url)
    try:
        with engine.connect() as connection:
            return int(connection.execute(text("SELECT count(*) FROM measurements")).scalar_one())
    finally:
        engine.dispose()


def served(chosen: argparse.Namespace, here: Path, stack: ExitStack) -> tuple[list[Server], str]:
    """The servers that answer, and the address of their database."""
    if not chosen.postgresql:
        data = here / "data"
        shutil.copytree(chosen.ground or made_once(here / "small"), data)
        servers = [start("demo", data)]
        url = make_url(f"sqlite:///{data / 'sightline.db'}").render_as_string(hide_password=False)
    else:
        cluster = Cluster(here / "cluster")
        cluster.start()
        stack.callback(cluster.stop)
        url, media = cluster.url, str(here / "made" / "media")
        make_survey(here / "made", database_url=url)
        common = {
            "SIGHTLINE_DATABASE_URL": url,
            "SIGHTLINE_MEDIA_URL": media,
            "SIGHTLINE_UPLOADS_DIR": str(here / "uploads"),
            "SIGHTLINE_WORKERS": "0",
        }
        common |= {name: secrets.token_hex(32) for name in ("SIGHTLINE_SECRET", "SIGHTLINE_SIGNING_KEY")}
        servers = [start("serve", here / f"app-{n}", extra=common) for n in range(chosen.apps)]
    for server in servers:
        stack.callback(server.stop)
        server.wait(120)
    return servers, url


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=10.0)
    options.add_argument("--clients", default="1,8,32,64")
    options.add_argument("--beside", type=int, default=8, help="people who click beside those who look")
    options.add_argument("--looking", type=int, default=8)
    options.add_argument("--pause", type=float, default=0.04, help="seconds from frame to frame of who looks")
    options.add_argument("--ground", type=Path, help="a small demonstration made before (SQLite)")
    options.add_argument("--postgresql", action="store_true")
    options.add_argument("--apps", type=int, default=1, help="servers before PostgreSQL")
    chosen = options.parse_args()
    if chosen.apps > 1 and not chosen.postgresql:
        options.error("several servers need --postgresql")
    with ExitStack() as stack:
        here = Path(stack.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True)))
        servers, url = served(chosen, here, stack)
        cookies, survey = signed_in(servers[0])
        urls = tuple(server.url for server in servers)
        with httpx2.Client(base_url=urls[0], cookies=cookies, timeout=120) as http:
            recording = http.get(f"/api/surveys/{survey}/recordings").json()[0]
        pids = tuple(server.process.pid for server in servers)
        ground = Ground(urls, cookies, survey, recording, pids, chosen.pause)
        before, acknowledged = counted(url), 0
        for number in (int(one) for one in chosen.clients.split(",")):
            acknowledged += number + report(ground, number, 0, chosen.seconds)
        acknowledged += chosen.beside + report(ground, chosen.beside, chosen.looking, chosen.seconds)
        lost = acknowledged - (counted(url) - before)
        print(f"{acknowledged} clicks acknowledged, {lost} of them not in the database")


if __name__ == "__main__":
    main()
