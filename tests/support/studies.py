"""Packages of invented surveys for studies: the tables that a study reads, sealed, and nothing else.

They pass `--quick` (files as sealed), not a whole verification: there are no clicks behind their heights.
"""

from __future__ import annotations

import csv
import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import DESCRIPTION, TABLES, json_bytes
from sightline.results.csv import STANDARDS as STANDARDS_TABLE
from sightline.results.usual_standards import STANDARDS
from sightline.surveys.classes import USUAL_CLASSES

TARGETS = ("roof", "driver_eye", "taillight")
CLASS_M = {"hatchback": 1.46, "suv": 1.68, "van": 2.05}
#: A target's height as a share of the roof's.
OF_ROOF = {"roof": 1.0, "driver_eye": 0.79, "taillight": 0.62}


@dataclass(frozen=True)
class Invented:
    """One survey: its site, how many vehicles, the shares of CLASS_M, and what its heights are moved by."""

    name: str
    site: str
    vehicles: int
    shares: tuple[float, ...] = (0.55, 0.35, 0.10)
    moved_m: float = 0.0
    version: str = "test"
    poses: int = 1
    #: every how manieth vehicle is in the sample; the others were measured all the same
    sample_one_in: int = 1


def invent(folder: Path, survey: Invented, seed: int = 0, *, with_csv: bool = True) -> Path:
    """Write the package of an invented survey; every vehicle has a roof, an eye and a taillight."""
    rng = np.random.default_rng([seed, survey.vehicles, *survey.name.encode()])
    n = survey.vehicles
    folder.mkdir(parents=True, exist_ok=True)
    staging = Staging(folder)
    words = np.array(list(CLASS_M))
    which = rng.choice(len(words), n, p=survey.shares)
    roof = np.array(list(CLASS_M.values()))[which] + rng.normal(0.0, 0.06, n)
    lighting = np.where(np.arange(n) % 8 < 5, "daytime", "low_light")
    ids = np.arange(1, n + 1)
    vehicles = {
        "id": ids,
        "recording_id": np.ones(n, dtype=np.int64),
        "lighting": pa.array(lighting),
        "category": pa.array(words[which]),
        "model_chosen_by": pa.nulls(n, pa.string()),
        "manufacturer_height_m": roof,
        "check_target": np.zeros(len(ids), dtype=bool),
        "counts": ids % survey.sample_one_in == 0,
        "discarded": pa.nulls(n, pa.string()),
    }
    error = survey.moved_m + rng.normal(0.0, 0.004)
    of = np.repeat(np.arange(n), len(TARGETS))
    target = np.tile(np.arange(len(TARGETS)), n)
    share = np.array(list(OF_ROOF.values()))
    rows = len(of)
    heights = roof[of] * share[target] + error + rng.normal(0.0, 0.010, rows)
    measurements = {
        "id": np.arange(1, rows + 1),
        "vehicle_id": ids[of],
        "target": pa.array(np.array(TARGETS)[target]),
        "pose_id": np.ones(rows, dtype=np.int64),
        "height_m": np.round(heights, 6),
        "u_height_m": np.full(rows, np.sqrt(0.010**2 + 0.004**2)),
        "u_clicks_m": np.full(rows, 0.010),
        "u_by_inset_m": np.zeros(rows),
        "inset_m": np.zeros(rows),
        "u_inset_m": np.zeros(rows),
        "withdrawn": np.zeros(rows, dtype=bool),
        "verdict": pa.array(np.full(rows, "accepted")),
    }
    tables = {
        "survey": {"id": [1], "name": [survey.name], "site": [survey.site]},
        "measurements": measurements,
        "vehicles": vehicles,
        "recordings": {"id": [1], "lighting": pa.array([None], pa.string())},
        "classes": {
            "category": [one.category for one in USUAL_CLASSES],
            "class_set": [one.class_set for one in USUAL_CLASSES],
        },
    }
    for name, columns in tables.items():
        with staging.file(f"parquet/{name}.parquet") as file:
            pq.write_table(pa.table(columns), file, compression="zstd")
        if with_csv or name == "survey":
            staging.add(f"{TABLES}{name}.csv", _csv(columns))
    staging.add(f"{TABLES}poses.csv", _csv({"id": list(range(1, survey.poses + 1))}))
    staging.fill(STANDARDS_TABLE, STANDARDS)
    staging.add(DESCRIPTION, json_bytes({"made_with": {"sightline": survey.version}}))
    _seal(staging, survey)
    staging.add_checksums()
    return folder


def _csv(columns: dict[str, object]) -> bytes:
    names = list(columns)
    cells = [pa.array(columns[name]).to_pylist() for name in names]
    lines = [
        ",".join(names),
        *(",".join("" if c is None else str(c) for c in row) for row in zip(*cells, strict=True)),
    ]
    return ("\n".join(lines) + "\n").encode()


def _seal(staging: Staging, survey: Invented) -> None:
    first = {**dict.fromkeys(AUDIT.header, ""), "number": "1", "entity": "survey", "action": "create"}
    first["hash"] = hashlib.sha256(f"{survey.name}{survey.vehicles}".encode()).hexdigest()
    place = staging.folder / AUDIT.path
    with place.open("w", encoding="utf-8", newline="") as file:
        out = csv.DictWriter(file, AUDIT.header, lineterminator="\n")
        out.writeheader()
        out.writerow(first)
    files = {path: one.sha256 for path, one in staging.written.items()}
    files[AUDIT.path] = hashlib.sha256(place.read_bytes()).hexdigest()
    last = {**dict.fromkeys(AUDIT.header, ""), "number": "2", "entity": "package", "action": "seal"}
    last |= {"survey_id": "1", "after": json.dumps({"as_of": 1, "files": files})}
    with place.open("a", encoding="utf-8", newline="") as file:
        csv.DictWriter(file, AUDIT.header, lineterminator="\n").writerow(last)
    staging.add(AUDIT.path, place.read_bytes())
