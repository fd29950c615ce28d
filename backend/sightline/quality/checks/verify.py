"""Holding the tyre contacts of a package against the audit chain."""

from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay, hold_all
from sightline.quality.checks.csv import WHEEL_PAIRS


def check_wheel_pairs(files: Files, replay: Replay) -> None:
    """Tyre contacts are each vehicle's newest as its events tell, and none is missing. Raises Damaged."""
    newest = {told["vehicle_id"]: told for _, told in sorted(replay.of("wheel_pair").items())}
    standing = (
        told for id_, told in newest.items() if not (told["withdrawn"] or replay.is_gone("vehicle", id_))
    )
    hold_all(files, WHEEL_PAIRS, standing)
