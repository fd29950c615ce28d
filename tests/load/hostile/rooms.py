"""What is tried: `python -m tests.load.hostile.rooms ROOM FIRST_SEED COUNT` prints one JSON line a case.

A case takes a sound file, spoils it by its seed and gives it to the program as a person would. The only good
outcomes are an answer and a refusal of one sentence; every other exception ends the process, and the line of
that case is missing.
"""

from __future__ import annotations

import io
import json
import os
import random
import sys
import tempfile
import time
import warnings
import zipfile
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import cv2
import numpy as np

from sightline.cli import main as command_line
from sightline.commands.passes_csv import NEEDED, OPTIONS
from sightline.commands.verify import check_export
from sightline.errors import SightlineError
from sightline.geometry.documents import camera_to_dict, pose_to_dict
from sightline.infra.database.engine import make_engine, migrate
from sightline.media.images import read_image_bgr
from tests.adjustment.survey import BoardBudget, Fleet, passes, prior_covariance, told_pose, truth_at
from tests.geometry.scenes import camera_of, pose_of
from tests.geometry.simulate import Lens, Scene
from tests.load.hostile.spoiling import spoiled_bytes, spoiled_text
from tests.media.clips import painted, write
from tests.media.fuzz import SPECS, peak_mb, try_one
from tests.media.strips import pattern, png, read, tiff

#: A case: the folder to work in, what is drawn from the seed, and what came of it in one word.
Case = Callable[[Path, random.Random], str]
#: the folder of an export, named by who runs the room of packages
PACKAGE = "SIGHTLINE_HOSTILE_PACKAGE"


def one_sentence(error: SightlineError) -> str:
    assert error.message.endswith(".") and "\n" not in error.message, error.message
    return "refused"


def videos(folder: Path) -> Case:
    sources = [write(folder / spec.name, spec, 40).read_bytes() for spec in SPECS]

    def case(here: Path, rng: random.Random) -> str:
        kind = rng.randrange(len(SPECS))
        path = here / SPECS[kind].name
        path.write_bytes(spoiled_bytes(sources[kind], rng))
        tally = dict.fromkeys(("refused", "taken", "served", "damaged"), 0.0)
        try_one(path, here, rng, tally)
        return "refused" if tally["refused"] else "taken"

    return case


def pictures(folder: Path) -> Case:
    drawn = painted(1234, 640, 480)
    sources = [
        (f"board{ending}", cv2.imencode(ending, drawn)[1].tobytes())
        for ending in (".jpg", ".png", ".tif", ".webp", ".bmp", ".jp2")
    ]

    def case(here: Path, rng: random.Random) -> str:
        name, whole = rng.choice(sources)
        try:
            read_image_bgr(spoiled_bytes(whole, rng), name)
        except SightlineError as error:
            return one_sentence(error)
        return "taken"

    return case


def strips(folder: Path) -> Case:
    strip = pattern(600, 40)
    png(folder / "a.png", strip.T)
    sources = [(folder / "a.png").read_bytes()]
    for number, how in enumerate(
        ({}, *({"compression": one, "rowsperstrip": 5} for one in ("zstd", "zlib", "lzw")))
    ):
        tiff(folder / f"{number}.tif", strip.T, **how)
        sources.append((folder / f"{number}.tif").read_bytes())
    tiff(folder / "tiles.tif", strip.T, tile=(16, 32), compression="zlib", bigtiff=True)
    sources.append((folder / "tiles.tif").read_bytes())

    def case(here: Path, rng: random.Random) -> str:
        path = here / "first"
        path.write_bytes(spoiled_bytes(rng.choice(sources), rng))
        try:
            got = read(path, rng.choice(("width", "height")))
        except SightlineError as error:
            return one_sentence(error)
        assert got.ndim == 2
        return "taken"

    return case


def tables(folder: Path) -> Case:
    """CSV and JSON files, given to the commands that read them."""
    sound = {name: (folder / name) for name in _written(folder)}

    def case(here: Path, rng: random.Random) -> str:
        words, spoiled = rng.choice(COMMANDS)
        place = here / spoiled
        place.write_bytes(spoiled_text(sound[spoiled].read_bytes(), rng))
        given = [
            str(place if word == spoiled else sound.get(word, here / word) if "." in word else word)
            for word in words
        ]
        said, told = io.StringIO(), io.StringIO()
        with redirect_stdout(said), redirect_stderr(told):
            status = command_line(given)
        assert status in (0, 2), (status, given, told.getvalue())
        if status == 0:
            return "taken"
        assert told.getvalue().count("\n") == 1 and not said.getvalue(), told.getvalue()
        return "refused"

    return case


#: the command and, last, which of its files is spoiled
COMMANDS: tuple[tuple[tuple[str, ...], str], ...] = (
    (("height", "--pose", "pose.json", "--clicks", "clicks.csv", "-o", "heights.out"), "clicks.csv"),
    (("height", "--pose", "pose.json", "--clicks", "clicks.csv", "-o", "heights.out"), "pose.json"),
    (("import-camera", "camera.json", "-o", "camera.out", "--json"), "camera.json"),
    (("distribution", "heights.csv", "--by", "lighting", "--json"), "heights.csv"),
    (("errors", "heights.csv", "--json"), "heights.csv"),
    (("adjust", "--pose", "told.json", "--passes", "passes.csv", "-o", "adjusted.out"), "passes.csv"),
    (("adjust", "--pose", "told.json", "--passes", "passes.csv", "-o", "adjusted.out"), "told.json"),
    (("catalogue", "import", "cars.csv", "--dry-run", "--json", "--data-dir", "data.folder"), "cars.csv"),
)


def _written(folder: Path) -> tuple[str, ...]:
    """Sound files of each kind."""
    rng = np.random.default_rng(7)
    heights = ["id,height_m,u_height_m,status,lighting,reference_height_m,u_random_m,shared_group,u_shared_m"]
    heights += [
        f"{n},{1.2 + 0.05 * rng.standard_normal():.4f},0.015,ok,{'daytime' if n % 3 else 'low_light'},1.21,"
        f"0.01,pose {n % 2},0.01"
        for n in range(60)
    ]
    clicks = ["id,contact_x_px,contact_y_px,target_x_px,target_y_px,inset_m,u_inset_m,target"]
    clicks += [f"{n},{300 + n},400.5,{300 + n},{220 + n},0.3,0.1,roof" for n in range(12)]
    truth, budget = truth_at(), BoardBudget()
    rows, _fleet = passes(truth, Fleet(vehicles=12, u_roof=0.01), rng)
    header = (*NEEDED, *OPTIONS)
    seen = [",".join(header), *(",".join(str(row.get(name, "")) for name in header) for row in rows)]
    made = {
        "pose.json": json.dumps(pose_to_dict(pose_of(Scene(Lens(), (-0.7, -3.0, 1.4), 18.0, 4.0)))),
        "told.json": json.dumps(told_pose(truth, budget, prior_covariance(truth, budget), rng)),
        "camera.json": json.dumps(camera_to_dict(camera_of(Lens()))),
        "heights.csv": "\n".join(heights) + "\n",
        "clicks.csv": "\n".join(clicks) + "\n",
        "passes.csv": "\n".join(seen) + "\n",
        "cars.csv": "make,model,year_from,height_m,taillight_m\nAudi,A3,2012,1.43,0.71\nKia,Rio,2017,1.45,\n",
    }
    for name, text in made.items():
        (folder / name).write_text(text)
    engine = make_engine(f"sqlite:///{folder / 'data.folder' / 'sightline.db'}")
    migrate(engine)
    engine.dispose()
    return (*made, "data.folder")


def packages(folder: Path) -> Case:
    place = Path(os.environ[PACKAGE])
    found = [path for path in place.rglob("*") if path.is_file()]
    files = {path.relative_to(place).as_posix(): path.read_bytes() for path in found}
    _packed(folder / "whole.zip", files)
    whole = (folder / "whole.zip").read_bytes()
    assert check_export(folder / "whole.zip")["ok"]

    def case(here: Path, rng: random.Random) -> str:
        path = here / "package.zip"
        if rng.random() < 0.5:
            path.write_bytes(spoiled_bytes(whole, rng))
        else:
            _spoiled_and_packed(path, dict(files), rng)
        try:
            return "sound" if check_export(path)["ok"] else "refused"
        except SightlineError as error:
            return one_sentence(error)

    return case


def _spoiled_and_packed(path: Path, files: dict[str, bytes], rng: random.Random) -> None:
    """A ZIP that opens, with one file spoiled, gone, twice, huge or under a name that leads elsewhere."""
    name = rng.choice(sorted(files))
    kind = rng.randrange(5)
    if kind == 0:
        files[name] = spoiled_bytes(files[name] or b"\0", rng)
    elif kind == 1:
        del files[name]
    elif kind == 2:
        files[rng.choice(("../", "/", "C:\\", "a/../../", "\0")) + name] = files[name]
    elif kind == 3:
        files[name] = bytes(rng.randrange(1, 80) << 20)
    _packed(path, files)
    if kind == 4:
        link = zipfile.ZipInfo("measurements.csv")
        link.external_attr = 0o120777 << 16
        with warnings.catch_warnings(), zipfile.ZipFile(path, "a") as archive:
            warnings.simplefilter("ignore", UserWarning)  # the name is there twice, on purpose
            archive.writestr(link, "/etc/passwd")


def _packed(path: Path, files: dict[str, bytes]) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)


ROOMS: dict[str, Callable[[Path], Case]] = {
    "videos": videos,
    "pictures": pictures,
    "strips": strips,
    "tables": tables,
    "packages": packages,
}


def main(room: str, first: int, count: int) -> None:
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        case = ROOMS[room](folder)
        for seed in range(first, first + count):
            with tempfile.TemporaryDirectory(dir=folder) as here:
                start = time.monotonic()
                came = case(Path(here), random.Random(f"{room} {seed}"))
                line = {"seed": seed, "came": came, "s": round(time.monotonic() - start, 3), "mb": peak_mb()}
            print(json.dumps(line), flush=True)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
