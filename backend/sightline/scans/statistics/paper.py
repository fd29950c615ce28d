"""Table I of Douxchamps, Macq and Chihara as printed, to stand beside a survey's own vehicles."""

from dataclasses import dataclass


@dataclass(frozen=True)
class PaperCar:
    """One printed row; `counter`: the counter's speed in km/h, or "breaking" as printed, None where empty."""

    car_id: int
    speed_kmh: float
    acceleration_mps2: float
    size_m: float
    counter: str | None
    true_length_m: float
    fit_error_percent: float


TABLE_I = (
    PaperCar(2123, 62.1, 0.44, 4.04, None, 3.84, 0.63),
    PaperCar(6676, 51.5, 0.62, 4.04, None, 3.84, 0.22),
    PaperCar(11874, 54.7, 0.58, 3.65, None, 3.54, 0.54),
    PaperCar(25774, 39.3, -1.42, 4.56, "breaking", 4.39, 0.35),
    PaperCar(27896, 63.1, -0.09, 4.63, "70", 4.39, 0.41),
    PaperCar(37050, 59.4, 0.85, 4.36, None, 4.15, 0.49),
    PaperCar(38416, 62.8, -0.39, 4.63, "70", 4.39, 0.46),
    PaperCar(50580, 59.5, 0.24, 5.05, None, 4.73, 0.82),
    PaperCar(61176, 31.8, -1.38, 4.59, "breaking", 4.39, 0.60),
    PaperCar(64991, 31.1, -1.03, 4.64, "breaking", 4.39, 0.23),
    PaperCar(68407, 45.5, -0.22, 4.04, None, 3.82, 0.81),
    PaperCar(74948, 65.1, 0.29, 4.03, None, 3.83, 0.79),
    PaperCar(89378, 58.5, -0.02, 4.85, None, 4.51, 0.76),
    PaperCar(94881, 41.9, -0.09, 5.89, None, 5.40, 0.63),
    PaperCar(97647, 62.6, -0.83, 4.63, "70", 4.39, 0.42),
)
