"""What happens to several machines, played by itself: `make faults-machines` (python -m tests.load.machines).

Two apps and two workers on one PostgreSQL and one S3, with people who click at both apps. One after the
other: an app that drops off the net in mid-write, connections that freeze, a database that stands still,
connections that end, a storage that is gone and one that stands still, a killed worker, clocks apart. Prints
for each how many writes were acknowledged, how many of them are stored, and how many seconds went by until
the next write and the next sign-in, by app; ends with status 1 where that took more than fifteen, or anything
was lost. A package is asked for before the database stands still, the storage goes and workers are killed:
its job goes on, and an outage uses up none of its attempts.
"""

from __future__ import annotations

import argparse
import logging
import os
import secrets
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import httpx2
from sqlalchemy import Engine, make_url, text

from sightline.infra.database.engine import make_engine
from tests.browser.conftest import make_survey
from tests.browser.server import SIGHTLINE, Server, start
from tests.load.cluster import Cluster
from tests.load.faults import Person, World, clicking, lost_and_doubled, tell_stored, watched
from tests.load.soak import signed_in
from tests.support.relay import Relay
from tests.support.waiting import until

MOST_S, CALM_S, APART_S = 15.0, 2.0, 180
HEADERS = {"X-Sightline": "1"}
PERSON = {"email": "reviewer@example.org", "password": "a long enough password"}
KEYS = {"AWS_ACCESS_KEY_ID": "key", "AWS_SECRET_ACCESS_KEY": "secret", "AWS_DEFAULT_REGION": "us-east-1"}
#: read when a process starts: its clock, as far as sessions and what is stored go
CLOCK = """
import os, time
off, real = float(os.environ["CLOCK_OFF_S"]), time.time
time.time = lambda: real() + off
import datetime as dates
from sightline.infra.database import types
types.now = lambda: dates.datetime.now(dates.UTC) + dates.timedelta(seconds=off)
"""


@dataclass
class Machines:
    """Where the parts are; each app and the workers reach the database by a relay of their own."""

    here: Path
    cluster: Cluster
    engine: Engine
    storage: Relay
    relays: dict[str, Relay]
    common: dict[str, str]
    apps: dict[str, Server] = field(default_factory=dict)
    workers: list[Server] = field(default_factory=list)
    worlds: dict[str, World] = field(default_factory=dict)
    logs: list[Path] = field(default_factory=list)

    def begin(self, command: str, name: str, port: int | None = None, **more: str) -> Server:
        """Start an app or a worker, with the relay `name`."""
        address = make_url(self.cluster.url).set(host="127.0.0.1", port=self.relays[name].port, query={})
        extra = {
            **self.common,
            "SIGHTLINE_DATABASE_URL": address.render_as_string(hide_password=False),
            **more,
        }
        server = start(command, self.here / f"{command}-{name}", port=port, extra=extra)
        self.logs.append(server.log)
        return server

    def written(self, name: str) -> None:
        """Returns when a write that begins now is acknowledged by this app."""
        world = self.worlds[name]
        Person(world).made(f"/api/recordings/{world.recording['id']}/vehicles", first_frame=1, last_frame=9)

    def signed_in(self, name: str) -> None:
        """Returns when somebody who begins to sign in now, by name and password, is let in by this app."""
        while True:
            try:
                answer = httpx2.post(
                    f"{self.apps[name].url}/api/session", json=PERSON, headers=HEADERS, timeout=60
                )
            except httpx2.TransportError:
                continue
            if answer.status_code == 200:
                return
            assert answer.status_code == 503, answer.text
            time.sleep(0.2)

    def until_written(self) -> dict[str, float]:
        """Seconds until each app that runs acknowledged a write, and a sign-in, that began now."""
        took: dict[str, float] = {}
        begun = time.monotonic()

        def ask(what: str, act: Callable[[str], None], name: str) -> None:
            act(name)
            took[what] = time.monotonic() - begun

        threads = [
            threading.Thread(target=ask, args=(what, act, name))
            for name, app in self.apps.items()
            if app.process.poll() is None
            for what, act in ((name, self.written), (f"sign-in {name}", self.signed_in))
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return took

    def ready(self, name: str) -> dict[str, object]:
        """What /api/ready says; the seconds that it took, too."""
        begun = time.monotonic()
        answer = httpx2.get(f"{self.apps[name].url}/api/ready", timeout=30)
        return {**answer.json(), "took_s": time.monotonic() - begun}


def dead_app(all_: Machines) -> dict[str, float]:
    """Its connections freeze in mid-write, and it is gone."""
    all_.relays["A"].freeze()
    all_.apps["A"].process.kill()
    all_.apps["A"].process.wait()
    took = all_.until_written()
    all_.apps["A"] = all_.begin("serve", "A", port=all_.apps["A"].port)
    all_.apps["A"].wait()
    return took


def frozen(all_: Machines) -> dict[str, float]:
    """All connections freeze, new ones pass: a database that failed over without a word."""
    for relay in all_.relays.values():
        relay.freeze()
    return all_.until_written()


@contextmanager
def an_export(all_: Machines, attempts: int) -> Iterator[None]:
    """A package is being made before, and is there after so many attempts."""
    me = Person(all_.worlds["B"])

    def state_of(job: int) -> str:
        return str(me.seen(f"/api/jobs/{job}")["state"])

    def begun() -> int | None:
        """The job, seen while it runs; None where it was quicker than the look at it."""
        job = int(me.made(f"/api/surveys/{me.world.survey}/exports?crops=false")["id"])
        until(lambda: state_of(job) != "queued")
        return job if state_of(job) == "running" else None

    job = until(begun)
    yield
    until(lambda: state_of(job) not in ("queued", "running"))
    with all_.engine.connect() as connection:
        found = connection.execute(text("SELECT state, attempts FROM jobs WHERE id = :id"), {"id": job}).one()
    assert tuple(found) == ("done", attempts), found


def paused(all_: Machines) -> dict[str, float]:
    """Nothing answers for twenty seconds; what is away is said within three."""
    with an_export(all_, attempts=1):
        for relay in all_.relays.values():
            relay.held = True
        for name in all_.apps:
            said = all_.ready(name)
            assert said["database"] and float(str(said["took_s"])) < 3, said
        time.sleep(20)
        for relay in all_.relays.values():
            relay.held = False
        return all_.until_written()


def ended(all_: Machines) -> dict[str, float]:
    with all_.engine.connect() as connection:
        others = "FROM pg_stat_activity WHERE backend_type = 'client backend' AND pid <> pg_backend_pid()"
        connection.execute(text(f"SELECT pg_terminate_backend(pid) {others}"))
    return all_.until_written()


def storage_gone(all_: Machines) -> dict[str, float]:
    with an_export(all_, attempts=1):
        all_.storage.shut = True
        said = all_.ready("A")
        assert said["media"], said
        took = all_.until_written()
        time.sleep(15)
        all_.storage.shut = False
    return took


def storage_paused(all_: Machines) -> dict[str, float]:
    all_.storage.held = True
    said = all_.ready("A")
    assert said["media"] and float(str(said["took_s"])) < 3, said
    took = all_.until_written()
    all_.storage.held = False
    return took


def killed_worker(all_: Machines) -> dict[str, float]:
    """Both supervisors and all that they started, one of which has the job; a new one goes on."""
    with an_export(all_, attempts=2):
        for worker in all_.workers:
            worker.process.send_signal(signal.SIGKILL)
        all_.workers = [all_.begin("worker", "W", SIGHTLINE_WORKERS="1") for _ in range(2)]
        return all_.until_written()


def clocks_apart(all_: Machines) -> dict[str, float]:
    """B is three minutes ahead: who signs in there is signed in at A. An hour ahead it does not start."""
    site = all_.here / "clock"
    site.mkdir()
    (site / "sitecustomize.py").write_text(CLOCK)
    path = os.pathsep.join([str(site), *filter(None, [os.environ.get("PYTHONPATH")])])
    all_.apps["B"].stop()
    refused = all_.begin("serve", "B", PYTHONPATH=path, CLOCK_OFF_S="3600")
    assert refused.process.wait(60) == 2, refused.log.read_text()
    assert refused.log.read_text().count("\n") == 1 and "60 minutes apart" in refused.log.read_text()
    all_.apps["B"] = all_.begin(
        "serve", "B", port=all_.apps["B"].port, PYTHONPATH=path, CLOCK_OFF_S=str(APART_S)
    )
    all_.apps["B"].wait()
    link = subprocess.run(
        [str(SIGHTLINE), "sign-in-link", "admin@sightline.local"],
        env={**os.environ, **all_.common, "SIGHTLINE_DATABASE_URL": all_.cluster.url},
        capture_output=True,
        text=True,
        check=True,
    ).stdout.strip()
    with httpx2.Client(base_url=all_.apps["B"].url, headers={"X-Sightline": "1"}, timeout=60) as there:
        token = {"token": link.partition("token=")[2]}
        there.post("/api/session/link", json=token).raise_for_status()
        answer = httpx2.get(f"{all_.apps['A'].url}/api/session", cookies=dict(there.cookies))
        assert answer.status_code == 200, answer.text
    return all_.until_written()


PLAYED: tuple[Callable[[Machines], dict[str, float]], ...] = (
    dead_app,
    frozen,
    paused,
    ended,
    storage_gone,
    storage_paused,
    killed_worker,
    clocks_apart,
)


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--only", help="names with commas: " + ", ".join(one.__name__ for one in PLAYED))
    only = (options.parse_args().only or "").split(",")
    with ExitStack() as stack:
        here = Path(stack.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True)))
        all_ = built(here, stack)
        stack.callback(lambda: [one.stop() for one in (*all_.apps.values(), *all_.workers)])
        threads = [watched(world, clicking) for world in all_.worlds.values() for _ in range(2)]
        good = True
        print("what            acknowledged  stored  seconds until the next write and sign-in", flush=True)
        try:
            for play in PLAYED:
                if only != [""] and play.__name__ not in only:
                    continue
                time.sleep(CALM_S)
                good = told(all_, play) and good
        finally:
            world = all_.worlds["A"]
            world.over.set()
            for thread in threads:
                thread.join()
        folders = [one.data_dir for one in (*all_.apps.values(), *all_.workers)]
        good = tell_stored(world, all_.engine, all_.logs, folders) and good
    raise SystemExit(0 if good else 1)


def told(all_: Machines, play: Callable[[Machines], dict[str, float]]) -> bool:
    """One fault, and its line."""
    world = all_.worlds["A"]
    before = len(world.stored) + len(world.revised)
    took = play(all_)
    count = len(world.stored) + len(world.revised) - before
    lost, doubled = lost_and_doubled(all_.engine, world)
    seconds = ", ".join(f"{name} {took_s:.1f}" for name, took_s in sorted(took.items()))
    print(f"{play.__name__:15} {count:12} {count - lost:7}  {seconds}", flush=True)
    return not lost and not doubled and not world.broken and max(took.values()) <= MOST_S


def built(here: Path, stack: ExitStack) -> Machines:
    """PostgreSQL, S3, the small demonstration in them, two apps and two workers that answer."""
    from moto.server import ThreadedMotoServer

    cluster = Cluster(here / "cluster")
    cluster.start()
    stack.callback(cluster.stop)
    logging.getLogger("werkzeug").setLevel(logging.ERROR)
    s3 = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    s3.start()
    stack.callback(s3.stop)
    storage = stack.enter_context(Relay(*s3.get_host_and_port()))
    os.environ.update(KEYS)
    media = f"s3://sightline?endpoint=http://127.0.0.1:{storage.port}"
    make_survey(here / "made", database_url=cluster.url, media_url=media)
    relays = {name: stack.enter_context(Relay(str(cluster.folder), 5432)) for name in ("A", "B", "W")}
    engine = make_engine(cluster.url)
    stack.callback(engine.dispose)
    common = {
        **KEYS,
        "SIGHTLINE_MEDIA_URL": media,
        "SIGHTLINE_SECRET": secrets.token_hex(32),
        "SIGHTLINE_SIGNING_KEY": secrets.token_hex(32),
        "SIGHTLINE_UPLOADS_DIR": str(here / "uploads"),
        "SIGHTLINE_WORKERS": "0",
    }
    all_ = Machines(here, cluster, engine, storage, relays, common)
    all_.apps = {name: all_.begin("serve", name) for name in ("A", "B")}
    for app in all_.apps.values():
        app.wait()
    all_.workers = [all_.begin("worker", "W", SIGHTLINE_WORKERS="1") for _ in range(2)]
    cookies, survey = signed_in(all_.apps["A"])
    with httpx2.Client(base_url=all_.apps["A"].url, cookies=cookies, headers=HEADERS, timeout=120) as http:
        recording = http.get(f"/api/surveys/{survey}/recordings").json()[0]
        who = {"name": "A reviewer", "email": PERSON["email"], "role": "reviewer"}
        link = http.post("/api/people", json=who).raise_for_status().json()["link"]
    with httpx2.Client(base_url=all_.apps["A"].url, headers=HEADERS, timeout=120) as http:
        http.post("/api/session/link", json={"token": link.partition("token=")[2]}).raise_for_status()
        http.put("/api/session/password", json={"new": PERSON["password"]}).raise_for_status()
    first = World(all_.apps["A"].url, cookies, survey, recording, Path())
    all_.worlds = {"A": first, "B": replace(first, url=all_.apps["B"].url)}
    return all_


if __name__ == "__main__":
    main()
