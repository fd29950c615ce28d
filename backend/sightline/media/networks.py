"""The networks of the proposals, run by OpenCV; their weights lie beside this file."""

from pathlib import Path
from typing import Any

import cv2
import numpy as np

from sightline.proposals.canvas import Values
from sightline.proposals.keypoints import Networks

WEIGHTS = Path(__file__).parent / "weights"


def proposal_networks() -> Networks:
    """Both networks, read anew: an OpenCV network must not be run by two threads at once."""
    coarse, fine = (cv2.dnn.readNetFromONNX(str(WEIGHTS / f"{name}.onnx")) for name in ("coarse", "fine"))

    def look(views: Values) -> Values:
        return _run(coarse, views, ("maps",))[0]

    def look_closely(views: Values) -> tuple[Values, Values]:
        maps, stats = _run(fine, views, ("maps", "stats"))
        return maps, stats

    return Networks(look, look_closely)


def _run(net: Any, views: Values, outputs: tuple[str, ...]) -> list[Values]:
    net.setInput(np.ascontiguousarray(views, np.float32))
    return [np.asarray(one, np.float32) for one in net.forward(list(outputs))]
