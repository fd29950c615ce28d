"""Single random changes of a package in memory, and a forger who then makes all sums fit."""

from __future__ import annotations

import base64
import csv
import hashlib
import io
import json
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from typing import Any, BinaryIO

from sightline.errors import Damaged
from sightline.export.verify.package import PackageCheck, verify_package
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.hashing import canonical_json, event_hash, link_hash
from sightline.infra.audit.signing import SigningKey

Package = dict[str, bytes]
#: What was done, in words, and the package then.
Mutation = tuple[str, Package]
SUMS, DESCRIPTION, CHAIN = "SHA256SUMS", "datapackage.json", "audit.csv"
CHECKPOINT, SCRIPT = "checkpoint.json", "audit.js"


class MemoryFiles:
    """A package in memory, as `sightline verify` reads it."""

    def __init__(self, package: Package) -> None:
        self._package = package
        self.paths = frozenset(package)

    @contextmanager
    def open(self, path: str) -> Iterator[BinaryIO]:
        if path not in self._package:
            raise Damaged("csv_package-file-missing", path=path)
        yield io.BytesIO(self._package[path])


def load(place: Path) -> Package:
    """The files of a folder."""
    return {
        path.relative_to(place).as_posix(): path.read_bytes() for path in place.rglob("*") if path.is_file()
    }


def checked(package: Package, key: str | None = None) -> PackageCheck:
    return verify_package(MemoryFiles(package), Anchors(key))


def mutated(package: Package, random: Random) -> Mutation:
    """One random change of one cell, line, column, key, byte or file."""
    while True:
        words, changed = random.choice(_WAYS)(package, random)
        if changed != package:
            return words, changed


def with_sums(changed: Package, whole: Package, *, seal: bool = False) -> Package:
    """Every sum fits what was changed, in the description and in the list, unless these were what was
    changed; with `seal`, in the chain's last event too.
    """
    made = dict(changed)
    if changed.get(SUMS) != whole[SUMS]:
        return made
    if changed.get(DESCRIPTION) == whole[DESCRIPTION]:
        described = json.loads(made[DESCRIPTION])
        for resource in described["resources"]:
            if "hash" in resource and resource["path"] in made:
                content = made[resource["path"]]
                resource |= {"bytes": len(content), "hash": f"sha256:{_sum(content)}"}
        made[DESCRIPTION] = (json.dumps(described, indent=2, ensure_ascii=False) + "\n").encode()
    if seal and CHAIN in made:
        made[CHAIN] = _sealed(made)
        made[CHECKPOINT] = _signed(made)
        if changed.get(SCRIPT) == whole.get(SCRIPT) is not None:
            made[SCRIPT] = script_of(made)
    made[SUMS] = "".join(f"{_sum(made[path])}  {path}\n" for path in sorted(made) if path != SUMS).encode()
    return made


def script_of(package: Package) -> bytes:
    """audit.js over a package's chain and checkpoint, as the format of the package says."""

    def packed(content: bytes) -> str:
        packer = zlib.compressobj(wbits=-15)
        return base64.b64encode(packer.compress(content) + packer.flush()).decode()

    told = json.dumps({path: packed(package.get(path, b"")) for path in (CHAIN, CHECKPOINT)})
    return f"globalThis.sightlineAudit = {told};\n".encode()


def _sealed(package: Package) -> bytes:
    """The chain with its last event told anew, as the format of the package says."""
    *before, last = package[CHAIN].splitlines(keepends=True)
    try:
        names = next(csv.reader([before[0].decode()]))
        event: dict[str, Any] = dict(zip(names, next(csv.reader([last.decode()])), strict=True))
        after = json.loads(event["after"])
        crops = sorted(path for path in package if path.startswith("crops/"))
        files = {
            path: _sum(package[path])
            for path in package
            if path not in (CHAIN, CHECKPOINT, SCRIPT, SUMS, *crops)
        }
        files["crops/"] = _sum("".join(f"{_sum(package[path])}  {path}\n" for path in crops).encode())
        after["files"] = {**files, CHAIN: _sum(b"".join(before))}
        event["after"] = canonical_json(after)
        told: dict[str, Any] = {name: event[name] or None for name in names[:9]}
        told |= {name: int(event[name]) for name in ("number", "actor_id", "survey_id") if event[name]}
        told["chain"] = f"survey/{event['survey_id']}"
        event["content_sha256"] = event_hash(told)
        event["hash"] = link_hash(event["previous_hash"], event["content_sha256"])
    except (ValueError, KeyError, StopIteration, UnicodeDecodeError, csv.Error):
        return package[CHAIN]
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerow(event.values())
    return b"".join(before) + out.getvalue().encode()


def _signed(package: Package) -> bytes:
    """A checkpoint over the chain's end, signed with the forger's own key, as the package's format says."""
    try:
        names, *_, last = csv.reader(io.StringIO(package[CHAIN].decode(), newline=""))
        event = dict(zip(names, last, strict=True))
        leaf = {"chain": f"survey/{event['survey_id']}", "count": int(event["number"]), "hash": event["hash"]}
    except (ValueError, KeyError, UnicodeDecodeError, csv.Error):
        return package.get(CHECKPOINT, b"")
    key, at = SigningKey(b"forger" + bytes(26)), "2026-01-01T00:00:00.000000+00:00"
    root = hashlib.sha256(b"\0" + canonical_json(leaf).encode()).hexdigest()
    told = {"format": "sightline-checkpoint-1", "at": at, "chains": 1, "root": root, "key": key.public}
    first = {"format": "sightline-key-1", "at": at, "key": key.public, "after": None}
    document = {**told, "signature": key.sign(told), "leaf": leaf, "place": 0, "path": []}
    document["keys"] = [{**first, "signature": key.sign(first)}]
    return (json.dumps(document, indent=2, ensure_ascii=False) + "\n").encode()


def _sum(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _named(package: Package, random: Random, suffix: str) -> str:
    return random.choice(sorted(path for path in package if path.endswith(suffix)))


def _table(package: Package, random: Random) -> tuple[str, list[list[str]]]:
    path = _named(package, random, ".csv")
    return path, list(csv.reader(io.StringIO(package[path].decode(), newline="")))


def _with_table(package: Package, path: str, table: list[list[str]]) -> Package:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(table)
    return {**package, path: out.getvalue().encode()}


def _other_text(text: str, random: Random, others: list[str]) -> str:
    """Another value of the same kind, or of none."""
    if text in ("true", "false") and random.random() < 0.7:
        return "false" if text == "true" else "true"
    try:
        number = float(text)
    except ValueError:
        return random.choice([*others, "", text + "x", text[1:], text.upper(), "0"])
    if text.lstrip("-").isdigit():
        return random.choice([*others, str(int(text) + 1), str(-int(text)), f"0{text}", f"{text}.0", ""])
    decimals = len(text.partition(".")[2])
    near = f"{number + 10.0**-decimals:.{decimals}f}"
    return random.choice([*others, near, repr(number * 1.1), text + "0", f"{number:e}", ""])


def _cell(package: Package, random: Random) -> Mutation:
    path, table = _table(package, random)
    if len(table) < 2:
        return _column(package, random)
    row, column = random.randrange(1, len(table)), random.randrange(len(table[0]))
    others = [line[column] for line in random.sample(table[1:], min(3, len(table) - 1))]
    before, table[row][column] = table[row][column], _other_text(table[row][column], random, others)
    words = f"{path}, row {row}, {table[0][column]}: {before[:40]!r} -> {table[row][column][:40]!r}"
    return words, _with_table(package, path, table)


def _line(package: Package, random: Random) -> Mutation:
    path, table = _table(package, random)
    if len(table) < 2:
        return _column(package, random)
    row, other = random.randrange(1, len(table)), random.randrange(1, len(table))
    way = random.choice(("taken out", "twice", "exchanged", "moved", "in another's place"))
    if way == "taken out":
        del table[row]
    elif way == "twice":
        table.insert(other, table[row])
    elif way == "exchanged":
        table[row], table[other] = table[other], table[row]
    elif way == "moved":
        table.insert(other, table.pop(row))
    else:
        table[row] = table[other]
    return f"{path}, row {row}: {way} ({other})", _with_table(package, path, table)


def _column(package: Package, random: Random) -> Mutation:
    path, table = _table(package, random)
    column, other = random.randrange(len(table[0])), random.randrange(len(table[0]))
    way = random.choice(("twice", "taken out", "exchanged", "named otherwise"))
    for at, line in enumerate(table):
        if way == "twice":
            line.insert(other, line[column])
        elif way == "taken out":
            del line[column]
        elif way == "exchanged":
            line[column], line[other] = line[other], line[column]
        elif at == 0:
            line[column] += "_"
    return f"{path}, column {column}: {way} ({other})", _with_table(package, path, table)


def _ends_of_lines(package: Package, random: Random) -> Mutation:
    path = _named(package, random, ".csv")
    ends = random.choice((b"\r\n", b"\r", b"\n\n", b" \n"))
    return f"{path}: ends of lines {ends!r}", {**package, path: package[path].replace(b"\n", ends)}


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    """Every (container, key) of a JSON value."""
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in list(pairs):
        yield value, key
        yield from _places(item)


def _key(package: Package, random: Random) -> Mutation:
    path = _named(package, random, ".json")
    found = json.loads(package[path])
    container, key = random.choice(list(_places(found)))
    value = container[key]
    way = random.choice(("changed", "taken out", "put in", "twice"))
    if way == "twice" and isinstance(container, dict):
        name = json.dumps(key, ensure_ascii=False).encode()
        text = package[path].replace(name + b":", name + b": null,\n" + name + b":", 1)
        return f"{path}, {key}: twice", {**package, path: text}
    if way == "taken out":
        del container[key]
    elif way == "put in" and isinstance(container, dict):
        container["another"] = value
    elif isinstance(value, bool):
        container[key] = not value
    elif isinstance(value, int | float):
        container[key] = random.choice([value * 1.001 + 1e-9, -value - 1, str(value), None])
    elif isinstance(value, str):
        container[key] = _other_text(value, random, [])
    else:
        container[key] = None
    text = (json.dumps(found, indent=2, ensure_ascii=False) + "\n").encode()
    return f"{path}, {key}: {way}", {**package, path: text}


def _byte(package: Package, random: Random) -> Mutation:
    path = random.choice(sorted(package))
    content = bytearray(package[path])
    at = random.randrange(len(content) or 1)
    way = random.choice(("changed", "put in", "taken out", "cut off"))
    if way == "changed" and content:
        content[at] ^= 1 << random.randrange(8)
    elif way == "put in":
        content.insert(at, random.randrange(256))
    elif way == "taken out" and content:
        del content[at]
    else:
        del content[at:]
    return f"{path}, byte {at}: {way}", {**package, path: bytes(content)}


def _file(package: Package, random: Random) -> Mutation:
    path, made = random.choice(sorted(package)), dict(package)
    alike = sorted(one for one in package if Path(one).suffix == Path(path).suffix)
    other = random.choice(alike)
    way = random.choice(("taken out", "exchanged", "put in", "renamed"))
    if way == "exchanged":
        made[path], made[other] = made[other], made[path]
    elif way == "put in":
        made[f"{path}.copy"] = made[path]
    else:
        content = made.pop(path)
        if way == "renamed":
            made[f"{path}_"] = content
    return f"{path}: {way} ({other})", made


_WAYS: tuple[Callable[[Package, Random], Mutation], ...] = (
    *(_cell, _cell, _cell, _cell),
    *(_line, _line, _column, _ends_of_lines, _key, _key, _byte, _byte, _file),
)
