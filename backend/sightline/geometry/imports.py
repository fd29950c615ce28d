"""Cameras from other tools' files: OpenCV YAML/JSON, ROS camera_info, Kalibr camchains, mrcal .cameramodel.

All of them put pixel (0, 0) at the centre of the top-left pixel, as we do. What has no counterpart here
(other projections, skew, thin prisms) is refused in a sentence, never approximated. A file may hold several
cameras: a Kalibr chain, two eyes of a stereo rig, several YAML documents; which one was read is said.
"""

import ast
import json
import re
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import yaml

from sightline.arrays import Floats
from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.geometry.documents import (
    CAMERA_FORMAT,
    LARGEST,
    WrittenTwice,
    camera_from_dict,
    require_single,
    single_keys,
)
from sightline.geometry.verdict import lens_warnings, require_plausible
from sightline.messages.said import Said

_MATRIX_KEYS = ("camera_matrix", "cameramatrix", "k", "intrinsic_matrix", "intrinsics", "mtx", "m")
_LENS_KEYS = (
    "distortion_coefficients", "dist_coeffs", "distcoeffs", "dist_coeff", "distortion_coeffs", "distortion",
    "d", "dist",
)  # fmt: skip
_SIZE_KEYS = ("image_size", "imagesize", "resolution", "img_size", "size", "imagersize")
_WIDTH_KEYS = ("image_width", "width", "width_px", "imagewidth")
_HEIGHT_KEYS = ("image_height", "height", "height_px", "imageheight")
_BROWN_WORDS = {"plumb_bob", "rational_polynomial", "radtan", "brown", "brown_conrady", "opencv"}
_FISHEYE_WORDS = {"equidistant", "fisheye", "kannala_brandt", "kannala_brandt4"}
_LARGEST_TANGENTIAL = 0.005  # a real lens's p1, p2 stay well below
_MOST_CHARACTERS = 2_000_000  # YAML takes seconds a megabyte; a message of a topic has a thousand
_MOST_SHARED = 16  # numbers of a list that an alias repeats: a matrix of 4x4
# A name of one of several cameras in one file's keys: M1, cameraMatrix2, D_left, right_camera_matrix, LEFT.K.
_SIDE_BEHIND = re.compile(r"(.+?)[_.\-/ ]?(left|right|[0-9]|(?<=[_.\-/ ])[lr])")
_SIDE_BEFORE = re.compile(r"(left|right)[_.\-/ ]?(.+)")
_SIDES = {"l": "left", "r": "right", "1": "left", "2": "right"}  # 1 and 2 where a file holds just those
_NAMES = ("camera_name", "name", "frame_id")


@dataclass(frozen=True)
class Imported:
    """A camera, and what had to be decided on the way, in words."""

    camera: Camera
    notes: tuple[Said, ...] = ()


@dataclass(frozen=True, eq=False)
class _Found:
    """What a file says, before it is checked."""

    matrix: Floats  # fx fy cx cy
    lens: Floats
    model: LensModel | None
    size: tuple[int, int] | None
    name: str
    rms_px: float | None = None


class _Loader(yaml.SafeLoader):
    """Safe YAML that also reads OpenCV's matrices; without aliases of more than a short list, which can make
    a small file huge, and without keys written twice, of which the last would win. Numbers are decimal as in
    YAML 1.2: 0720 is 720, and 1e-05, as Python writes it, is a number.
    """

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Hashable, Any]:
        require_single(str(key.value) for key, _ in node.value)
        return super().construct_mapping(node, deep=deep)

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        if self.check_event(yaml.AliasEvent):
            alias = self.peek_event()  # type: ignore[no-untyped-call]
            if not _is_short(self.anchors.get(alias.anchor)):
                raise yaml.YAMLError("this alias is not read")
        return super().compose_node(parent, index)


def _matrix_node(loader: yaml.SafeLoader, node: yaml.Node) -> Any:
    if isinstance(node, yaml.MappingNode):
        return loader.construct_mapping(node, deep=True)
    raise yaml.constructor.ConstructorError(None, None, "an opencv-matrix must be a mapping", node.start_mark)


def _is_short(node: yaml.Node | None) -> bool:
    """Whether a node is one value or a short list of values, none of them a list again."""
    if isinstance(node, yaml.SequenceNode):
        return len(node.value) <= _MOST_SHARED and all(isinstance(v, yaml.ScalarNode) for v in node.value)
    return isinstance(node, yaml.ScalarNode)


def _number_node(loader: yaml.SafeLoader, node: yaml.ScalarNode) -> float:
    text = str(loader.construct_scalar(node)).lower()
    return int(text) if _WHOLE.fullmatch(text) else float(text.replace(".inf", "inf").replace(".nan", "nan"))


_INT, _FLOAT = "tag:yaml.org,2002:int", "tag:yaml.org,2002:float"
_WHOLE = re.compile(r"[-+]?[0-9]{1,18}")
_NUMBER = re.compile(
    r"(?:[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN))\Z"
)
_Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers if tag not in (_INT, _FLOAT)]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
_Loader.add_implicit_resolver(_FLOAT, _NUMBER, list("-+.0123456789"))
for _tag in (_INT, _FLOAT):
    _Loader.add_constructor(_tag, _number_node)
_Loader.add_constructor("tag:yaml.org,2002:opencv-matrix", _matrix_node)


def read_camera(
    text: str,
    file_name: str,
    model: LensModel | None = None,
    size: tuple[int, int] | None = None,
    which: str | None = None,
) -> Imported:
    """Read the camera in another tool's file: OpenCV, ROS, Kalibr, mrcal.

    Parameters
    ----------
    text : str
        What the file says.
    file_name : str
        Its name, for refusals and for the kind of file.
    model : {"brown", "fisheye"}, optional
        For files of four coefficients that do not say which they are.
    size : (int, int), optional
        Width and height in px, for files without the picture's size.
    which : str, optional
        The camera's name in a file of several ("left", "cam1", or the place of its YAML document, from 1).

    Returns
    -------
    Imported
        `camera`, and `notes` of what was taken how.

    Raises
    ------
    BadInput
        In one sentence that names the file.

    Examples
    --------
    >>> import sightline
    >>> lines = (
    ...     "image_width: 640",
    ...     "image_height: 480",
    ...     "camera_name: left",
    ...     "camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 500, 240, 0, 0, 1]}",
    ...     "distortion_model: plumb_bob",
    ...     "distortion_coefficients: {rows: 1, cols: 5, data: [-0.3, 0.1, 0, 0, 0]}",
    ... )
    >>> sightline.read_camera(chr(10).join(lines), "left.yaml").camera.fx_px
    500.0
    """
    documents = _parsed(text, file_name)
    notes: list[Said] = []
    cameras = _cameras(documents)
    data = _choose_camera(cameras, file_name, which, notes)
    if data.get("format") == CAMERA_FORMAT:
        camera = camera_from_dict(data, file_name)
        require_plausible(camera, file_name)
        return Imported(camera)
    if "lensmodel" in data:
        stated = _mrcal(data, file_name)
    elif "camera_model" in data:
        stated = _kalibr(data, file_name)
    else:
        stated = _opencv_or_ros(data, file_name, size, notes)
    camera = _make_camera(stated, file_name, model, size, notes)
    return Imported(camera, (*notes, *lens_warnings(camera)))


def _parsed(text: str, file_name: str) -> list[dict[str, Any]]:
    """The file's documents: one, or several in a YAML file that holds `---`."""
    if len(text) > _MOST_CHARACTERS:
        raise BadInput("geometry-file-too-large", file_name=file_name)
    text = text.lstrip("\ufeff")
    if text.lstrip().startswith("<") and "opencv_storage" in text:
        raise BadInput("geometry-opencv-xml", file_name=file_name)
    try:
        if "lensmodel" in text:
            documents = [ast.literal_eval(text.strip())]
        elif text.lstrip().startswith("{"):
            documents = [json.loads(text, object_pairs_hook=single_keys)]
        else:
            lines = text.splitlines()
            body = lines[1:] if lines and lines[0].startswith("%YAML") else lines
            documents = [one for one in yaml.load_all("\n".join(body), _Loader) if one is not None]
    except WrittenTwice as twice:
        raise BadInput("geometry-key-written-twice", file_name=file_name, key=str(twice)) from None
    except (TypeError, ValueError, SyntaxError, yaml.YAMLError, RecursionError, MemoryError):
        raise BadInput("geometry-camera-unreadable", file_name=file_name) from None
    if not documents or not all(isinstance(one, dict) and one for one in documents):
        raise BadInput("geometry-no-camera", file_name=file_name)
    return [{str(key): value for key, value in one.items()} for one in documents]


def _cameras(documents: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """Every camera by its name. Messages of one topic that say the same are one camera."""
    cameras: dict[str, dict[str, Any]] = {}
    for place, document in enumerate(documents, start=1):
        for name, camera in (_within(document) or {_own_name(document): document}).items():
            if any(_intrinsics(camera) == _intrinsics(other) for other in cameras.values()):
                continue
            cameras[str(place) if name in cameras or not name else name] = camera
    return cameras


def _own_name(document: Mapping[str, Any]) -> str:
    header = document.get("header")
    inner = {**header, **document} if isinstance(header, Mapping) else document
    return str(_first(inner, _NAMES) or "")


def _intrinsics(camera: Mapping[str, Any]) -> dict[str, Any]:
    """What a camera says without what tells two messages of one camera apart."""
    return {key: value for key, value in camera.items() if key not in ("header", "timestamp")}


def _within(document: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """The cameras inside one document, by name: mappings of their own, or keys that end in a side or a
    number; empty where the document is one camera.
    """
    own = {key: dict(v) for key, v in document.items() if isinstance(v, Mapping) and _holds_camera(v)}
    if own:
        shared = {key: v for key, v in document.items() if not isinstance(v, Mapping)}
        return {"" if key == "camera_info" else key: {**shared, **one} for key, one in own.items()}
    known = {*_MATRIX_KEYS, *_LENS_KEYS, *_SIZE_KEYS, *_WIDTH_KEYS, *_HEIGHT_KEYS, "distortion_model"}
    shared, sided = {}, dict[str, dict[str, Any]]()
    for key, value in document.items():
        base, side = _side_of(key)
        if side and base in known and isinstance(value, list | Mapping | int | float | str):
            sided.setdefault(side, {})[base] = value
        else:
            shared[key] = value
    sided = {
        side: one for side, one in sided.items() if isinstance(_first(one, _MATRIX_KEYS), list | Mapping)
    }
    if not sided:
        return {}
    words = _SIDES if set(sided) <= {"1", "2"} else {"l": "left", "r": "right"}
    return {words.get(side, side): {**shared, **one} for side, one in sided.items()}


def _holds_camera(value: Mapping[Any, Any]) -> bool:
    matrix = _first(value, _MATRIX_KEYS)
    return "camera_model" in value or isinstance(matrix, list | Mapping)


def _side_of(key: str) -> tuple[str, str]:
    """(`camera_matrix`, `left`) of `left_camera_matrix`, (`m`, `1`) of `M1`; the side is "" where none is."""
    lower = key.lower()
    if lower in ("mtxl", "mtxr", "distl", "distr", "kl", "kr", "dl", "dr"):
        return lower[:-1], lower[-1]
    if match := _SIDE_BEFORE.fullmatch(lower):
        return match[2], match[1]
    if match := _SIDE_BEHIND.fullmatch(lower):
        return match[1], match[2]
    return lower, ""


def _choose_camera(
    cameras: Mapping[str, dict[str, Any]], file_name: str, which: str | None, notes: list[Said]
) -> dict[str, Any]:
    """The camera that is asked for, or the first; of several, which one is said."""
    names = {name or "1": name for name in cameras}
    listed = ", ".join(names)
    wanted = next(iter(names)) if which is None else which.strip().lower()
    if set(names) == set(_SIDES.values()):
        wanted = _SIDES.get(wanted, wanted)
    key = next((one for one in names if one.lower() == wanted.lower()), None)
    if key is None:
        raise BadInput("geometry-camera-not-named", file_name=file_name, which=which, cameras=listed)
    if which is None and len(names) > 1:
        notes.append(Said("import-several-cameras", file_name=file_name, cameras=listed, key=key))
    name = names[key]
    one = cameras[name]
    return one if not name or _first(one, _NAMES) else {**one, "camera_name": name}


def _numbers(value: Any, what: str, file_name: str) -> Floats:
    """A flat array out of a list, nested lists, or {rows, cols, data}."""
    shape: tuple[Any, Any] = None, None
    if isinstance(value, Mapping):
        shape = value.get("rows"), value.get("cols")
        value = value.get("data")
    try:
        if _has_truth(value):
            raise TypeError
        out = np.array(value, dtype=np.float64).ravel()
    except (TypeError, ValueError, OverflowError):
        raise BadInput("geometry-not-numbers", file_name=file_name, what=what) from None
    if not (np.abs(out) <= LARGEST).all():
        raise BadInput("geometry-values-not-finite", file_name=file_name, what=what)
    rows, columns = shape
    if isinstance(rows, int) and isinstance(columns, int) and rows * columns != len(out):
        raise BadInput(
            "geometry-rows-contradict",
            file_name=file_name,
            what=what,
            rows=rows,
            columns=columns,
            count=len(out),
        )
    return out


def _has_truth(value: Any) -> bool:
    """Whether a list holds yes or no, which NumPy would take for 1 and 0."""
    return isinstance(value, bool) or (isinstance(value, list) and any(_has_truth(one) for one in value))


def _first(data: Mapping[str, Any], keys: tuple[str, ...]) -> Any:
    lower = {str(key).lower(): value for key, value in data.items()}
    return next((lower[key] for key in keys if lower.get(key) is not None), None)


def _size(data: Mapping[str, Any], file_name: str) -> tuple[int, int] | None:
    width, height = _first(data, _WIDTH_KEYS), _first(data, _HEIGHT_KEYS)
    if width is None or height is None:
        both = _first(data, _SIZE_KEYS)
        if both is None:
            return None
        if isinstance(both, Mapping) and "width" in both:
            both = [both.get("width"), both.get("height")]
        values = _numbers(both, "the image size", file_name)
        if len(values) != 2:
            raise BadInput("geometry-size-not-two", file_name=file_name)
        width, height = values
    values = _numbers([width, height], "the image size", file_name)
    if (values < 2).any() or (values > 100_000).any() or (values != np.rint(values)).any():
        raise BadInput("geometry-size-not-whole", file_name=file_name)
    return int(values[0]), int(values[1])


def _model_word(word: Any, file_name: str) -> LensModel | None:
    if word is None or str(word).strip() == "":
        return None
    text = str(word).strip().lower()
    if text in _BROWN_WORDS:
        return "brown"
    if text in _FISHEYE_WORDS:
        return "fisheye"
    raise BadInput("geometry-distortion-unsupported", file_name=file_name, word=word)


def _opencv_or_ros(
    data: Mapping[str, Any], file_name: str, wanted: tuple[int, int] | None, notes: list[Said]
) -> _Found:
    raw, lens = _first(data, _MATRIX_KEYS), _first(data, _LENS_KEYS)
    if raw is None:
        raise BadInput("geometry-no-matrix", file_name=file_name)
    k = _numbers(raw, "the camera matrix", file_name)
    if not k.any():
        raise BadInput("geometry-camera-not-calibrated", file_name=file_name)
    if len(k) != 9 or abs(k[8] - 1) > 1e-6 or np.abs(k[[3, 6, 7]]).max() > 1e-9:
        raise BadInput("geometry-matrix-form", file_name=file_name)
    if abs(k[1]) > 1e-6 * abs(k[0]):
        raise BadInput("geometry-matrix-skew", file_name=file_name)
    for key in ("binning_x", "binning_y"):
        if isinstance(data.get(key), int | float) and data[key] > 1:
            raise BadInput("geometry-camera-info-binned", file_name=file_name, key=key, data=data[key])
    model = _model_word(data.get("distortion_model"), file_name)
    if model is None and "fisheye_model" in data:
        model = "fisheye" if data["fisheye_model"] else "brown"
    size = _size(data, file_name)
    part = _part_read(data, file_name, size, wanted, notes)
    if part is not None:
        k[2], k[5], size = k[2] - part[0], k[5] - part[1], part[2:]
    if lens is None:
        raise BadInput("geometry-states-no-distortion", file_name=file_name)
    rms = _first(data, ("rms_px", "rms", "avg_reprojection_error", "reprojection_error"))
    return _Found(
        matrix=k[[0, 4, 2, 5]],
        lens=_numbers(lens, "the distortion", file_name),
        model=model,
        size=size,
        name=str(_first(data, _NAMES[:2]) or ""),
        rms_px=float(rms) if isinstance(rms, float) and np.isfinite(rms) else None,
    )


def _part_read(
    data: Mapping[str, Any],
    file_name: str,
    full: tuple[int, int] | None,
    wanted: tuple[int, int] | None,
    notes: list[Said],
) -> tuple[int, int, int, int] | None:
    """Left, top, width and height of the part of the picture that the camera sent (ROS `roi`), pixels; None
    for the whole, which is also taken where its size is `wanted`.

    A camera_info's matrix is that of the whole picture; the principal point of the part is shifted by its
    left and top.
    """
    roi = data.get("roi")
    if not isinstance(roi, Mapping):
        return None
    numbers = _numbers(
        [roi.get(key) or 0 for key in ("x_offset", "y_offset", "width", "height")], "the roi", file_name
    )
    left, top, width, height = (int(v) for v in numbers)
    if not numbers.any() or (full is not None and (left, top, width, height) == (0, 0, *full)):
        return None
    inside = full is not None and left + width <= full[0] and top + height <= full[1]
    whole_numbers = bool((numbers == np.rint(numbers)).all())
    if full is None or not inside or not whole_numbers or min(width, height) < 2 or min(left, top) < 0:
        raise BadInput("geometry-roi-contradicts-size", file_name=file_name)
    if wanted == full:
        notes.append(Said("import-roi-whole", file_name=file_name))
        return None
    notes.append(
        Said(
            "import-roi-part",
            file_name=file_name,
            width=width,
            height=height,
            left=left,
            top=top,
            full_width=full[0],
            full_height=full[1],
        )
    )
    return left, top, width, height


def _kalibr(camera: Mapping[str, Any], file_name: str) -> _Found:
    if camera["camera_model"] != "pinhole":
        raise BadInput("geometry-model-unsupported", file_name=file_name, camera_model=camera["camera_model"])
    intrinsics = _numbers(camera.get("intrinsics"), "intrinsics", file_name)
    if len(intrinsics) != 4:
        raise BadInput("geometry-intrinsics-count", file_name=file_name)
    word, lens = camera.get("distortion_model"), camera.get("distortion_coeffs")
    if word == "none":
        word, lens = "radtan", []
    if word is None or lens is None:
        raise BadInput("geometry-states-no-distortion", file_name=file_name)
    return _Found(
        matrix=intrinsics,
        lens=_numbers(lens, "distortion_coeffs", file_name),
        model=_model_word(word, file_name),
        size=_size(camera, file_name),
        name=str(camera.get("camera_name") or ""),
    )


def _mrcal(data: Mapping[str, Any], file_name: str) -> _Found:
    word = str(data["lensmodel"])
    wanted = {"LENSMODEL_PINHOLE": 0, "LENSMODEL_OPENCV4": 4, "LENSMODEL_OPENCV5": 5, "LENSMODEL_OPENCV8": 8}
    if word not in wanted:
        raise BadInput("geometry-lens-unsupported", file_name=file_name, word=word)
    values = _numbers(data.get("intrinsics"), "intrinsics", file_name)
    if len(values) != 4 + wanted[word]:
        raise BadInput(
            "geometry-needs-intrinsics-file",
            file_name=file_name,
            word=word,
            value=4 + wanted[word],
            count=len(values),
        )
    lens = values[4:] if wanted[word] else np.zeros(5)
    return _Found(values[:4], lens, "brown", _size(data, file_name), "")


def _make_camera(
    stated: _Found, file_name: str, model: LensModel | None, size: tuple[int, int] | None, notes: list[Said]
) -> Camera:
    fx, fy, cx, cy = (float(v) for v in stated.matrix)
    size = stated.size or size
    if size is None:
        raise BadInput("geometry-no-image-size", file_name=file_name)
    if fx <= 0 or fy <= 0:
        raise BadInput("geometry-focal-not-positive", file_name=file_name)
    chosen = stated.model or model or _guess(stated.lens, file_name, notes)
    name = stated.name or file_name.rsplit("/", 1)[-1].rsplit(".", 1)[0]
    lens = _trimmed(stated.lens, chosen, file_name)
    camera = Camera(
        name=name,
        width_px=size[0],
        height_px=size[1],
        model=chosen,
        fx_px=fx,
        fy_px=fy,
        cx_px=cx,
        cy_px=cy,
        distortion=lens,
        rms_px=stated.rms_px,
    )
    if not lens.any():
        notes.append(Said("import-no-distortion", file_name=file_name))
    require_plausible(camera, file_name)
    return camera


def _guess(lens: Floats, file_name: str, notes: list[Said]) -> LensModel:
    """Four coefficients may be k1 k2 p1 p2 or a fisheye's k1..k4; more are Brown's."""
    if len(lens) != 4 or not lens.any():
        return "brown"
    fisheye = float(np.abs(lens[2:]).max()) > _LARGEST_TANGENTIAL
    taken = "fisheye k1 k2 k3 k4" if fisheye else "k1 k2 p1 p2"
    notes.append(Said("import-model-guessed", file_name=file_name, taken=taken))
    return "fisheye" if fisheye else "brown"


def _trimmed(lens: Floats, model: LensModel, file_name: str) -> Floats:
    if model == "fisheye":
        if len(lens) != 4:
            raise BadInput("geometry-fisheye-count", file_name=file_name, count=len(lens))
        return lens
    if len(lens) > 8 and lens[8:].any():
        raise BadInput("geometry-thin-prism", file_name=file_name)
    lens = lens[:8]
    if len(lens) == 4:
        return np.append(lens, 0.0)
    if len(lens) not in (0, 5, 8):
        raise BadInput("geometry-distortion-count", file_name=file_name, count=len(lens))
    return lens if len(lens) else np.zeros(5)
