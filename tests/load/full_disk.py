"""A disk that fills up, then has room again: `make full-disk DISK=FOLDER`.

FOLDER is a small file system of its own, empty, some 150 MB, for example
`mount -t tmpfs -o size=150m tmpfs FOLDER`. The real server runs in it on a copy of a demonstration. With
room, while nothing or a little is left, while the last of it goes, and with room again, everything that
writes is asked for: clicks, uploads, pictures, jobs that make files, packages. While the disk is full each
must succeed or say in words that there is no room (no 500, no traceback, no job without a reason). Afterwards
each must succeed, every acknowledged click is there, the audit chain holds and the next start leaves nothing
half written.
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any
from uuid import uuid4

import cv2
import httpx2
import numpy as np
from sqlalchemy import text

from sightline.commands.verify import check_database
from sightline.infra.database.engine import make_engine
from tests.browser.conftest import made_once
from tests.browser.server import start
from tests.load.faults import ENDED, left_behind
from tests.load.soak import signed_in

FILLER = "filler"
MOST_MB = 400
#: Nothing; room for a row, not for a file; for a small file; for a part of a package.
LEFT_KB = (0, 64, 300, 1000, 3000)
TUS = {"Tus-Resumable": "1.0.0"}
#: A job in the list that cannot be begun, for even that has to be written; it is done when there is room.
WAITS = "it waits"
ROOM = ("room", "not enough space", "disk is full", WAITS)


@dataclass
class Person:
    """One who asks once, and what they were told."""

    http: httpx2.Client
    survey: int
    recording: int
    clip: bytes
    stored: list[str] = field(default_factory=list)
    number: int = 0

    def asked(self, method: str, path: str, **given: Any) -> dict[str, Any]:
        """The answer. Raises Refused where it is none."""
        answer = self.http.request(method, path, **given)
        if answer.status_code >= 400:
            raise Refused(answer.status_code, answer.text[:300])
        return dict(answer.json()) if answer.content else {}

    def seen(self, path: str) -> list[dict[str, Any]]:
        return list(self.http.get(path).raise_for_status().json())

    def waited(self, job: dict[str, Any]) -> None:
        until = time.monotonic() + 60
        while time.monotonic() < until:
            now = self.asked("GET", f"/api/jobs/{job['id']}")
            if now["state"] == "done":
                return
            if now["state"] in ENDED:
                raise Refused(0, str(now["error"]["message"]))
            time.sleep(0.2)
        raise Refused(0, WAITS)


class Refused(Exception):
    """What was asked for was not done: the status (0 of a job) and the sentence."""

    def __init__(self, status: int, sentence: str) -> None:
        super().__init__(status, sentence)
        self.status, self.sentence = status, sentence


def click(me: Person) -> None:
    vehicle = me.asked(
        "POST", f"/api/recordings/{me.recording}/vehicles", json={"first_frame": 1, "last_frame": 9}
    )
    key = str(uuid4())
    clicks = {"frame": 5, "contact": [320.0, 400.0], "target_point": [320.0, 200.0], "target": "roof"}
    body = {**clicks, "inset_m": 0.3, "u_inset_m": 0.1, "client_key": key}
    me.asked("POST", f"/api/vehicles/{vehicle['id']}/measurements", json=body)
    me.stored.append(key)


def upload(me: Person) -> None:
    size = {"Upload-Length": str(len(me.clip)), "Upload-Metadata": "filename Yy5tcDQ="}
    begun = me.http.post(f"/api/surveys/{me.survey}/uploads", headers={**TUS, **size})
    if begun.status_code >= 400:
        raise Refused(begun.status_code, begun.text)
    at, location = 0, begun.headers["Location"]
    try:
        while at < len(me.clip):
            kind = {"Upload-Offset": str(at), "Content-Type": "application/offset+octet-stream"}
            piece = me.clip[at : at + (1 << 18)]
            sent = me.http.patch(location, content=piece, headers={**TUS, **kind})
            if sent.status_code >= 400:
                raise Refused(sent.status_code, sent.text)
            at += len(piece)
    except Refused:
        me.http.delete(location, headers=TUS)
        raise
    recording = sent.headers["Sightline-Recording"]
    until = time.monotonic() + 180
    while (found := me.asked("GET", f"/api/recordings/{recording}"))["state"] == "ingesting":
        if time.monotonic() > until:
            raise Refused(0, "the recording was not taken in within three minutes")
        time.sleep(0.2)
    if found["state"] != "ready":
        raise Refused(0, str(found))


def pictures(me: Person) -> None:
    name = f"Camera {uuid4().hex[:6]}"
    camera = me.asked("POST", f"/api/surveys/{me.survey}/cameras", json={"name": name})
    noise = np.random.default_rng(me.number).integers(0, 255, (600, 800, 3), np.uint8)
    png = cv2.imencode(".png", noise)[1].tobytes()
    me.asked("POST", f"/api/cameras/{camera['id']}/images", files={"file": (f"{name}.png", png, "image/png")})


def photograph(me: Person) -> None:
    noise = np.random.default_rng(me.number + 1000).integers(0, 255, (600, 800, 3), np.uint8)
    jpeg = cv2.imencode(".jpg", noise)[1].tobytes()
    files = {"file": (f"{uuid4().hex[:6]}.jpg", jpeg, "image/jpeg")}
    me.asked("POST", f"/api/surveys/{me.survey}/photographs", files=files)


def catalogue(me: Person) -> None:
    rows = [f"Maker {uuid4().hex[:6]},Model {n},1.{n + 400}" for n in range(200)]
    table = "make,model,height_m\n" + "\n".join(rows) + "\n"
    me.asked("POST", "/api/catalogue/import", files={"file": ("sizes.csv", table.encode(), "text/csv")})


def export(me: Person) -> None:
    me.waited(me.asked("POST", f"/api/surveys/{me.survey}/exports"))


def passes(me: Person) -> None:
    me.waited(me.asked("POST", f"/api/recordings/{me.recording}/find-passes"))


def frames(me: Person) -> None:
    """Pictures that are decoded to be looked at: they need no room, or say so."""
    for n in range(1, 40, 7):
        answer = me.http.get(f"/api/recordings/{me.recording}/frames/{n}.jpg")
        if answer.status_code >= 400:
            raise Refused(answer.status_code, answer.text[:300])


def statistics(me: Person) -> None:
    me.asked("GET", f"/api/statistics?survey={me.survey}&state=all")


def verified(me: Person) -> None:
    me.asked("POST", "/api/audit/verify")


WRITERS: tuple[Callable[[Person], None], ...] = (
    click, upload, pictures, photograph, catalogue, export, passes, frames, statistics, verified,
)  # fmt: skip


def fill(disk: Path, left_kb: int) -> None:
    """So much is left, whatever the server has just taken or given back."""
    with (disk / FILLER).open("ab", buffering=0) as file:
        for size in (1 << 20, 1 << 12, 1):
            with suppress(OSError):
                while True:
                    file.write(b"\0" * size)
        file.truncate(max(0, file.tell() - (left_kb << 10)))


def outcomes(me: Person, before: Callable[[], None]) -> Iterator[tuple[str, str]]:
    for writer in WRITERS:
        before()
        me.number += 1
        try:
            writer(me)
        except Refused as refused:
            yield writer.__name__, f"{refused.status or 'job'}: {refused.sentence}"
        except httpx2.TransportError as error:
            yield writer.__name__, f"no answer: {error}"
        else:
            yield writer.__name__, "done"


def caught_in_the_middle(me: Person, disk: Path) -> str:
    """What a package's job says that had room when it began."""
    job = me.asked("POST", f"/api/surveys/{me.survey}/exports")
    while me.asked("GET", f"/api/jobs/{job['id']}")["progress"] < 0.2:
        time.sleep(0.02)
    fill(disk, 0)
    try:
        me.waited(job)
    except Refused as refused:
        print(f"in the middle: {refused.sentence}", flush=True)
        return f"job: {refused.sentence}"
    return "done"


def makes_room(me: Person, disk: Path) -> str:
    """With the disk full to the byte: /api/ready says so, one signs in, and what is deleted makes room."""
    password = f"a password {uuid4().hex}"
    me.asked("PUT", "/api/session/password", json={"new": password})
    email = me.asked("GET", "/api/session")["person"]["email"]
    upload(me)
    newest = max(me.seen(f"/api/surveys/{me.survey}/recordings"), key=lambda one: one["id"])
    fill(disk, 0)
    if me.http.get("/api/ready").status_code != 503:
        return "500: /api/ready says that all is well"
    try:
        me.asked("POST", "/api/session", json={"email": email, "password": password})
        me.asked("DELETE", f"/api/recordings/{newest['id']}")
    except Refused as refused:
        return f"500: {refused.status}: {refused.sentence}"
    return "done"


def told(title: str, me: Person, before: Callable[[], None] = lambda: None) -> dict[str, str]:
    print(f"-- {title} --", flush=True)
    found = {}
    for name, outcome in outcomes(me, before):
        found[name] = outcome
        print(f"{name}: {outcome}", flush=True)
    return found


def waiting(me: Person) -> dict[str, str]:
    """Jobs that were put off and are still not over."""
    until = time.monotonic() + 120
    while time.monotonic() < until:
        left = [*me.seen("/api/jobs?state=queued"), *me.seen("/api/jobs?state=running")]
        if not left:
            return {}
        time.sleep(0.5)
    return {f"job {one['id']} ({one['kind']})": one["state"] for one in left}


def faults_of(full: dict[str, str], after: dict[str, str]) -> list[str]:
    """What is not as it must be."""
    wrong = [
        f"while full: {name}: {outcome}"
        for name, outcome in full.items()
        if outcome != "done" and (outcome.startswith("500") or not any(word in outcome for word in ROOM))
    ]
    return wrong + [f"with room again: {name}: {one}" for name, one in after.items() if one != "done"]


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("disk", type=Path, help="a small file system, empty")
    options.add_argument("--ground", type=Path, help="a small demonstration made before")
    chosen = options.parse_args()
    disk: Path = chosen.disk
    if any(one.name != "lost+found" for one in disk.iterdir()):
        sys.exit(f"{disk} is not empty; name an empty file system.")
    if shutil.disk_usage(disk).free > MOST_MB << 20:
        sys.exit(f"{disk} has more than {MOST_MB} MB free; this fills it whole, so name a small file system.")
    ground = chosen.ground or made_once(Path("/tmp") / "sightline-full-disk-ground")
    data = disk / "data"
    shutil.copytree(ground, data)
    extra = {"SIGHTLINE_WORKERS": "1", "TMPDIR": str(disk), "PYTHONDONTWRITEBYTECODE": "1"}
    server = start("demo", data, extra=extra)
    try:
        server.wait(120)
        cookies, survey = signed_in(server)
        with httpx2.Client(
            base_url=server.url, cookies=cookies, headers={"X-Sightline": "1"}, timeout=120
        ) as http:
            recording = http.get(f"/api/surveys/{survey}/recordings").json()[0]["id"]
            clip = min((data / "media").rglob("*.mp4"), key=lambda path: path.stat().st_size).read_bytes()
            me = Person(http=http, survey=survey, recording=recording, clip=clip)
            first = told("with room", me)
            full: dict[str, str] = {}
            for left_kb in LEFT_KB:
                of = told(f"{left_kb} KB left", me, partial(fill, disk, left_kb))
                full |= {f"{name} with {left_kb} KB": outcome for name, outcome in of.items()}
            os.remove(disk / FILLER)
            full["who makes room"] = makes_room(me, disk)
            print(f"who makes room: {full['who makes room']}", flush=True)
            os.remove(disk / FILLER)
            full["export that finds the disk full in the middle"] = caught_in_the_middle(me, disk)
            os.remove(disk / FILLER)
            after = told("with room again", me) | waiting(me)
    finally:
        server.stop()
    again = start("demo", data, extra=extra)
    again.wait(60)
    time.sleep(2)
    left = left_behind(data)
    again.stop()
    wrong = [f"with room: {name}: {one}" for name, one in first.items() if one != "done"]
    wrong += faults_of(full, after) + aftermath(data, me) + [f"left behind: {one}" for one in left]
    wrong += [f"log: {trace}" for trace in traces(server.log)]
    print(*(wrong or ["nothing lost, everything said in words"]), sep="\n")
    sys.exit(1 if wrong else 0)


def aftermath(data: Path, me: Person) -> list[str]:
    """What is lost, broken or left behind once the server is stopped."""
    url = f"sqlite:///{data / 'sightline.db'}"
    engine = make_engine(url)
    with engine.connect() as connection:
        keys = set(connection.execute(text("SELECT client_key FROM measurement_series")).scalars())
    engine.dispose()
    wrong = [f"lost: {key}" for key in me.stored if key not in keys]
    checked = check_database(url)
    if not checked["ok"]:
        wrong.append(f"audit: {checked['problem']}")
    return wrong


def traces(log: Path) -> list[str]:
    said = log.read_text(errors="replace").split("Traceback (most recent call last):")[1:]
    return [one.strip()[-600:] for one in said]


if __name__ == "__main__":
    main()
