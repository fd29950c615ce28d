"""The command import-camera (docs/formats.md)."""

from pathlib import Path
from typing import Any

import click

from sightline.commands.files import read_text, write_json
from sightline.commands.geometry_input import parse_size
from sightline.commands.options import FILE, choice_option, json_option, output_option, tell
from sightline.enums import LensModel
from sightline.geometry.documents import camera_to_dict
from sightline.geometry.imports import read_camera


@click.command("import-camera")
@click.argument("file", type=FILE)
@output_option("camera.json to write.")
@choice_option("--model", of=LensModel, help="Lens model, if the file does not state it.")
@click.option("--size", "size_text", metavar="WxH", help="Image size, if the file does not state it.")
@click.option("--which", help="Camera to use from a file with several: left, right or its name.")
@json_option
def import_camera(
    file: Path, output: Path, model: Any, size_text: str | None, which: str | None, as_json: bool
) -> None:
    """Import a calibration: OpenCV YAML/JSON, ROS camera_info, Kalibr camchain or mrcal .cameramodel."""
    text = read_text(file, "a camera file of OpenCV, ROS, Kalibr or mrcal")
    imported = read_camera(text, str(file), model, parse_size(size_text), which)
    document = camera_to_dict(imported.camera)
    write_json(output, document)
    for note in imported.notes:
        click.echo(str(note), err=True)
    camera = imported.camera
    size = f"{camera.width_px}x{camera.height_px}"
    covariance = "no covariance" if camera.covariance is None else "with its covariance"
    tell(as_json, document, f"{output}: {camera.model} camera, {size} px, {covariance}")
