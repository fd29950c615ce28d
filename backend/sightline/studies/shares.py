"""What a study says of its vehicles themselves: shares of their classes, errors of their roofs."""

from __future__ import annotations

import numpy as np

from sightline.results.measured_columns_query import CATEGORIES, LIGHTING
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.study_figures import Drawn, StudyFigure, share_of
from sightline.studies.places import Places, design_of
from sightline.studies.records import ClassShare, ErrorFigure, Fleet, Floats, Ints, StudiedHeights
from sightline.studies.weighted import LEAST, sample_of, where


def class_shares(cars: tuple[Ints, Ints, Ints], places: Places, fleet: Fleet | None) -> list[ClassShare]:
    """Shares of classes on the road, by the draw alone: the fleet's own stand beside them."""
    package, category, lighting = cars
    of_fleet = fleet.margins.get("category", {}) if fleet else {}
    found = []
    for group, rows in [
        ("all", category >= 0),
        *((w, (category >= 0) & (lighting == n)) for n, w in enumerate(LIGHTING)),
    ]:
        if np.count_nonzero(rows) < LEAST:
            continue
        drawn = Drawn(design_of(package[rows], places))
        for n, word in enumerate(CATEGORIES):
            chosen = category[rows] == n
            if chosen.any():
                share = share_of(drawn, chosen)
                found.append(ClassShare(group, word, int(chosen.sum()), share, of_fleet.get(word)))
    return found


def error_figures(rows: StudiedHeights, places: Places) -> list[ErrorFigure]:
    """Bias, MAE, RMSE and SD of roofs against their makers' heights, by the draw: of errors, not fleets."""
    known = np.isfinite(rows.reference_m)
    found = []
    for group, wanted in [
        ("overall", known),
        *((w, known & (rows.lighting == n)) for n, w in enumerate(LIGHTING)),
    ]:
        chosen = where(rows, wanted)
        n = len(chosen.height_m)
        if n < LEAST:
            continue
        error = chosen.height_m - chosen.reference_m
        sample = sample_of(chosen)
        shared: tuple[SharedErrors, ...] = sample.shared
        drawn = Drawn(design_of(chosen.package, places), shared)
        found += [ErrorFigure(group, name, n, value) for name, value in _figures_of(error, drawn).items()]
    return found


def _figures_of(error: Floats, drawn: Drawn) -> dict[str, StudyFigure]:
    share = drawn.design.weight / drawn.design.weight.sum()
    bias, mae = float(share @ error), float(share @ np.abs(error))
    square = float(share @ error**2)
    sd2 = max(square - bias**2, 1e-18)
    return {
        "bias_m": drawn.figure(bias, error - bias, height=True),
        "mae_m": drawn.figure(mae, np.abs(error) - mae),
        "rmse_m": drawn.figure(np.sqrt(square), (error**2 - square) / (2.0 * np.sqrt(max(square, 1e-18)))),
        "sd_m": drawn.figure(np.sqrt(sd2), ((error - bias) ** 2 - sd2) / (2.0 * np.sqrt(sd2))),
    }
