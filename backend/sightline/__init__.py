"""Heights and motion of vehicles from roadside cameras: what other programs import (docs/library.md).

Each name is loaded when it is first asked for: `import sightline` itself loads nothing.
"""

from importlib import import_module
from typing import Any

_ROOM_OF = {
    "Board": "geometry.board",
    "Camera": "geometry.camera",
    "Corners": "geometry.corners",
    "Crossings": "linescan.parts",
    "Known": "adjustment.observed",
    "ObservedPass": "adjustment.observed",
    "Passage": "linescan.parts",
    "Reference": "geometry.road_pose",
    "Rig": "linescan.parts",
    "RiskPoints": "statistics.acceptance",
    "RoadPose": "geometry.road_pose",
    "Site": "geometry.site",
    "adjust": "adjustment.adjust",
    "calibrate": "geometry.calibration",
    "camera_from_dict": "geometry.documents",
    "camera_to_dict": "geometry.documents",
    "crest_constant": "sightdistance.curves",
    "crest_length": "sightdistance.curves",
    "error_table": "statistics.errors",
    "expanded": "coverage",
    "find_board": "geometry.corners",
    "gauge": "statistics.repeatability",
    "line_height": "linescan.line_height",
    "measure_direct": "linescan.direct",
    "measure_frames": "geometry.multiframe",
    "measure_height": "geometry.height",
    "measure_heights": "geometry.height",
    "plain_camera": "geometry.site",
    "plan_lines": "linescan.planner",
    "plan_site": "geometry.plan",
    "pose_from_corners": "geometry.pose",
    "pose_from_dict": "geometry.documents",
    "pose_to_dict": "geometry.documents",
    "project": "geometry.camera",
    "read_camera": "geometry.imports",
    "sample_of_measurements": "statistics.total_uncertainty",
    "single_plan": "statistics.acceptance",
    "site_pose": "geometry.site",
    "solve_crossings": "linescan.equations",
    "solve_line_pose": "linescan.line_pose",
    "stopping_distance": "sightdistance.distances",
    "total_figures": "statistics.total_uncertainty",
    "undistort": "geometry.camera",
}

__all__ = list(_ROOM_OF)


def __getattr__(name: str) -> Any:
    if name not in _ROOM_OF:
        raise AttributeError(f"module 'sightline' has no attribute {name!r}")
    return getattr(import_module(f"sightline.{_ROOM_OF[name]}"), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *_ROOM_OF])
