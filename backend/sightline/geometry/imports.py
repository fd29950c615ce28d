"""Cameras from other tools' files: OpenCV YAML/JSON, ROS camera_info, Kalibr camchains, mrcal .cameramodel.

All of them put pixel (0, 0) at the centre of the top-left pixel, as we do. What has no counterpart here
(other projections, skew, thin prisms) is refused in a sentence, never approximated.
"""

import ast
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import yaml

from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry.arrays import Floats
from sightline.geometry.camera import Camera
from sightline.geometry.documents import CAMERA_FORMAT, camera_from_dict

_MATRIX_KEYS = ("camera_matrix", "cameramatrix", "k", "intrinsic_matrix", "intrinsics", "mtx", "m1", "k1")
_LENS_KEYS = (
    "distortion_coefficients", "dist_coeffs", "distcoeffs", "dist_coeff", "distortion", "d", "dist", "d1",
)  # fmt: skip
_SIZE_KEYS = ("image_size", "imagesize", "resolution", "img_size", "size", "imagersize")
_WIDTH_KEYS = ("image_width", "width", "width_px", "imagewidth")
_HEIGHT_KEYS = ("image_height", "height", "height_px", "imageheight")
_BROWN_WORDS = {"plumb_bob", "rational_polynomial", "radtan", "brown", "brown_conrady", "opencv"}
_FISHEYE_WORDS = {"equidistant", "fisheye", "kannala_brandt", "kannala_brandt4"}
_LARGEST_TANGENTIAL = 0.005  # a real lens's p1, p2 stay well below


@dataclass(frozen=True)
class Imported:
    """A camera, and what had to be decided on the way, in words."""

    camera: Camera
    notes: tuple[str, ...] = ()


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
    """Safe YAML that also reads OpenCV's matrices; without aliases, which can make a small file huge."""

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("aliases are not read")
        return super().compose_node(parent, index)


def _matrix_node(loader: yaml.SafeLoader, node: yaml.Node) -> Any:
    if isinstance(node, yaml.MappingNode):
        return loader.construct_mapping(node, deep=True)
    raise yaml.constructor.ConstructorError(None, None, "an opencv-matrix must be a mapping", node.start_mark)


_Loader.add_constructor("tag:yaml.org,2002:opencv-matrix", _matrix_node)


def read_camera(
    text: str,
    file_name: str,
    model: LensModel | None = None,
    size: tuple[int, int] | None = None,
    which: str | None = None,
) -> Imported:
    """The camera in another tool's file. Raises BadInput in one sentence that names the file.

    model: for files of four coefficients that do not say which they are; size: for files without the
    picture's size; which: the camera's key in a Kalibr chain of several.
    """
    data = _parsed(text, file_name)
    if data.get("format") == CAMERA_FORMAT:
        return Imported(camera_from_dict(data, file_name))
    notes: list[str] = []
    if "lensmodel" in data:
        found = _mrcal(data, file_name)
    elif any(isinstance(v, Mapping) and "camera_model" in v for v in data.values()):
        found = _kalibr(data, file_name, which, notes)
    else:
        found = _opencv_or_ros(data, file_name)
    return Imported(_checked(found, file_name, model, size, notes), tuple(notes))


def _parsed(text: str, file_name: str) -> dict[str, Any]:
    text = text.lstrip("\ufeff")
    try:
        if "lensmodel" in text:
            data = ast.literal_eval(text.strip())
        elif text.lstrip().startswith("{"):
            data = json.loads(text)
        else:
            lines = text.splitlines()
            body = lines[1:] if lines and lines[0].startswith("%YAML") else lines
            data = yaml.load("\n".join(body), _Loader)
    except (ValueError, SyntaxError, yaml.YAMLError, RecursionError, MemoryError):
        raise BadInput("geometry-no-readable-camera-file-give-opencv", file_name=file_name) from None
    if not isinstance(data, dict) or not data:
        raise BadInput("geometry-holds-no-camera-give-opencv-yaml", file_name=file_name)
    return {str(key): value for key, value in data.items()}


def _numbers(value: Any, what: str, file_name: str) -> Floats:
    """A flat array out of a list, nested lists, or {rows, cols, data}."""
    if isinstance(value, Mapping):
        value = value.get("data")
    try:
        out = np.array(value, dtype=np.float64).ravel()
    except (TypeError, ValueError):
        raise BadInput(
            "geometry-not-list-numbers-export-file-again", file_name=file_name, what=what
        ) from None
    if not np.isfinite(out).all():
        raise BadInput("geometry-holds-values-not-finite-calibrate-again", file_name=file_name, what=what)
    return out


def _first(data: Mapping[str, Any], keys: tuple[str, ...]) -> Any:
    lower = {key.lower(): value for key, value in data.items()}
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
            raise BadInput("geometry-image-size-must-two-numbers-width", file_name=file_name)
        width, height = values
    values = _numbers([width, height], "the image size", file_name)
    if (values < 2).any() or (values > 100_000).any() or (values != np.rint(values)).any():
        raise BadInput("geometry-image-size-must-two-whole-numbers", file_name=file_name)
    return int(values[0]), int(values[1])


def _model_word(word: Any, file_name: str) -> LensModel | None:
    if word is None or str(word).strip() == "":
        return None
    text = str(word).strip().lower()
    if text in _BROWN_WORDS:
        return "brown"
    if text in _FISHEYE_WORDS:
        return "fisheye"
    raise BadInput("geometry-distortion-model-not-supported-plumb-bob", file_name=file_name, word=word)


def _opencv_or_ros(data: Mapping[str, Any], file_name: str) -> _Found:
    inner = data.get("camera_info")
    data = inner if isinstance(inner, Mapping) else data
    raw, lens = _first(data, _MATRIX_KEYS), _first(data, _LENS_KEYS)
    if raw is None:
        raise BadInput("geometry-holds-no-camera-matrix-camera-matrix", file_name=file_name)
    k = _numbers(raw, "the camera matrix", file_name)
    if len(k) != 9 or abs(k[8] - 1) > 1e-6 or np.abs(k[[3, 6, 7]]).max() > 1e-9:
        raise BadInput("geometry-camera-matrix-must-3x3-0-0", file_name=file_name)
    if abs(k[1]) > 1e-6 * abs(k[0]):
        raise BadInput("geometry-camera-matrix-skew-which-not-supported", file_name=file_name)
    for key in ("binning_x", "binning_y"):
        if isinstance(data.get(key), int | float) and data[key] > 1:
            raise BadInput(
                "geometry-give-camera-info-unbinned-pictures", file_name=file_name, key=key, data=data[key]
            )
    model = _model_word(data.get("distortion_model"), file_name)
    if model is None and "fisheye_model" in data:
        model = "fisheye" if data["fisheye_model"] else "brown"
    rms = _first(data, ("rms_px", "rms", "avg_reprojection_error", "reprojection_error"))
    return _Found(
        matrix=k[[0, 4, 2, 5]],
        lens=np.zeros(5) if lens is None else _numbers(lens, "the distortion", file_name),
        model="brown" if lens is None and model is None else model,
        size=_size(data, file_name),
        name=str(data.get("camera_name") or data.get("name") or ""),
        rms_px=float(rms) if isinstance(rms, int | float) and np.isfinite(rms) else None,
    )


def _kalibr(data: Mapping[str, Any], file_name: str, which: str | None, notes: list[str]) -> _Found:
    cameras = {k: v for k, v in data.items() if isinstance(v, Mapping) and "camera_model" in v}
    name = which or next(iter(cameras))
    if name not in cameras:
        raise BadInput(
            "geometry-holds-no-camera-holds", file_name=file_name, which=which, cameras=", ".join(cameras)
        )
    if which is None and len(cameras) > 1:
        notes.append(f"{file_name} holds {', '.join(cameras)}; {name} was taken.")
    one = cameras[name]
    if one["camera_model"] != "pinhole":
        raise BadInput(
            "geometry-camera-model-not-supported-calibrate-pinhole",
            file_name=file_name,
            camera_model=one["camera_model"],
        )
    intrinsics = _numbers(one.get("intrinsics"), "intrinsics", file_name)
    if len(intrinsics) != 4:
        raise BadInput("geometry-intrinsics-must-four-numbers-fu-fv", file_name=file_name)
    word = str(one.get("distortion_model") or "none")
    lens = _numbers(one.get("distortion_coeffs") or [], "distortion_coeffs", file_name)
    model: LensModel | None = "brown" if word == "none" else _model_word(word, file_name)
    lens = np.zeros(5) if word == "none" else lens
    return _Found(intrinsics, lens, model, _size(one, file_name), name)


def _mrcal(data: Mapping[str, Any], file_name: str) -> _Found:
    word = str(data["lensmodel"])
    wanted = {"LENSMODEL_PINHOLE": 0, "LENSMODEL_OPENCV4": 4, "LENSMODEL_OPENCV5": 5, "LENSMODEL_OPENCV8": 8}
    if word not in wanted:
        raise BadInput("geometry-lens-model-not-supported-convert-mrcal", file_name=file_name, word=word)
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


def _checked(
    found: _Found, file_name: str, model: LensModel | None, size: tuple[int, int] | None, notes: list[str]
) -> Camera:
    fx, fy, cx, cy = (float(v) for v in found.matrix)
    size = found.size or size
    if size is None:
        raise BadInput("geometry-not-say-how-large-pictures-add", file_name=file_name)
    if fx <= 0 or fy <= 0:
        raise BadInput("geometry-focal-lengths-must-positive-numbers-pixels", file_name=file_name)
    if not (-size[0] < cx < 2 * size[0] and -size[1] < cy < 2 * size[1]):
        raise BadInput("geometry-principal-point-lies-far-outside-picture", file_name=file_name)
    chosen = found.model or model or _guess(found.lens, file_name, notes)
    name = found.name or file_name.rsplit("/", 1)[-1].rsplit(".", 1)[0]
    lens = _trimmed(found.lens, chosen, file_name)
    return Camera(
        name=name,
        width_px=size[0],
        height_px=size[1],
        model=chosen,
        fx_px=fx,
        fy_px=fy,
        cx_px=cx,
        cy_px=cy,
        distortion=lens,
        rms_px=found.rms_px,
    )


def _guess(lens: Floats, file_name: str, notes: list[str]) -> LensModel:
    """Four coefficients may be k1 k2 p1 p2 or a fisheye's k1..k4; more are Brown's."""
    if len(lens) != 4 or not lens.any():
        return "brown"
    fisheye = float(np.abs(lens[2:]).max()) > _LARGEST_TANGENTIAL
    taken = "fisheye k1 k2 k3 k4" if fisheye else "k1 k2 p1 p2"
    notes.append(
        f"{file_name} does not name its distortion model; its four coefficients were read as {taken} (choose "
        "with --model)."
    )
    return "fisheye" if fisheye else "brown"


def _trimmed(lens: Floats, model: LensModel, file_name: str) -> Floats:
    if model == "fisheye":
        if len(lens) != 4:
            raise BadInput(
                "geometry-fisheye-model-needs-four-coefficients-file", file_name=file_name, count=len(lens)
            )
        return lens
    if len(lens) > 8 and lens[8:].any():
        raise BadInput("geometry-thin-prism-tilt-coefficients-not-supported", file_name=file_name)
    lens = lens[:8]
    if len(lens) == 4:
        return np.append(lens, 0.0)
    if len(lens) not in (0, 5, 8):
        raise BadInput(
            "geometry-distortion-coefficients-4-5-8-supported", file_name=file_name, count=len(lens)
        )
    return lens if len(lens) else np.zeros(5)
