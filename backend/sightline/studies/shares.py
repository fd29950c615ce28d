"""What a study says of its vehicles themselves: shares of their classes, errors of their roofs."""

import numpy as np

from sightline.arrays import Floats, Ints
from sightline.results.measured_columns_query import CATEGORIES, LIGHTING, Heights
from sightline.statistics.drawn import Drawn, reorder_design, share_of
from sightline.statistics.error_totals import ErrorTotals
from sightline.statistics.figures import TotalFigure
from sightline.statistics.shared_errors import SharedErrors
from sightline.studies.places import Places, design_of
from sightline.studies.records import ClassShare, ErrorFigure, Fleet
from sightline.studies.weighted import LEAST, sample_of

LEAST_ERRORS = 5  # for a figure of them


def class_shares(cars: tuple[Ints, Ints, Ints], places: Places, fleet: Fleet | None) -> list[ClassShare]:
    """Shares of classes on the road, by the draw alone: the fleet's own stand beside them."""
    package, category, lighting = cars
    of_fleet = fleet.margins.get("category", {}) if fleet else {}
    shares: list[ClassShare] = []
    known = category >= 0
    package, category, lighting = package[known], category[known], lighting[known]
    if len(package) < LEAST:
        return shares
    drawn = Drawn(design_of(package, places))
    for group, among in [
        ("all", np.ones(len(package), dtype=np.bool_)),
        *((w, lighting == n) for n, w in enumerate(LIGHTING)),
    ]:
        if np.count_nonzero(among) < LEAST:
            continue
        for n, word in enumerate(CATEGORIES):
            chosen = among & (category == n)
            if chosen.any():
                share = share_of(drawn, chosen, among)
                shares.append(ClassShare(group, word, int(chosen.sum()), share, of_fleet.get(word)))
    return shares


def error_figures(rows: Heights, places: Places) -> list[ErrorFigure]:
    """Bias, MAE, RMSE and SD of roofs against their makers' heights, by the draw: of errors, not fleets.

    The bias is a mean of the design; the others' intervals are those of `ErrorTotals`, weighted alike, in
    which every site there is counts as not seen yet.
    """
    rows = rows.where(np.isfinite(rows.known_m))
    design = design_of(rows.survey_id, places)
    figures = []
    for group, wanted in [
        ("overall", np.ones(len(rows), dtype=np.bool_)),
        *((w, rows.lighting == n) for n, w in enumerate(LIGHTING)),
    ]:
        chosen = rows.where(wanted)
        n = len(chosen)
        if n < LEAST_ERRORS:
            continue
        error = chosen.height_m - chosen.known_m
        sample = sample_of(chosen)
        shared: tuple[SharedErrors, ...] = sample.shared
        drawn = Drawn(reorder_design(design, wanted), shared)
        totals = ErrorTotals(error, shared, drawn.design.site, drawn.design.weight)
        figures += [
            ErrorFigure(group, name, n, value) for name, value in _figures_of(error, drawn, totals).items()
        ]
    return figures


def _figures_of(error: Floats, drawn: Drawn, totals: ErrorTotals) -> dict[str, TotalFigure]:
    share = drawn.design.weight / drawn.design.weight.sum()
    bias, square = float(share @ error), float(share @ error**2)
    mse, mae, sd = totals.mse(), totals.mae(), totals.sd()
    sd_m = float(np.sqrt(max(square - bias**2, 0.0) / (1.0 - float(np.square(share).sum()))))
    rmse = [float(np.sqrt(max(one, 0.0))) for one in (square, *mse)]
    return {
        "bias_m": drawn.figure(bias, error - bias, height=True),
        "mae_m": TotalFigure(float(share @ np.abs(error)), mae.low, mae.high),
        "rmse_m": TotalFigure(rmse[0], rmse[1], rmse[2]),
        "sd_m": TotalFigure(sd_m, sd.low, sd.high),
    }
