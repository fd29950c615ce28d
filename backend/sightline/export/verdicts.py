"""What the accepted heights of a package rest on: their own verdicts, or those of lots by a sample."""

from collections import Counter
from dataclasses import dataclass

from sightline.export.chosen import counting_vehicles, is_accepted
from sightline.infra.csv_package.files import Files, read_columns
from sightline.statistics.acceptance import Outgoing, outgoing_of_lots


@dataclass(frozen=True, slots=True)
class VerdictCounts:
    """Accepted heights `individual` and `by_lot`; `lots` that those are of, and what they let through."""

    individual: int = 0
    by_lot: int = 0
    lots: int = 0
    outgoing: Outgoing | None = None


def verdicts_in(files: Files) -> VerdictCounts:
    """Of the vehicles whose heights count."""
    counting = counting_vehicles(files)
    names = ("vehicle_id", "withdrawn", "status", "verdict", "verdict_by", "lot_id")
    bases, standing = Counter[str](), Counter[str]()
    for vehicle, *cells, basis, lot in read_columns(files, "measurements.csv", names):
        if is_accepted(*cells) and vehicle in counting:
            standing[lot] += 1
            bases[basis] += 1
    columns = ("id", "state", "judged", "rest", "nonconforming")
    accepted = [
        (int(judged) + int(rest), int(judged), int(bad), standing[lot])
        for lot, state, judged, rest, bad in read_columns(files, "lots.csv", columns)
        if state == "accepted" and standing[lot]
    ]
    return VerdictCounts(
        individual=bases["individual"],
        by_lot=bases["lot"],
        lots=len(accepted),
        outgoing=outgoing_of_lots(accepted) if accepted else None,
    )
