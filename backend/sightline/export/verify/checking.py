"""What the checks of a package's tables read and what they found."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from sightline.export.contents import STATISTICS
from sightline.export.measured import PackageStatistics
from sightline.export.verify.chain import ReplayedState
from sightline.export.verify.derived import check_crops, check_statistics
from sightline.export.verify.described import Described
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.schema import Written
from sightline.measurements.again.verify import check_computings, check_out_of_date
from sightline.measurements.csv import MEASUREMENTS
from sightline.measurements.verify import Recomputed, check_measurements
from sightline.messages import say
from sightline.quality.repeats.csv import REPEATS
from sightline.quality.repeats.verify import check_repeats


@dataclass(eq=False)
class PackageCheck:
    """What was checked; `problem` is one sentence, None when all is well. `notes`: what could not be.

    `not_checked`: the parts that another version of the program made, which this one did not compare:
    "heights", "words", "description", "statistics", "drawings", "page". `vouched`: how many events what was
    kept elsewhere vouches for, if anything was given. Counts are those so far, told even when something is
    wrong.
    """

    ok: bool
    files: int
    checked: int = 0
    heights: int = 0
    head_hash: str = ""
    problem: str | None = None
    keys: int = 0
    statistics: int = 0
    crops: int = 0
    drawings: int = 0
    signed_at: str = ""
    key: str = ""
    vouched: int | None = None
    not_checked: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def tell(self, part: str, notes: Sequence[str]) -> None:
        """Note what another version made and this one did not compare."""
        if notes:
            self.not_checked.append(part)
            self.notes += notes


@dataclass(eq=False)
class Checking:
    """A package in this program's format (`files`), what its chain tells, and what was found so far.

    `computings`: the kind of each computing by its number; `statistics`: those that the rows give, None where
    another program made others.
    """

    files: Files
    described: Described
    told: ReplayedState
    written: Mapping[str, Written]
    found: PackageCheck
    computings: Mapping[str, str] = field(default_factory=dict)
    statistics: PackageStatistics | None = None

    @cached_property
    def recomputing(self) -> Recomputing:
        """How many figures were computed again, equal and differing."""
        return Recomputing(self.described.is_computed_alike)


def check_heights(c: Checking) -> None:
    """Measurements, their revisions, budgets and clicks, and repeats: every height from its clicks, and what
    is out of date. Raises Damaged.
    """
    state = c.told
    heights = Recomputed(c.files, c.recomputing, c.described.program)
    check_measurements(c.files, state.measurements, state.is_gone, state.drift.open_spans, heights)
    check_repeats(c.files, state.measurements, state.is_gone, heights)
    c.found.heights = c.recomputing.equal
    for path in (MEASUREMENTS.key, REPEATS.key):
        if "out_of_date" in state.measurements.headers[path]:
            vehicles = state.replay.of("vehicle")
            follows_from = state.measurements.follows_from
            check_out_of_date(c.files, path, follows_from, state.survey, vehicles, state.pose_in_force)


def check_computed_again(c: Checking) -> None:
    """What was computed again, and the verdicts that went over. Raises Damaged."""
    c.computings = check_computings(c.files, c.told.replay, c.told.computed)


def check_pictures(c: Checking) -> None:
    """Crops. Raises Damaged."""
    c.found.crops = check_crops(c.files, c.written)


def check_figures(c: Checking) -> None:
    """Exclusions, response and statistics, computed again. Raises Damaged."""
    same_program = c.described.is_made_alike(STATISTICS)
    c.statistics, c.found.statistics, difference = check_statistics(c.files, same_program=same_program)
    if c.statistics is None:
        c.found.tell("statistics", [say("export-statistics-sealed-only", {"difference": difference})])
