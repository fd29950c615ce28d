"""What lens and sensor do: point spread, vignetting, noise, eight bits."""

from functools import lru_cache

import cv2
import numpy as np

from tests.simulation.camera import Floats, Image
from tests.simulation.light import Light

BANK = 4


@lru_cache(maxsize=8)
def _noise_bank(height: int, width: int, seed: int) -> Floats:
    rng = np.random.default_rng(seed + 4242)
    bank: Floats = rng.standard_normal((BANK, height + 96, width + 96, 3), dtype=np.float32)
    # a sensor's colour noise is partly common to the three channels after demosaicing
    bank = 0.55 * bank + 0.62 * bank.mean(-1, keepdims=True)
    bank.flags.writeable = False
    return bank


@lru_cache(maxsize=8)
def _vignette(height: int, width: int, strength: float) -> Floats:
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    r2 = ((x - width / 2) ** 2 + (y - height / 2) ** 2) / (width / 2) ** 2
    gain = (1 - strength * r2 + 0.10 * strength * r2 * r2).astype(np.float32)
    out = np.stack([gain, gain, gain], -1)
    out.flags.writeable = False
    return out


def expose(frame: Floats, light: Light, seed: int, n: int) -> Image:
    """Turns a float picture (h, w, 3) into the sensor's 8-bit picture of frame n."""
    h, w = frame.shape[:2]
    out: Floats = cv2.GaussianBlur(frame, (5, 5) if light.blur_px < 0.8 else (7, 7), light.blur_px)
    out *= _vignette(h, w, 0.13 if not light.low else 0.17)
    rng = np.random.default_rng((seed, n))
    k, dy, dx = int(rng.integers(BANK)), int(rng.integers(96)), int(rng.integers(96))
    noise = _noise_bank(h, w, seed)[k, dy : dy + h, dx : dx + w]
    gain = np.float32(light.noise * float(rng.choice([-1.0, 1.0])))
    cv2.scaleAdd(noise, float(gain), out, out)
    return np.asarray(cv2.convertScaleAbs(np.maximum(out, 0)), np.uint8)


def sensor(frame: Floats, noise: float, blur_px: float, seed: int) -> Image:
    """The same for a single still with its own noise and blur (lab pictures)."""
    rng = np.random.default_rng(seed)
    out = cv2.GaussianBlur(frame, (7, 7), blur_px) * _vignette(*frame.shape[:2], 0.12)
    out = out + rng.normal(0, noise, frame.shape)
    return np.clip(np.round(out), 0, 255).astype(np.uint8)
