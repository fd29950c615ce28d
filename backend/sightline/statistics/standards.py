"""A height that a standard of road design is set by, to be drawn into distributions."""

from dataclasses import dataclass, field

from sightline.enums import StandardHeight


@dataclass(frozen=True)
class Standard:
    """One height of one standard.

    `what`: what it is a height of; `percent`: which percentile of `vehicle_class` it stands for, None where
    no source says; `cited_by`: who cites it, "" where the source itself was read; `drawn`: whether
    distributions are read against it (not what is superseded, nor the upper end of a range). `code`: by
    which its words, if they are the program's, are said in other languages; None where a person wrote them.
    """

    name: str
    what: StandardHeight
    height_m: float
    source: str
    edition: str = ""
    year: int | None = None
    percent: float | None = None
    vehicle_class: str = ""
    cited_by: str = ""
    drawn: bool = True
    code: str | None = field(default=None, compare=False)

    @property
    def words(self) -> tuple[str, ...]:
        """What of it can be said in another language."""
        return self.name, self.vehicle_class, self.source, self.cited_by
