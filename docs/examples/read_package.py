"""Heights of a Sightline package by target, with pandas: python read_package.py FOLDER

Prints CSV: for each target the accepted heights, their percentiles (type 8, as Sightline's own) in metres,
and the median of their U95. Only accepted heights count: those that a reviewer accepted or fixed and nobody
withdrew.
"""

import json
import sys
from pathlib import Path

import numpy as np
import pandas as pd

folder = Path(sys.argv[1])

# datapackage.json says where each table is, and of each column what it holds, and in which unit.
described = json.loads((folder / "datapackage.json").read_text(encoding="utf-8"))["resources"]
tables = {one["name"]: one for one in described if "schema" in one}
units = {field["name"]: field.get("unit", "") for field in tables["measurements"]["schema"]["fields"]}
assert units["height_m"] == "m", "heights of a package are in metres"

heights = pd.read_csv(folder / tables["measurements"]["path"])
vehicles = pd.read_csv(folder / tables["vehicles"]["path"])[["id", "category"]]
heights = heights.merge(vehicles, left_on="vehicle_id", right_on="id", suffixes=("", "_of_vehicle"))
accepted = heights[
    heights["verdict"].isin(["accepted", "fixed"]) & (heights["status"] == "ok") & ~heights["withdrawn"]
]

rows = []
for target, group in accepted.groupby("target"):
    p15, p50, p85 = np.quantile(group["height_m"], [0.15, 0.5, 0.85], method="median_unbiased")
    rows.append((target, len(group), p15, p50, p85, group["U95_height_m"].median()))
columns = ["target", "count", "p15_m", "p50_m", "p85_m", "median_U95_m"]
pd.DataFrame(rows, columns=columns).to_csv(sys.stdout, index=False, float_format="%.4f", lineterminator="\n")
