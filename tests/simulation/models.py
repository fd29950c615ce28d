"""The demonstration's catalogue: invented makes and models, so that nothing false is said of real cars."""

from dataclasses import dataclass

from sightline.demo import made


@dataclass(frozen=True)
class Model(made.Model):
    """A catalogue row plus what the renderer must know; `category` is also the name of the body style."""

    head_lamp_m: float

    @property
    def name(self) -> str:
        return f"{self.make} {self.model}"


MODELS = (
    Model("Corvane", "Lindo", 2016, 2023, "hatchback", 4.02, 1.74, 1.460, 2.53, 1.150, 0.735, 0.67),
    Model("Aldara", "Pico", 2012, 2019, "hatchback", 3.86, 1.70, 1.480, 2.43, 1.175, 0.760, 0.69),
    Model("Tesmer", "Juna", 2019, 2025, "hatchback", 4.24, 1.80, 1.450, 2.67, 1.130, 0.745, 0.66),
    Model("Corvane", "Berlan", 2014, 2021, "saloon", 4.66, 1.80, 1.445, 2.73, 1.120, 0.770, 0.67),
    Model("Halvorn", "S4", 2018, 2025, "saloon", 4.78, 1.84, 1.435, 2.80, 1.105, 0.785, 0.66),
    Model("Orsay Motor", "Vent", 2010, 2017, "saloon", 4.52, 1.77, 1.465, 2.65, 1.140, 0.760, 0.68),
    Model("Tesmer", "Juna Tour", 2019, 2025, "estate", 4.58, 1.80, 1.475, 2.68, 1.135, 0.755, 0.66),
    Model("Halvorn", "S4 Variel", 2017, 2024, "estate", 4.76, 1.84, 1.485, 2.78, 1.125, 0.790, 0.66),
    Model("Aldara", "Monte", 2015, 2022, "suv", 4.38, 1.83, 1.640, 2.63, 1.320, 0.865, 0.79),
    Model("Corvane", "Ridda", 2018, 2025, "suv", 4.52, 1.86, 1.675, 2.71, 1.345, 0.890, 0.82),
    Model("Nordal", "Taiga", 2013, 2021, "suv", 4.60, 1.88, 1.735, 2.76, 1.405, 0.915, 0.85),
    Model("Nordal", "Cargo 3", 2014, 2023, "van", 4.85, 1.92, 1.945, 3.03, 1.540, 0.830, 0.83),
    Model("Orsay Motor", "Livre", 2016, 2025, "van", 4.60, 1.88, 1.860, 2.88, 1.480, 0.800, 0.80),
    Model("Haldmann", "T75", 2011, 2020, "lorry", 7.35, 2.34, 3.180, 4.02, 2.060, 0.700, 0.71),
    Model("Haldmann", "T60 City", 2015, 2024, "lorry", 6.70, 2.22, 2.960, 3.67, 1.980, 0.680, 0.69),
)
