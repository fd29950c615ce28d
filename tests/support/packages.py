"""A survey with every kind of work, its package, built once for all tests that read it; tools of forgers."""

from __future__ import annotations

import csv
import io
import json
import shutil
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.enums import Point, ProposedPoint
from sightline.export.build import build
from sightline.export.derived import derive_tables, draw_derived_files
from sightline.export.package_tables import tables_of
from sightline.export.page import write_audit_script, write_page
from sightline.export.seal import CHECKPOINT, PAGE, sealed_hashes
from sightline.infra.audit.hashing import canonical_json, event_hash, link_hash
from sightline.infra.audit.merkle import root_of
from sightline.infra.audit.records import AuditHead
from sightline.infra.audit.signing import SigningKey
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.chain import hashed_values
from sightline.infra.csv_package.files import FolderFiles, Staging, fresh_folder, place_of, sum_of
from sightline.infra.csv_package.parquet import write_parquet
from sightline.infra.csv_package.schema import (
    CHECKSUMS,
    DESCRIPTION,
    AnyTable,
    Written,
    json_bytes,
    sha256_hex,
    table_key,
)
from sightline.infra.services import Services
from sightline.media.images import jpeg
from sightline.messages.said import Said
from sightline.recordings.drift import DriftCheck, DriftSpan
from sightline.recordings.store import get_recording, store_drift
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import replace_proposals
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, clicks, lay_ground, measure, pixel
from tests.support.kept import run_folder

FORMULA = '=HYPERLINK("http://example.org","x")'
Rows = list[dict[str, str]]


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def propose_near(services: Services, ground: Ground, vehicle_id: int) -> None:
    """A contact and a roof proposed a pixel beside the usual clicks."""
    usual = clicks()
    places: dict[ProposedPoint, Point] = {"contact_rear": usual["contact"], "roof": usual["target_point"]}
    made = [
        PointProposal(
            vehicle_id=vehicle_id,
            point=point,
            frame=usual["frame"],
            point_px=(x + 1.0, y),
            expected_px=0.4,
            reason=None,
        )
        for point, (x, y) in places.items()
    ]
    with services.writing() as session:
        replace_proposals(session, ground.recording_id, ground.pose_id, made, actor=None)


@pytest.fixture
def worked(operator: Client, reviewer: Client, ground: Ground, services: Services) -> Ground:
    """A survey with every kind of work: measured, revised, fixed, rejected, withdrawn, not measurable.

    Another survey is written to meanwhile, of which the package tells nothing.
    """
    for n, caption in enumerate(("The rig", "The road"), start=1):
        picture = jpeg(np.full((60, 80, 3), 80 * n, np.uint8))
        photograph(operator, ground.survey_id, picture, f"{n}.jpg", caption)
    known = {"lighting": "daytime", "manufacturer_height_m": 1.3}
    first = add_vehicle(operator, ground.recording_id, make=FORMULA, model="-1+1", **known)["id"]
    second = add_vehicle(operator, ground.recording_id, notes="line one\nline two, with comma")["id"]
    tyres = {"frame": 2, "first": pixel(-1.0, 0.0, 0.0), "second": pixel(1.0, 0.0, 0.0)}
    operator.made(f"/vehicles/{first}/wheel-pair", tyres)
    propose_near(services, ground, first)
    roof = measure(operator, first, inset_m=0.1234567, u_inset_m=0.1)
    eye = measure(operator, first, target="driver_eye", contact=[140.123456789, 185.987654321])
    rejected = measure(operator, first, target="taillight")
    measure(reviewer, first, frame=4, repeat_of=roof["id"], inset_m=None, u_inset_m=None)
    operator.made("/surveys", {"name": "Other"})
    gone = measure(operator, second)
    measure(operator, second, target="other", contact=[160.0, 3.0])
    operator.put(f"/measurements/{roof['id']}", {**clicks(1.31), "revision": 1})
    across, down = eye["target_point"]
    points = {"contact": eye["contact"], "target_point": [across, down + 0.5]}
    fixed = {"revision": 1, "verdict": "fixed", **points, "reason": "@home"}
    reviewer.made(f"/measurements/{eye['id']}/reviews", fixed)
    reviewer.made(f"/measurements/{roof['id']}/reviews", {"revision": 2, "verdict": "accepted"})
    kerb = {"revision": 1, "verdict": "rejected", "reason": "Kerb."}
    reviewer.made(f"/measurements/{rejected['id']}/reviews", kerb)
    operator.delete(f"/measurements/{gone['id']}?revision=1")
    camera_moved(services, ground)
    decided = operator.put(
        f"/recordings/{ground.recording_id}/drift/decision", {"reason": "A bird sat on it."}
    )
    assert decided.status_code == 200, decided.text
    start = {"local": "2026-05-03T08:10:00", "time_zone": "Europe/Paris"}
    facts = {"start": start, "weather": "overcast", "street_lighting": "off"}
    operator.put(f"/recordings/{ground.recording_id}", facts)
    words = {"lens": "24-70 mm", "zoom": "28 mm", "focus": "manual, 5 m"}
    assert operator.put(f"/cameras/{ground.camera_id}", words).status_code == 200
    return ground


def camera_moved(services: Services, ground: Ground, first_frame: int = 9, *, earlier: bool = False) -> None:
    """The camera is found to have moved, usually on frames that nobody clicked on; `earlier`: by a version
    that told no motion.
    """
    span: DriftSpan = {
        "x_px": 0.0,
        "y_px": 2.5,
        "turn_rad": 0.0,
        "scale": 1.0,
        "moved_px": 2.5,
        "u_px": 0.1,
        "points": 40,
        "first_frame": first_frame,
        "last_frame": 11,
        "moved": True,
        "change_m": -0.0125,
        "distance_m": 4.0,
    }
    if earlier:
        del span["distance_m"]
    with services.writing() as session:
        recording = get_recording(session, ground.recording_id)
        assert recording.pose_id is not None
        check: DriftCheck = {
            "pose_id": recording.pose_id,
            "pose_recording_id": recording.id,
            "state": "moved",
            "words": [Said("drift-more", count=1)],
            "reason": None,
            "floor_px": 0.25,
            "floor_m": None,
            "target_m": 0.01,
            "distance_m": None,
            "looks": [],
            "bumps": [{"after": 8, "frame": 9, "time_s": 0.36, "by_px": 2.5}],
            "spans": [span],
            "checked_at": "2026-05-01T12:00:00+00:00",
            "code_version": "0.1.0",
        }
        store_drift(session, recording.id, recording.pose_id, check, actor=None)


def photograph(client: Client, survey_id: int, content: bytes, name: str, caption: str = "") -> Any:
    """A photograph of the set-up, added."""
    path = f"/surveys/{survey_id}/photographs"
    answer = client.post(path, files={"file": (name, content)}, data={"caption": caption})
    assert answer.status_code == 201, answer.text
    return answer.json()


def written(services: Services, survey_id: int, place: Path) -> Path:
    """The package of a survey as a folder."""
    with services.reading() as session, fresh_folder(place) as folder:
        build(Staging(folder), session, survey_id, services)
    return place


@pytest.fixture
def package(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, tmp_path: Path) -> Path:
    """A copy of that survey's package; it is built by the first test that asks."""
    place = run_folder(tmp_path_factory) / "package"
    if not place.exists():
        ground: Ground = request.getfixturevalue("worked")
        services: Services = request.getfixturevalue("services")
        made = written(services, ground.survey_id, tmp_path_factory.mktemp("package") / "export")
        with suppress(OSError):  # another worker was quicker
            made.rename(place)
    return shutil.copytree(place, tmp_path / "export")


def table_file(place: Path, name: str) -> Path:
    """A table of a package of any format, by its key."""
    return place / place_of(FolderFiles(place), name)


def rows(place: Path, name: str) -> Rows:
    with table_file(place, name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def rewrite(place: Path, name: str, changed: Rows) -> None:
    """Write a table anew."""
    with table_file(place, name).open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(changed[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(changed)


def edit(place: Path, name: str, where: Callable[[dict[str, str]], bool], **cells: str) -> None:
    """Change cells of some rows of a table."""
    found = rows(place, name)
    chosen = [row for row in found if where(row)]
    assert chosen, f"no such row in {name}"
    for row in chosen:
        row.update(cells)
    rewrite(place, name, found)


def drop(place: Path, name: str, where: Callable[[dict[str, str]], bool]) -> None:
    """Take rows out of a table."""
    found = rows(place, name)
    kept = [row for row in found if not where(row)]
    assert kept and len(kept) < len(found)
    rewrite(place, name, kept)


def reseal(place: Path, *, seal: bool = True, page: bool = False) -> None:
    """Make all sums fit, in the description and in the list, as a forger would; and, with `seal`, write the
    chain's last event anew, so that what is found is found without it; with `page`, the page, which is looked
    at last.
    """
    described = json.loads((place / DESCRIPTION).read_text())
    files = FolderFiles(place)
    staging = Staging(place)
    staging.written = _sums(place)
    if page and PAGE in files.paths:
        write_page(staging, _tables(place), described["language"])
    for resource in described["resources"]:
        if "hash" in resource and (found := staging.written.get(resource["path"])):
            resource["bytes"], resource["hash"] = found.size, f"sha256:{found.sha256}"
    staging.add(DESCRIPTION, json_bytes(described))
    if seal:
        seal_anew(place, staging.written)
        for path in (AUDIT.path, CHECKPOINT):
            staging.written[path] = sum_of(files, path)
    write_audit_script(staging)
    staging.add_checksums()


def seal_anew(place: Path, sums: dict[str, Written]) -> None:
    """The chain's last event written anew over these sums, with its hashes: what only the kept head of the
    chain tells.
    """
    events = rows(place, "audit.csv")
    lines = (place / "audit.csv").read_bytes().splitlines(keepends=True)
    after = json.loads(events[-1]["after"])
    after["files"] = sealed_hashes(sums, sha256_hex(b"".join(lines[:-1])))
    events[-1]["after"] = canonical_json(after)
    text = io.StringIO()
    out = csv.DictWriter(text, list(events[-1]), lineterminator="\n", extrasaction="ignore")
    out.writerow(rehash(events, len(events) - 1)[-1])
    (place / "audit.csv").write_bytes(b"".join(lines[:-1]) + text.getvalue().encode())
    sign_anew(place)


def sign_anew(place: Path) -> None:
    """The checkpoint signed with a key of the forger's own, who lacks the installation's."""
    key, last = SigningKey(b"forger" + bytes(26)), rows(place, "audit.csv")[-1]
    end = {"count": int(last["number"]), "hash": last["hash"]}
    leaf = {"chain": f"survey/{last['survey_id']}", **end}
    ends = {leaf["chain"]: AuditHead(**end)}
    first = {"format": "sightline-key-1", "at": last["at"], "key": key.public, "after": None}
    told = {"format": "sightline-checkpoint-1", "at": last["at"], "chains": 1, "root": root_of(ends)}
    told["key"] = key.public
    document = {**told, "signature": key.sign(told), "leaf": leaf, "place": 0, "path": []}
    keys = [{**first, "signature": key.sign(first)}]
    (place / "checkpoint.json").write_bytes(json_bytes({**document, "keys": keys}))


def rederive(place: Path, *, seal: bool = True) -> None:
    """Compute statistics and draw figures and report anew from forged rows, with the program itself, write
    the columns and the page; then reseal. Who forges what is found in the rows themselves need not: they are
    looked at before all that is derived from them.
    """
    staging = Staging(place)
    staging.written = _sums(place)
    language = json.loads((place / DESCRIPTION).read_text("utf-8"))["language"]
    found = derive_tables(staging)
    for path, content in draw_derived_files(staging.files(), found, staging.written, language):
        staging.add(path, content)
    columns_again(place)
    reseal(place, seal=seal, page=True)


def columns_again(place: Path) -> None:
    """Write the Parquet of every table anew, with the program itself."""
    staging = Staging(place)
    staging.written = _sums(place)
    write_parquet(staging, _tables(place))


def _tables(place: Path) -> tuple[AnyTable, ...]:
    """Those of this program, with the columns that a package of an earlier one describes."""
    head = table_file(place, "measurements.csv").read_text().partition("\n")[0].split(",")
    most = sum(name.startswith("frame") and name[5:].isdigit() for name in head)
    resources = json.loads((place / DESCRIPTION).read_text("utf-8"))["resources"]
    there = {
        table_key(one["path"]): {field["name"] for field in one["schema"]["fields"]}
        for one in resources
        if "schema" in one
    }
    return tuple(
        replace(table, columns=tuple(one for one in table.columns if one.name in there[table.key]))
        for table in tables_of(most + 1)
        if table.key in there
    )


def _sums(place: Path) -> dict[str, Written]:
    files = FolderFiles(place)
    return {path: sum_of(files, path) for path in files.paths - {CHECKSUMS}}


def rehash(events: Rows, first: int) -> Rows:
    """The chain written anew from an event on."""
    for before, event in zip(events[first - 1 :], events[first:], strict=False):
        event["previous_hash"] = before["hash"]
        event["content_sha256"] = event_hash(hashed_values(event))
        event["hash"] = link_hash(event["previous_hash"], event["content_sha256"])
    return events
