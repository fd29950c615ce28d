"""Holding the photographs of an export against the audit chain."""

from collections.abc import Mapping

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay, hold
from sightline.infra.csv_package.schema import Written
from sightline.surveys.photographs.csv import FOLDER, PHOTOGRAPHS, photograph_path


def check_photographs(files: Files, replay: Replay, written: Mapping[str, Written]) -> None:
    """Every photograph is the file that its audit event names, with the caption and in the order that the
    events give, and none is missing or put in. Raises Damaged.
    """
    there = sorted(replay.standing("photograph"), key=lambda told: (told["position"], told["id"]))
    expected = (
        {**told, "position": place, "file": photograph_path(told["id"])}
        for place, told in enumerate(there, start=1)
    )
    strange = {path for path in files.paths if path.startswith(FOLDER)}
    for row in hold(files, PHOTOGRAPHS, expected, in_order=True):
        if row["file"] not in written or written[row["file"]].sha256 != row["sha256"]:
            raise Damaged("surveys-photograph-replaced", file=row["file"])
        strange.discard(row["file"])
    if strange:
        raise Damaged("surveys-no-row-put", strange=min(strange), path=PHOTOGRAPHS.key)
