"""camera.json and pose.json (docs/formats.md) as dicts, both ways. Reading refuses by key, in a sentence."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, cast, get_args

import numpy as np

from sightline.arrays import Floats
from sightline.enums import BoardSide, LensModel
from sightline.errors import BadInput
from sightline.geometry.arrays import is_covariance
from sightline.geometry.board_errors import BOWS
from sightline.geometry.camera import Camera, View
from sightline.geometry.road_pose import (
    DEFAULT_U_HEIGHT_M,
    DEFAULT_U_LEAN_RAD,
    POSE_NAMES,
    BoardOnRoad,
    RoadPose,
)
from sightline.messages.said import Said

CAMERA_FORMAT = "sightline-camera-1"
POSE_FORMAT = "sightline-pose-1"
_OF_CAMERA = ("name", "width_px", "height_px", "model", "fx_px", "fy_px", "cx_px", "cy_px")
_LENGTHS: dict[LensModel, tuple[int, ...]] = {"brown": (4, 5, 8), "fisheye": (4,)}


def _to_lists(matrix: Floats | None) -> list[list[float]] | None:
    return None if matrix is None else [[float(v) for v in row] for row in matrix]


def camera_to_dict(camera: Camera) -> dict[str, Any]:
    """The camera as `camera.json` has it (docs/formats.md).

    Parameters
    ----------
    camera : Camera

    Returns
    -------
    dict
        JSON values: lengths in px, arrays as lists.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> sightline.camera_to_dict(camera)["format"]
    'sightline-camera-1'
    """
    return {
        "format": CAMERA_FORMAT,
        **{name: getattr(camera, name) for name in _OF_CAMERA},
        "distortion": [float(v) for v in camera.distortion],
        "rms_px": camera.rms_px,
        "parameters": list(camera.parameters),
        "covariance": _to_lists(camera.covariance),
        "views": [
            {
                "file": v.file,
                "rms_px": v.rms_px,
                "used": v.used,
                "reason": None if v.reason is None else v.reason.document,
            }
            for v in camera.views
        ],
    }


def pose_to_dict(pose: RoadPose) -> dict[str, Any]:
    """The pose as `pose.json` has it, camera and joint covariance with it (docs/formats.md).

    Parameters
    ----------
    pose : RoadPose

    Returns
    -------
    dict
        JSON values: metres, radians and px, arrays as lists.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> sightline.pose_to_dict(pose)["parameters"][-6:]
    ['rx', 'ry', 'rz', 'tx', 'ty', 'tz']
    """
    board = None if pose.board is None else dict(vars(pose.board))
    return {
        "format": POSE_FORMAT,
        "camera": camera_to_dict(pose.camera),
        "cam_from_road": {
            "rotation": _to_lists(pose.rotation),
            "translation_m": [float(v) for v in pose.translation_m],
        },
        "parameters": list(pose.parameters),
        "covariance": _to_lists(pose.covariance),
        "board": board,
        "frames_used": pose.frames_used,
        "rms_px": pose.rms_px,
    }


#: No length, angle, pixel or variance is larger; the squares of much larger ones overflow.
LARGEST = 1e12


class WrittenTwice(ValueError):
    """A key that stands twice in one mapping."""


def require_single(keys: Iterable[str]) -> None:
    """Raises WrittenTwice with the first key that comes again."""
    seen: set[str] = set()
    for key in keys:
        if key in seen:
            raise WrittenTwice(key)
        seen.add(key)


def single_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of a JSON file (`object_pairs_hook`); no key may stand twice, for the last would win."""
    require_single(key for key, _ in pairs)
    return dict(pairs)


class _Reader:
    """Takes checked values out of one JSON object; every refusal names the key."""

    def __init__(self, data: object, what: str) -> None:
        if not isinstance(data, Mapping):
            raise BadInput("geometry-not-an-object", what=what)
        self.data = data
        self.what = what

    def fail(self, key: str, wanted: str) -> BadInput:
        return BadInput("geometry-key-wrong", what=self.what, key=key, wanted=wanted)

    def number(self, key: str, *, positive: bool = False, default: float | None = None) -> float:
        value = self.data.get(key, default)
        wanted = "a positive number" if positive else "a finite number"
        if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= LARGEST:
            raise self.fail(key, f"{wanted} of at most {LARGEST:.0e}")
        if positive and value <= 0:
            raise self.fail(key, wanted)
        return float(value)

    def not_negative(self, key: str, default: float) -> float:
        value = self.number(key, default=default)
        if value < 0:
            raise self.fail(key, "zero or a positive number")
        return value

    def require_format(self, wanted: str) -> None:
        found = self.data.get("format")
        if isinstance(found, str) and found != wanted:
            raise BadInput("geometry-format-is-another", what=self.what, found=found[:40], wanted=wanted)
        self.text("format", (wanted,))

    def optional(self, key: str) -> float | None:
        return None if self.data.get(key) is None else self.number(key)

    def doubt(self, key: str) -> float | None:
        """A standard uncertainty, None where it is not stated."""
        return None if self.data.get(key) is None else self.not_negative(key, 0.0)

    def whole(self, key: str, least: int, default: int | None = None) -> int:
        value = self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= LARGEST:
            raise self.fail(key, f"a whole number of at least {least}")
        return value

    def text(self, key: str, choices: Sequence[str] = (), default: str | None = None) -> str:
        value = self.data.get(key, default)
        if not isinstance(value, str) or (choices and value not in choices):
            raise self.fail(key, f"one of {', '.join(choices)}" if choices else "a text")
        return value

    def array(self, key: str, shape: tuple[int, ...] | None = None) -> Floats:
        wanted = "a list of numbers" if shape is None else f"{' x '.join(map(str, shape))} numbers"
        try:
            value = np.array(self.data.get(key), dtype=np.float64)
        except (TypeError, ValueError, OverflowError):
            raise self.fail(key, wanted) from None
        fits = value.ndim > 0 and (shape is None or value.shape == shape)
        if not fits or not (np.abs(value) <= LARGEST).all():
            raise self.fail(key, wanted)
        return value


def _covariance(read: _Reader, known: tuple[str, ...]) -> Floats | None:
    """The covariance in the order of `known`; parameters that the file does not name count as exact."""
    if read.data.get("covariance") is None:
        return None
    names = read.data.get("parameters")
    if not isinstance(names, list) or any(name not in known or names.count(name) > 1 for name in names):
        raise read.fail("parameters", f"a list of names out of {' '.join(known)}")
    matrix = read.array("covariance", (len(names), len(names)))
    if not is_covariance(matrix):
        raise read.fail("covariance", "symmetric and without negative variances")
    out = np.zeros((len(known), len(known)))
    where = [known.index(name) for name in names]
    out[np.ix_(where, where)] = 0.5 * (matrix + matrix.T)
    return out


def _views(read: _Reader) -> tuple[View, ...]:
    raw = read.data.get("views") or []
    if not isinstance(raw, list):
        raise read.fail("views", "a list")
    views = []
    for item in raw:
        one = _Reader(item, f"{read.what}, views")
        views.append(
            View(one.text("file"), one.optional("rms_px"), bool(one.data.get("used", False)), _reason(one))
        )
    return tuple(views)


def _reason(read: _Reader) -> Said | None:
    stored = read.data.get("reason")
    try:
        return None if stored is None else Said.read(stored)
    except (TypeError, LookupError, AttributeError) as error:
        raise read.fail("reason", "a text, or a code with its values") from error


def camera_from_dict(data: object, what: str = "camera.json") -> Camera:
    """Read `camera.json` (docs/formats.md).

    Parameters
    ----------
    data : object
        The file's JSON values.
    what : str
        The name used in refusals.

    Returns
    -------
    Camera

    Raises
    ------
    BadInput
        Naming the key that is missing or cannot be.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> sightline.camera_from_dict(sightline.camera_to_dict(camera)).fx_px == camera.fx_px
    True
    """
    read = _Reader(data, what)
    read.require_format(CAMERA_FORMAT)
    model = cast(LensModel, read.text("model", get_args(LensModel)))
    distortion = read.array("distortion")
    if distortion.size == 0:
        distortion = np.zeros(5 if model == "brown" else 4)
    if distortion.shape not in [(n,) for n in _LENGTHS[model]]:
        raise read.fail("distortion", f"{' or '.join(map(str, _LENGTHS[model]))} numbers for model {model}")
    camera = Camera(
        name=read.text("name", default="camera"),
        width_px=read.whole("width_px", 2),
        height_px=read.whole("height_px", 2),
        model=model,
        fx_px=read.number("fx_px", positive=True),
        fy_px=read.number("fy_px", positive=True),
        cx_px=read.number("cx_px"),
        cy_px=read.number("cy_px"),
        distortion=distortion,
        rms_px=read.optional("rms_px"),
        covariance=None,
        views=_views(read),
    )
    return replace(camera, covariance=_covariance(read, camera.parameters))


def _board(data: object, what: str) -> BoardOnRoad | None:
    if data is None:
        return None
    read = _Reader(data, f"{what}, board")
    return BoardOnRoad(
        columns=read.whole("columns", 2),
        rows=read.whole("rows", 2),
        square_m=read.number("square_m", positive=True),
        reference=cast(BoardSide, read.text("reference", get_args(BoardSide))),
        reference_height_m=read.number("reference_height_m"),
        u_reference_height_m=read.not_negative("u_reference_height_m", DEFAULT_U_HEIGHT_M),
        u_lean_rad=read.not_negative("u_lean_rad", DEFAULT_U_LEAN_RAD),
        distance_m=read.number("distance_m", default=0.0),
        u_square_m=read.doubt("u_square_m"),
        u_bow_m=read.doubt("u_bow_m"),
        bow_response=None
        if read.data.get("bow_response") is None
        else tuple(map(tuple, read.array("bow_response", (BOWS, len(POSE_NAMES))).tolist())),
    )


def pose_from_dict(data: object, what: str = "pose.json") -> RoadPose:
    """Read `pose.json` (docs/formats.md).

    Parameters
    ----------
    data : object
        The file's JSON values.
    what : str
        The name used in refusals.

    Returns
    -------
    RoadPose

    Raises
    ------
    BadInput
        Naming the key that is missing or cannot be.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> round(float(sightline.pose_from_dict(sightline.pose_to_dict(pose)).centre_m[2]), 3)
    1.4
    """
    read = _Reader(data, what)
    read.require_format(POSE_FORMAT)
    camera = camera_from_dict(read.data.get("camera"), f"{what}, camera")
    inner = _Reader(read.data.get("cam_from_road"), f"{what}, cam_from_road")
    rotation = inner.array("rotation", (3, 3))
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > 1e-4 or np.linalg.det(rotation) < 0:
        raise inner.fail("rotation", "a right-handed rotation matrix")
    return RoadPose(
        camera=camera,
        rotation=rotation,
        translation_m=inner.array("translation_m", (3,)),
        covariance=_covariance(read, camera.parameters + POSE_NAMES),
        board=_board(read.data.get("board"), what),
        frames_used=read.whole("frames_used", 0, default=0),
        rms_px=read.optional("rms_px"),
    )


def camera_across_m(document: Mapping[str, Any]) -> float:
    """Where the camera of a pose.json stands along the road's Y (C = -R' t), metres; NaN without a place."""
    place = document.get("cam_from_road")
    if not place:
        return float("nan")
    rotation = np.asarray(place["rotation"], dtype=np.float64)
    return float(-rotation[:, 1] @ np.asarray(place["translation_m"], dtype=np.float64))
