"""Pieces of sentences: numbers of vehicles, what intervals hold."""

from collections.abc import Sequence


def vehicles(n: int) -> str:
    """ "1 vehicle", "2 vehicles"."""
    return f"{n} vehicle" if n == 1 else f"{n} vehicles"


def there_are(n: int) -> str:
    """ "there is 1", "there are 2", "there is none"."""
    return "there is none" if n == 0 else f"there {'is' if n == 1 else 'are'} {n}"


def are_too_few(n: int) -> str:
    """ "1 vehicle is too few", "2 vehicles are too few"."""
    return f"{vehicles(n)} {'is' if n == 1 else 'are'} too few"


def holding(parts: Sequence[str], sites: int | None) -> str:
    """What intervals hold, one part or more, and for which roads, as the end of a sentence; sites: how many
    clusters, None: one site.
    """
    where = "the site of the survey only" if sites is None else "roads like those of these sites"
    *most, last = parts
    listed = f"{', '.join(most)} and {last}" if most else f"{last} alone"
    return f"{listed}; they apply to {where}"
