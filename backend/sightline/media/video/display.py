"""Pictures to look at, never to measure on: what is dark made visible.

The frame is decoded and checked against its checksum as ever; only the copy that goes to the screen is
changed. Pixels stay where they are, so a click on the brightened picture is the same click.
"""

import cv2
import numpy as np

from sightline.enums import Display
from sightline.media.video.picture import Bgr

_CLIP = 2.5
_TILES = 8
_AIM = 0.42  # mean luminance that the gamma aims at, of 1
_LEAST_GAMMA = 0.35


def shown_as(image: Bgr, display: Display) -> Bgr:
    """The picture (h, w, 3) BGR as it is asked for."""
    return brighten_picture(image) if display == "bright" else image


def brighten_picture(image: Bgr) -> Bgr:
    """Gamma towards a middle grey, then local contrast (CLAHE) on luminance alone; a bright one stays so."""
    lab = cv2.cvtColor(image, cv2.COLOR_BGR2LAB)
    light = np.asarray(lab[..., 0], np.uint8)
    mean = max(float(cv2.mean(light)[0]) / 255.0, 1e-3)
    gamma = float(np.clip(np.log(_AIM) / np.log(min(mean, 0.999)), _LEAST_GAMMA, 1.0))
    table = np.round(255.0 * np.power(np.arange(256) / 255.0, gamma)).astype(np.uint8)
    # chroma grows with the luminance it belongs to, or the picture would turn grey
    gain = np.where(light > 0, table[light] / np.maximum(light, 1).astype(np.float32), 1.0)
    gain = np.clip(gain, 1.0, 2.5)[..., None]
    chroma = np.clip((lab[..., 1:].astype(np.float32) - 128.0) * gain + 128.5, 0, 255).astype(np.uint8)
    equal = cv2.createCLAHE(_CLIP, (_TILES, _TILES)).apply(cv2.LUT(light, table))
    out = np.dstack([equal, chroma])
    return np.asarray(cv2.cvtColor(out, cv2.COLOR_LAB2BGR), np.uint8)
