"""Table 1 of Dupuis et al. 2019 as printed, to stand beside a survey's own figures."""

from dataclasses import dataclass

from sightline.messages.said import Said


@dataclass(frozen=True)
class PaperColumn:
    """One column of the printed table, metres; MSE in m2 (printed "m"). `note`: what is wrong in it."""

    group: str
    title: str
    n: int
    mae_m: float
    rmse_m: float
    mse_m2: float
    sd_m: float
    note: Said


# The notes' shares are by linear programming over errors of whole centimetres with the printed MAE, RMSE
# and MSE.
PAPER = (
    PaperColumn("daytime", "Table 1, “Daytime”", 400, 0.023, 0.028, 8e-4, 0.026, Said("paper-day")),
    PaperColumn(
        "low_light", "Table 1, “Low Light”", 250, 0.0147, 0.019, 3.5e-4, 0.019, Said("paper-low-light")
    ),
    PaperColumn("overall", "Table 1, “Overall”", 650, 0.0203, 0.026, 6.6e-4, 0.025, Said("paper-overall")),
)
