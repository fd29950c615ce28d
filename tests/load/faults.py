"""Killing what runs, again and again: `make faults` (python -m tests.load.faults [--kills N] [--seed S]).

Starts the real server on a copy of a small demonstration, with people who click, upload, look at frames and
build packages, and sends SIGKILL to the server, the decoder, a worker, their supervisor or the database, in
an order drawn from the seed. Everybody sends again what was not answered, as the pages do. In the end: no
acknowledged vehicle or click is lost or there twice, each job is over and each package there once, the audit
chains hold, nothing that a killed process wrote halfway is left, and no log holds a traceback.

`--postgresql` does the same on a PostgreSQL cluster of its own, whose postmaster is killed too.
"""

from __future__ import annotations

import argparse
import fcntl
import random
import secrets
import shutil
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from uuid import uuid4

import httpx2
from sqlalchemy import Engine, text

from sightline.commands.verify import check_database
from sightline.infra.database.engine import make_engine
from sightline.media.atomic import PART
from tests.browser.conftest import made_once, make_survey
from tests.browser.server import Server, start
from tests.load.cluster import Cluster
from tests.load.processes import kill_one
from tests.load.soak import signed_in

KINDS = ("server", "decoder", "worker", "supervisor")
PAUSE_S = (0.2, 1.5)
QUIET_S, QUIET_SHARE = 15.0, 0.02
REVISIONS = 20
SLOW_S = 10.0
ENDED = ("done", "failed", "cancelled")


@dataclass
class World:
    """What all threads share."""

    url: str
    cookies: Any
    survey: int
    recording: dict[str, Any]
    clip: Path
    over: threading.Event = field(default_factory=threading.Event)
    told: Counter[str] = field(default_factory=Counter)
    odd: Counter[str] = field(default_factory=Counter)
    #: name of every acknowledged vehicle
    marked: list[str] = field(default_factory=list)
    #: client key of every acknowledged measurement
    stored: list[str] = field(default_factory=list)
    #: series, revision and x of every acknowledged revision
    revised: list[tuple[int, int, float]] = field(default_factory=list)
    broken: list[str] = field(default_factory=list)


class Person:
    """One who asks, and asks again until there is an answer."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.http = httpx2.Client(
            base_url=world.url, cookies=world.cookies, headers={"X-Sightline": "1"}, timeout=60
        )

    def ask(self, method: str, path: str, **given: Any) -> httpx2.Response:
        """The first answer that is no connection lost and no 5xx; a write bears a key, the same each time."""
        if method not in ("GET", "HEAD"):
            given["headers"] = {"Idempotency-Key": str(uuid4()), **given.get("headers", {})}
        until = time.monotonic() + 180
        while time.monotonic() < until:
            try:
                answer = self.http.request(method, path, **given)
            except httpx2.TransportError:
                self.world.told["no answer"] += 1
            else:
                self.world.told[str(answer.status_code)] += 1
                if answer.status_code < 500:
                    return answer
                if answer.status_code != 503:
                    self.world.odd[f"{answer.status_code} {method} {answer.text[:150]}"] += 1
            time.sleep(0.1)
        raise AssertionError(f"{method} {path} had no answer for three minutes")

    def made(self, path: str, **body: Any) -> Any:
        """What was stored; None where it was, and the answer is lost."""
        answer = self.ask("POST", path, json=body)
        if is_done(answer):
            self.world.told["done before"] += 1
            return None
        assert answer.status_code in (200, 201, 202), answer.text
        return answer.json()

    def seen(self, path: str) -> Any:
        answer = self.ask("GET", path)
        assert answer.status_code == 200, answer.text
        return answer.json()


def is_done(answer: httpx2.Response) -> bool:
    """Whether the server says that the request was stored before, and has lost its answer."""
    return answer.status_code == 409 and answer.json()["error"]["kind"] == "done_before"


def clicking(world: World) -> None:
    """A vehicle, its roof, and revisions of it; each click is at a place of its own."""
    me = Person(world)
    while not world.over.is_set():
        name = str(uuid4())
        passes = f"/api/recordings/{world.recording['id']}/vehicles"
        vehicle = me.made(passes, first_frame=1, last_frame=9, notes=name)
        world.marked.append(name)
        if vehicle is None:
            there = me.seen(f"/api/surveys/{world.survey}/vehicles?recording_id={world.recording['id']}")
            (vehicle,) = [one for one in there if one["notes"] == name]
        body = {"frame": 5, "contact": [320.0, 400.0], "inset_m": 0.3, "u_inset_m": 0.1}
        key = str(uuid4())
        roof = {**body, "target_point": [320.0, 200.0], "target": "roof", "client_key": key}
        stored = me.made(f"/api/vehicles/{vehicle['id']}/measurements", **roof)
        world.stored.append(key)
        revision = stored["revision"]
        for place in range(1, REVISIONS):
            x = 320.0 + place / 10
            again = {**body, "target_point": [x, 200.0], "revision": revision}
            answer = me.ask("PUT", f"/api/measurements/{stored['id']}", json=again)
            if is_done(answer):
                revision = me.seen(f"/api/measurements/{stored['id']}")["revision"]
                continue
            assert answer.status_code == 200, answer.text
            revision = answer.json()["revision"]
            world.revised.append((stored["id"], revision, x))
            if world.over.is_set():
                return


def looking(world: World) -> None:
    """Frames, which a child of the server decodes."""
    me, number = Person(world), 0
    while not world.over.is_set():
        number += 7
        path = f"/api/recordings/{world.recording['id']}/frames/{number % world.recording['frame_count']}.jpg"
        answer = me.ask("GET", path)
        assert answer.status_code == 200 and answer.content[:2] == b"\xff\xd8", answer.text
        time.sleep(0.05)


def exporting(world: World) -> None:
    me = Person(world)
    while not world.over.is_set():
        job = me.made(f"/api/surveys/{world.survey}/exports?crops=false")
        if job is None:
            continue
        _until_ended(me, world, job["id"])


def uploading(world: World) -> None:
    """A clip in pieces, going on where the server says."""
    me, content = Person(world), world.clip.read_bytes()
    while not world.over.is_set():
        size = {
            "Tus-Resumable": "1.0.0",
            "Upload-Length": str(len(content)),
            "Upload-Metadata": "filename Yy5tcDQ=",
        }
        begun = me.ask("POST", f"/api/surveys/{world.survey}/uploads", headers=size)
        assert begun.status_code == 201, begun.text
        location = begun.headers["Location"]
        recording = _sent(me, location, content)
        while not world.over.is_set():
            found = me.seen(f"/api/recordings/{recording}")
            if found["state"] != "ingesting":
                world.told[f"upload {found['state']}"] += 1
                break
            time.sleep(0.2)


def _sent(me: Person, location: str, content: bytes) -> int:
    speaks = {"Tus-Resumable": "1.0.0"}
    while True:
        at = me.ask("HEAD", location, headers=speaks)
        if at.headers.get("Sightline-Finished"):
            return int(at.headers["Sightline-Recording"])
        offset = int(at.headers["Upload-Offset"])
        piece = content[offset : offset + (1 << 16)]
        kind = {"Upload-Offset": str(offset), "Content-Type": "application/offset+octet-stream"}
        me.ask("PATCH", location, content=piece, headers={**speaks, **kind})


def _until_ended(me: Person, world: World, job_id: int) -> None:
    while True:
        state = me.seen(f"/api/jobs/{job_id}")["state"]
        if state in ENDED:
            world.told[f"export {state}"] += 1
            return
        time.sleep(0.2)


class Killer:
    """Kills one thing after the other and starts again what starts only by hand."""

    def __init__(
        self, server: Server, restart: Callable[[], Server], cluster: Cluster | None, seed: int
    ) -> None:
        self.server, self.restart, self.cluster = server, restart, cluster
        self.drawn = random.Random(seed)
        self.killed: Counter[str] = Counter()
        self.back_s: list[float] = []
        self.logs = [server.log]

    def kill(self) -> None:
        # now and then long enough for a package to be made
        time.sleep(QUIET_S if self.drawn.random() < QUIET_SHARE else self.drawn.uniform(*PAUSE_S))
        kind = self.drawn.choice((*KINDS, "database") if self.cluster else KINDS)
        if kind == "server":
            self.server.process.kill()
            self.server.process.wait()
            self.server = self.restart()
            self.back_s.append(self.server.wait(180))
            if self.back_s[-1] > SLOW_S:
                print(f"back after {self.back_s[-1]:.1f} s: {self.server.log.read_text()[-500:]}", flush=True)
            self.logs.append(self.server.log)
        elif kind == "database" and self.cluster:
            self.cluster.kill()
            self.cluster.start()
        elif not kill_one(self.server.process.pid, kind, self.drawn):
            return  # there is none just now
        self.killed[kind] += 1


def watched(world: World, work: Callable[[World], None]) -> threading.Thread:
    def run() -> None:
        try:
            work(world)
        except Exception as error:
            world.broken.append(f"{work.__name__}: {type(error).__name__}: {error}")
            world.over.set()

    thread = threading.Thread(target=run, name=work.__name__)
    thread.start()
    return thread


def lost_and_doubled(engine: Engine, world: World) -> tuple[int, int]:
    """Acknowledged vehicles and clicks that are not in the database, and those that are there twice."""
    # what is acknowledged while the database is read may be missing in what was read
    marked, stored, revised = list(world.marked), list(world.stored), list(world.revised)
    with engine.connect() as connection:
        keys = Counter(connection.execute(text("SELECT client_key FROM measurement_series")).scalars())
        vehicles = Counter(connection.execute(text("SELECT notes FROM vehicles")).scalars())
        rows = connection.execute(text("SELECT series_id, revision, target_x_px FROM measurements")).all()
    there = {(int(one[0]), int(one[1]), float(one[2])) for one in rows}
    lost = sum(vehicles[name] == 0 for name in marked)
    lost += sum(keys[key] != 1 for key in stored) + sum(one not in there for one in revised)
    mine = {series for series, _revision, _x in revised}
    places = Counter((one[0], one[2]) for one in rows if one[0] in mine)
    again = sum(max(vehicles[name] - 1, 0) for name in marked)
    return lost, again + sum(count - 1 for count in places.values())


def unfinished(engine: Engine) -> Counter[str]:
    with engine.connect() as connection:
        return Counter(connection.execute(text("SELECT state FROM jobs")).scalars())


def packages_per_job(engine: Engine) -> tuple[int, int]:
    """Exports that were done, and packages in the list."""
    with engine.connect() as connection:
        done = "SELECT count(*) FROM jobs WHERE kind = 'export' AND state = 'done'"
        return (
            int(connection.execute(text(done)).scalar_one()),
            int(connection.execute(text("SELECT count(*) FROM exports")).scalar_one()),
        )


def left_behind(data: Path) -> list[str]:
    """Folders of processes that are gone, and files that were being written when theirs was killed; an upload
    that did not end may go on.
    """
    left = [str(path.relative_to(data)) for path in data.rglob(f"*{PART}") if path.parent.name != "uploads"]
    for lock in (data / "scratch").glob("*.lock"):
        with lock.open("rb+") as file, suppress(OSError):
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            left.append(lock.name)
    return left


def under_fire(world: World, killer: Killer, kills: int, minutes: float) -> None:
    """Until so many are killed, or so much time has gone."""
    until = time.monotonic() + 60 * minutes
    threads = [watched(world, clicking) for _ in range(4)]
    threads += [watched(world, one) for one in (looking, exporting, uploading)]
    try:
        while sum(killer.killed.values()) < kills and not world.over.is_set() and time.monotonic() < until:
            killer.kill()
            done = sum(killer.killed.values())
            if done % 25 == 0:
                print(
                    f"{done} kills, {len(world.stored) + len(world.revised)} clicks acknowledged", flush=True
                )
    finally:
        world.over.set()
        for thread in threads:
            thread.join()


def settled(engine: Engine, seconds: float = 180) -> Counter[str]:
    """The jobs by their state, once none waits or runs."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        states = unfinished(engine)
        if not states.keys() - set(ENDED):
            return states
        time.sleep(0.5)
    return unfinished(engine)


def tell(world: World, killer: Killer, engine: Engine, data: Path) -> bool:
    """Prints what came of it; whether all is as it must be."""
    settled(engine)
    killer.server.stop()
    killer.server = killer.restart()
    killer.server.wait(60)
    killer.logs.append(killer.server.log)
    time.sleep(2)
    print(f"killed: {dict(killer.killed)}; back after {max(killer.back_s, default=0):.1f} s at most")
    return tell_stored(world, engine, killer.logs, [data])


def tell_stored(world: World, engine: Engine, logs: list[Path], folders: list[Path]) -> bool:
    """Prints what was acknowledged and what became of it; whether all is as it must be."""
    states = settled(engine)
    lost, doubled = lost_and_doubled(engine, world)
    done, packages = packages_per_job(engine)
    left = [one for data in folders for one in left_behind(data)]
    traces = [
        trace.strip()[:900]
        for log in logs
        for trace in log.read_text(errors="replace").split("Traceback (most recent call last):")[1:]
    ]
    verified = check_database(engine.url.render_as_string(hide_password=False))
    print(f"answers: {dict(world.told)}")
    print(
        f"{len(world.stored)} heights and {len(world.revised)} revisions acknowledged: "
        f"{lost} lost, {doubled} twice"
    )
    print(f"jobs: {dict(states)}; {done} exports done, {packages} packages")
    print(f"audit: {'holds' if verified['ok'] else verified['problem']}, {verified['checked']} events")
    print(f"left behind: {left or 'nothing'}; tracebacks in the logs: {len(traces)}")
    for trace in traces[:3]:
        print(trace)
    for sentence, count in (world.odd + Counter(world.broken)).most_common(8):
        print(f"  {count} times: {sentence}")
    return not (
        lost
        or doubled
        or left
        or traces
        or world.odd
        or world.broken
        or done != packages
        or not verified["ok"]
        or states.keys() - set(ENDED)
    )


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--kills", type=int, default=1000)
    options.add_argument("--minutes", type=float, default=600.0, help="stop and tell after so long at most")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--postgresql", action="store_true", help="on a cluster of its own")
    options.add_argument("--ground", type=Path, help="a small demonstration made before (SQLite)")
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as made:
        here, data = Path(made), Path(made) / "data"
        cluster = Cluster(here / "cluster") if chosen.postgresql else None
        extra = {"SIGHTLINE_WORKERS": "2"}
        if cluster:
            cluster.start()
            extra["SIGHTLINE_DATABASE_URL"] = cluster.url
            extra["SIGHTLINE_SIGNING_KEY"] = secrets.token_hex(32)
            make_survey(data, database_url=cluster.url)
        else:
            shutil.copytree(chosen.ground or made_once(here / "small"), data)
        engine = make_engine(cluster.url if cluster else f"sqlite:///{data / 'sightline.db'}")
        server = start("demo", data, extra=extra)

        def again() -> Server:
            return start("demo", data, port=server.port, extra=extra)

        killer = Killer(server, again, cluster, chosen.seed)
        try:
            server.wait(120)
            cookies, survey = signed_in(server)
            with httpx2.Client(base_url=server.url, cookies=cookies, timeout=120) as http:
                recording = http.get(f"/api/surveys/{survey}/recordings").json()[0]
            clip = min((data / "media").rglob("*.mp4"), key=lambda path: path.stat().st_size)
            world = World(server.url, cookies, survey, recording, clip)
            under_fire(world, killer, chosen.kills, chosen.minutes)
            good = tell(world, killer, engine, data)
        finally:
            killer.server.stop()
            engine.dispose()
            if cluster:
                cluster.stop()
        raise SystemExit(0 if good else 1)


if __name__ == "__main__":
    main()
