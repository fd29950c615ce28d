"""Holding the road poses of a package against the audit chain."""

from collections.abc import Mapping
from typing import Any

from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay
from sightline.infra.csv_package.verify import check_records
from sightline.poses.csv import POSES, pose_path


def check_poses(files: Files, replay: Replay) -> None:
    """Poses are those whose content the chain vouches for. Raises Damaged."""
    contents = {number: told["content_sha256"] for number, told in replay.of("pose").items()}
    check_records(files, "pose", POSES, pose_path, contents, _values)


def _values(record: Mapping[str, Any]) -> Mapping[str, Any]:
    document = record["document"]
    board = document.get("board") or {}
    values = {**document, **board, **record}
    size = {f"board_{name}": board.get(name) for name in ("columns", "rows")}
    return {**values, **size, "board_distance_m": values.get("distance_m")}
