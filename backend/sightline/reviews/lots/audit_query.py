"""What the audit chain says of a lot's items: measurements with their revisions, in the order of the draw."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit.vouched import Event, Fingerprint, register
from sightline.reviews.lots.tables import lot_items


def _promise(event: Event, promised: dict[int, str]) -> None:
    if event.entity == "lot" and event.entity_id is not None:
        promised[event.entity_id] = _items_text(event.after["items"])


def _stored_fingerprints(session: Session) -> Iterator[tuple[int, str]]:
    i = lot_items.c
    query = select(i.lot_id, i.series_id, i.revision).order_by(i.lot_id, i.place)
    with session.execute(query.execution_options(yield_per=1000)) as rows:
        for lot_id, items in groupby(rows, key=lambda row: row.lot_id):
            yield lot_id, _items_text([(row.series_id, row.revision) for row in items])


def _items_text(items: Sequence[Sequence[int]]) -> str:
    return " ".join(f"{number}.{revision}" for number, revision in items)


register(Fingerprint("lot_items", _promise, _stored_fingerprints))
