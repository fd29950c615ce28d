"""Sixty forgeries of a package by who knows the format; they share no list and no hash with the program.

The forger changes tables, and the events that would tell; then writes all hashes anew that are not signed: of
each event and link to the end of the chain, the seal with all files, the sums of description and list.
What is left is the signature. Without it (the old checkpoint stays) the package is refused; signed with a key
of the forger's own it is refused by who gives the installation's key.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
import rfc8785
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from tests.support.mutations import Package, checked, load, script_of
from tests.support.packages import ground, package, worked
from tests.support.proofs import every

__all__ = ["ground", "package", "worked"]

Cells = dict[str, str]
Events = list[Cells]
Forgery = Callable[[Package], None]
SIGNED = ("format", "at", "chains", "root", "key")


def _read(content: bytes) -> list[Cells]:
    return list(csv.DictReader(io.StringIO(content.decode(), newline="")))


def _written(rows: list[Cells], header: list[str]) -> bytes:
    out = io.StringIO()
    writer = csv.DictWriter(out, header, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue().encode()


def _table(files: Package, path: str, change: Callable[[list[Cells]], list[Cells] | None]) -> None:
    path = path if path in files else f"tables/{path}"
    header = next(csv.reader([files[path].decode().partition("\n")[0]]))
    rows = _read(files[path])
    files[path] = _written(change(rows) or rows, header)


def cell(path: str, column: str, value: str, row: int = 0) -> Forgery:
    """One cell of one row, in a table and in those that repeat it."""

    def forge(files: Package) -> None:
        def change(rows: list[Cells]) -> None:
            assert rows[row][column] != value, (path, column)
            rows[row][column] = value

        _table(files, path, change)

    return forge


def everywhere(column: str, change: Callable[[str], str], *paths: str) -> Forgery:
    """A column of several tables, each filled cell."""

    def forge(files: Package) -> None:
        for path in paths:
            _table(
                files,
                path,
                lambda rows: [{**row, column: change(row[column])} for row in rows if column in row],
            )

    return forge


def without(path: str, row: int = 0) -> Forgery:
    """A row taken out."""
    return lambda files: _table(files, path, lambda rows: [one for n, one in enumerate(rows) if n != row])


def twice(path: str) -> Forgery:
    """The first row again at the end."""
    return lambda files: _table(files, path, lambda rows: [*rows, rows[0]])


def exchanged(path: str, column: str) -> Forgery:
    """The cells of two rows."""

    def change(rows: list[Cells]) -> None:
        first = rows[0]
        other = next(row for row in rows if row[column] != first[column])
        first[column], other[column] = other[column], first[column]

    return lambda files: _table(files, path, change)


def told(pattern: str, new: str) -> Forgery:
    """What events say, wherever this stands in them."""

    def forge(files: Package) -> None:
        def change(rows: list[Cells]) -> None:
            assert any(re.search(pattern, row["after"]) for row in rows), pattern
            for row in rows:
                row["after"] = re.sub(pattern, new, row["after"])

        _table(files, "audit.csv", change)

    return forge


def unsaid(**which: str) -> Forgery:
    """The first event of a kind taken out, those after it numbered anew."""

    def change(rows: list[Cells]) -> list[Cells]:
        gone = next(row for row in rows if all(row[name] == value for name, value in which.items()))
        kept = [row for row in rows if row is not gone]
        return [{**row, "number": str(n)} for n, row in enumerate(kept, start=1)]

    return lambda files: _table(files, "audit.csv", change)


def event(column: str, value: str, **which: str) -> Forgery:
    """A cell of the first event of a kind."""

    def change(rows: list[Cells]) -> None:
        found = next(row for row in rows if all(row[name] == one for name, one in which.items()))
        assert found[column] != value
        found[column] = value

    return lambda files: _table(files, "audit.csv", change)


def both(*forgeries: Forgery) -> Forgery:
    """Several at once: a table and what its events say."""

    def forge(files: Package) -> None:
        for one in forgeries:
            one(files)

    return forge


def text(pattern: str, find: str, put: str) -> Forgery:
    """Text in the files whose path fits."""

    def forge(files: Package) -> None:
        found = [path for path in files if re.fullmatch(pattern, path) and find.encode() in files[path]]
        assert found, pattern
        for path in found:
            files[path] = files[path].replace(find.encode(), put.encode())

    return forge


def swapped(pattern: str) -> Forgery:
    """The bytes of two files whose paths fit."""

    def forge(files: Package) -> None:
        one, other = sorted(path for path in files if re.fullmatch(pattern, path))[:2]
        assert files[one] != files[other]
        files[one], files[other] = files[other], files[one]

    return forge


def shifted(by: float) -> Callable[[str], str]:
    """A length by this much more, as the tables write lengths."""
    return lambda text: f"{float(text) + by:.6f}" if text else text


MEASURED = ("measurements.csv", "revisions.csv")
CLICKED = (*MEASURED, "clicks.csv", "clicks/pose-1.csv")
SIXTY: dict[str, Forgery] = {
    "heights 5 cm higher": everywhere("height_m", shifted(0.05), *MEASURED),
    "heights and events": both(
        everywhere("height_m", shifted(0.05), *MEASURED), told(r'"height_m":1\.', '"height_m":2.')
    ),
    "u halved": everywhere("u_height_m", lambda text: f"{float(text) / 2:.6f}" if text else "", *MEASURED),
    "U95 halved": everywhere(
        "U95_height_m", lambda text: f"{float(text) / 2:.6f}" if text else "", *MEASURED
    ),
    "part of the clicks": everywhere("u_clicks_m", shifted(0.001), *MEASURED),
    "part of the inset": everywhere("u_by_inset_m", shifted(0.001), *MEASURED),
    "clicks moved": everywhere("target_y_px", lambda text: repr(float(text) + 3.0), *CLICKED),
    "contacts moved": everywhere("contact_x_px", lambda text: repr(float(text) + 3.0), *CLICKED),
    "sigma halved": everywhere("sigma_px", lambda text: "0.5", *CLICKED),
    "sigma and events": both(
        everywhere("sigma_px", lambda text: "0.5", *CLICKED), told(r'"sigma_px":1,', '"sigma_px":0.5,')
    ),
    "insets": everywhere("inset_m", shifted(0.1), *CLICKED),
    "u of insets": everywhere("u_inset_m", shifted(-0.05), *CLICKED),
    "insets' source": everywhere("inset_from", lambda text: "usual", *MEASURED),
    "side": cell("measurements.csv", "side", "far", 1),
    "another pose": cell("measurements.csv", "pose_id", "2"),
    "another target": cell("measurements.csv", "target", "headlight"),
    "another vehicle": cell("measurements.csv", "vehicle_id", "2"),
    "who clicked": everywhere("created_by_id", lambda text: "1", *MEASURED),
    "when clicked": everywhere("created_at", lambda text: "2020-01-01T00:00:00.000000Z", *MEASURED),
    "the program's version": everywhere("code_version", lambda text: "1.0.0", *MEASURED),
    "flags taken out": both(
        everywhere("flags", lambda text: "", *MEASURED), told(r'"flags":\[[^\]]*\]', '"flags":[]')
    ),
    "a withdrawn one stands": everywhere("withdrawn", lambda text: "false", *MEASURED),
    "a withdrawal unsaid": both(
        everywhere("withdrawn", lambda text: "false", *MEASURED),
        unsaid(entity="measurement", action="withdraw"),
    ),
    "status": cell("measurements.csv", "status", "ok", 4),
    "frame": everywhere("frame", lambda text: "3" if text == "2" else text, *MEASURED),
    "frame times": everywhere("time_s", lambda text: repr(float(text) * 1.01), *MEASURED, "frames.csv"),
    "frame stamps": everywhere("pts", lambda text: str(int(text) + 1), *MEASURED, "frames.csv"),
    "frame checksums": everywhere("frame_crc32", lambda text: "1", *MEASURED),
    "checksums of frames": everywhere("crc32", lambda text: "1", "frames.csv"),
    "a measurement taken out": both(without("measurements.csv"), without("revisions.csv")),
    "a revision taken out": without("revisions.csv"),
    "a revision unsaid": both(without("revisions.csv"), unsaid(entity="measurement", action="create")),
    "a measurement twice": twice("measurements.csv"),
    "contributions exchanged": exchanged("budget.csv", "u_m"),
    "a contribution's name": exchanged("budget.csv", "source"),
    "a contribution taken out": without("budget.csv"),
    "a maker's height": both(
        cell("vehicles.csv", "manufacturer_height_m", "1.200000"),
        told(r'"manufacturer_height_m":1\.3', '"manufacturer_height_m":1.2'),
    ),
    "lighting": cell("vehicles.csv", "lighting", "low_light"),
    "a vehicle taken out": without("vehicles.csv", 1),
    "a rejection accepted": both(
        everywhere(
            "verdict", lambda text: text.replace("rejected", "accepted"), "measurements.csv", "reviews.csv"
        ),
        told('"verdict":"rejected"', '"verdict":"accepted"'),
    ),
    "a rejection unsaid": both(without("reviews.csv", 2), unsaid(entity="review")),
    "a reviewer": everywhere(
        "reviewer_id", lambda text: "1" if text else "", "measurements.csv", "reviews.csv"
    ),
    "a repeat taken out": both(
        without("repeats.csv"), unsaid(entity="measurement", action="create", actor_id="3")
    ),
    "a repeat nearer": everywhere("height_m", shifted(0.001), "repeats.csv"),
    "tyres taken out": both(without("wheel_pairs.csv"), unsaid(entity="wheel_pair")),
    "tyres moved": everywhere("first_x_px", lambda text: repr(float(text) + 1.0), "wheel_pairs.csv"),
    "the usual insets": cell("insets.csv", "inset_m", "0.123000"),
    "insets and events": both(
        cell("insets.csv", "inset_m", "0.123000"), told(r'"inset_m":0\.3,', '"inset_m":0.123,')
    ),
    "a standard": cell("standards.csv", "height_m", "0.999000"),
    "the recording's name": cell("recordings.csv", "name", "other.mp4"),
    "the recording's hash": both(
        cell("recordings.csv", "sha256", "0" * 64), told(r'"sha256":"[0-9a-f]{64}"', f'"sha256":"{"0" * 64}"')
    ),
    "the recording's rate": cell("recordings.csv", "variable_rate", "true"),
    "the class of the road": cell("survey.csv", "road_class", "motorway"),
    "the lane": cell("survey.csv", "lane", "lane 2"),
    "where traffic goes": cell("survey.csv", "travel_direction", "towards the north"),
    "the coordinates": both(
        cell("survey.csv", "latitude_deg", "49.5"), cell("survey.csv", "longitude_deg", "1.5")
    ),
    "when it was filmed": everywhere(
        "filmed_at", lambda text: text.replace("T08", "T07"), "measurements.csv", "vehicles.csv"
    ),
    "the recording's start": both(
        everywhere("filmed_at", lambda text: text.replace("T08", "T07"), "measurements.csv", "vehicles.csv"),
        everywhere("started_at", lambda text: text.replace("T08", "T07"), "recordings.csv"),
    ),
    "the start and its event": both(
        everywhere("filmed_at", lambda text: text.replace("T08", "T07"), "measurements.csv", "vehicles.csv"),
        everywhere("started_at", lambda text: text.replace("T08", "T07"), "recordings.csv"),
        told('"started_at":"2026-05-03T06', '"started_at":"2026-05-03T05'),
    ),
    "the zone": cell("recordings.csv", "time_zone", "Europe/London"),
    "the weather": cell("recordings.csv", "weather", "snow"),
    "street lamps": cell("recordings.csv", "street_lighting", "on"),
    "the camera's lens": cell("cameras.csv", "lens", "another"),
    "the camera's zoom and its event": both(
        cell("cameras.csv", "zoom", "35 mm"), told('"zoom":"28 mm"', '"zoom":"35 mm"')
    ),
    "the camera of a calibration": everywhere("camera_name", lambda text: "Right", "calibrations.csv"),
    "the camera stood still": both(
        cell("recordings.csv", "drift_state", "still"), told('"state":"moved"', '"state":"still"')
    ),
    "who decided": cell("recordings.csv", "drift_decided_by_id", "1"),
    "the pose": text(r"(poses|records)/pose-1\.json", '"rms_px": 0.1', '"rms_px": 0.05'),
    "the lens": text(r"(calibrations|records)/calibration-1\.json", '"k1"', '"k9"'),
    "people's names": everywhere("name", lambda text: f"Dr {text}", "people.csv"),
    "crops exchanged": swapped(r"crops/.*\.jpg"),
    "photographs exchanged": swapped(r"photographs/.*\.jpg"),
    "figures exchanged": swapped(r"figures/.*\.svg"),
    "a statistic": cell("statistics/error_table.csv", "value", "0.000001"),
    "the survey's site": both(
        cell("survey.csv", "site", "Elsewhere"), told(r'"site":"[^"]*"', '"site":"Elsewhere"')
    ),
    "when it was done": event("at", "2020-01-01T00:00:00.000000+00:00", entity="measurement"),
    "who did it": event("actor_id", "1", entity="measurement", action="revise"),
}


def _sum(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _canonical(value: object) -> bytes:
    return rfc8785.dumps(value)  # type: ignore[arg-type]


def _chained(files: Package) -> None:
    """Every event's hashes, and the seal, anew."""
    described = json.loads(files["datapackage.json"])
    for resource in described["resources"]:
        if "hash" in resource and resource["path"] in files:
            content = files[resource["path"]]
            resource |= {"bytes": len(content), "hash": f"sha256:{_sum(content)}"}
    files["datapackage.json"] = (json.dumps(described, indent=2, ensure_ascii=False) + "\n").encode()
    header = next(csv.reader([files["audit.csv"].decode().partition("\n")[0]]))
    events = _read(files["audit.csv"])
    before = "0" * 64
    for one in events[:-1]:
        before = _linked(one, before)
    seal, after = events[-1], json.loads(events[-1]["after"])
    crops = sorted(path for path in files if path.startswith("crops/"))
    own = {"SHA256SUMS", "checkpoint.json", "audit.csv", "audit.js", *crops}
    named = {path: _sum(content) for path, content in files.items() if path not in own}
    named["crops/"] = _sum("".join(f"{_sum(files[path])}  {path}\n" for path in crops).encode())
    named["audit.csv"] = _sum(_written(events[:-1], header))
    seal["after"] = _canonical({**after, "as_of": int(seal["number"]) - 1, "files": named}).decode()
    _linked(seal, before)
    files["audit.csv"] = _written(events, header)


def _linked(one: Cells, before: str) -> str:
    told: dict[str, object] = {
        name: one[name] or None for name in ("at", "action", "entity", "before", "after")
    }
    numbers = ("number", "actor_id", "entity_id", "survey_id")
    told |= {name: int(one[name]) if one[name] else None for name in numbers}
    one["content_sha256"] = _sum(_canonical({**told, "chain": f"survey/{one['survey_id']}"}))
    one["previous_hash"] = before
    one["hash"] = _sum((before + one["content_sha256"]).encode())
    return one["hash"]


def _listed(files: Package) -> None:
    files.pop("SHA256SUMS")
    if "audit.js" in files:
        files["audit.js"] = script_of(files)
    files["SHA256SUMS"] = "".join(f"{_sum(files[path])}  {path}\n" for path in sorted(files)).encode()


def _signed(files: Package) -> None:
    """The checkpoint with a key of the forger's own."""
    key = Ed25519PrivateKey.from_private_bytes(b"not the installation's key, no.!")
    public = key.public_key().public_bytes_raw().hex()
    last = _read(files["audit.csv"])[-1]
    leaf = {"chain": f"survey/{last['survey_id']}", "count": int(last["number"]), "hash": last["hash"]}
    root = _sum(b"\0" + _canonical(leaf))
    moment = "2026-11-22T00:00:00.000000+00:00"
    told = dict(zip(SIGNED, ("sightline-checkpoint-1", moment, 1, root, public), strict=True))
    first = {"format": "sightline-key-1", "at": moment, "key": public, "after": None}
    document = {**told, "signature": key.sign(_canonical(told)).hex(), "leaf": leaf, "place": 0, "path": []}
    document["keys"] = [{**first, "signature": key.sign(_canonical(first)).hex()}]
    files["checkpoint.json"] = (json.dumps(document, indent=2) + "\n").encode()


@pytest.mark.once
def test_there_are_sixty() -> None:
    assert len(SIXTY) >= 60


@pytest.mark.once
def test_who_forges_nothing_but_signs_anew_is_told_by_the_key_alone(package: Path) -> None:
    """So what is refused below is refused for what was forged, or for the key."""
    files = load(package)
    key = json.loads(files["checkpoint.json"])["key"]
    _chained(files)
    _signed(files)
    _listed(files)
    found = checked(files)
    assert found.ok, found.problem
    assert "not with the given key" in str(checked(files, key).problem)


@pytest.mark.once
@pytest.mark.parametrize("name", every(4, SIXTY))
def test_a_forgery_by_who_knows_the_format_is_found(package: Path, name: str) -> None:
    files = load(package)
    key, before = json.loads(files["checkpoint.json"])["key"], dict(files)
    SIXTY[name](files)
    assert files != before
    _chained(files)
    _listed(files)
    assert not checked(files).ok
    _signed(files)
    _listed(files)
    assert not checked(files, key).ok
