"""The catalogue of models with the manufacturers' dimensions."""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from sqlalchemy import insert, select
from sqlalchemy.orm import Session

from sightline.errors import BadInput
from sightline.infra.audit import trail
from sightline.infra.audit.hashing import content_hash
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import columns_of
from sightline.vehicles.catalogue.records import CatalogueEntry, CatalogueImport, CatalogueRow
from sightline.vehicles.catalogue.tables import catalogue

_CATEGORIES = (None, "hatchback", "saloon", "estate", "suv", "van", "lorry", "other")
_LENGTHS = ("height_m", "length_m", "width_m", "wheelbase_m")


def search_catalogue(session: Session, q: str, *, limit: int = 20) -> tuple[CatalogueEntry, ...]:
    """Models of which every word of `q` begins a word, accents and case aside ("corv li")."""
    query = select(*columns_of(catalogue, "search_text"))
    for word in _folded(q).split():
        escaped = word.replace("\\", "\\\\").replace("%", "\\%").replace("_", "\\_")
        query = query.where(catalogue.c.search_text.like(f"% {escaped}%", escape="\\"))
    ordered = query.order_by(catalogue.c.make, catalogue.c.model, catalogue.c.year_from, catalogue.c.id)
    return tuple(_entry(row) for row in session.execute(ordered.limit(limit)).mappings())


def get_catalogue_row(session: Session, entry_id: int) -> CatalogueEntry:
    """One model. Raises NotFound."""
    row = get_row(session, catalogue, entry_id, "catalogue row")
    return _entry({key: value for key, value in row.items() if key != "search_text"})


def add_catalogue_row(session: Session, row: CatalogueRow, *, actor: int | None) -> CatalogueEntry:
    """One more model. Raises BadInput for a row that cannot be true."""
    entry_id = add_row(session, catalogue, _content(row))
    trail.record(session, actor, "create", "catalogue", entry_id, None, None, asdict(row))
    return get_catalogue_row(session, entry_id)


def catalogue_row_problem(row: CatalogueRow) -> str | None:
    """Why a row cannot be used, as one sentence; None when it can."""
    if not row.make.strip() or not row.model.strip():
        return "The make and the model are needed; fill in both."
    if row.category not in _CATEGORIES:
        return f"“{row.category}” is not a category; use one of {', '.join(str(c) for c in _CATEGORIES[1:])}."
    for name in _LENGTHS:
        value = getattr(row, name)
        if value is not None and not 0.1 < value < 30:
            return f"{name} is {value}, which no vehicle has; give it in metres."
    if row.year_from is not None and row.year_to is not None and row.year_to < row.year_from:
        return "The last year lies before the first; swap them."
    return None


def import_catalogue_rows(
    session: Session, rows: Sequence[CatalogueRow], *, actor: int | None
) -> CatalogueImport:
    """Add many models at once; same make, model and first year means the same model, which is updated."""
    contents = [_content(row) for row in rows]
    known = {
        (row.make.lower(), row.model.lower(), row.year_from): row.id
        for row in session.execute(
            select(catalogue.c.id, catalogue.c.make, catalogue.c.model, catalogue.c.year_from)
        )
    }
    new: dict[Any, dict[str, Any]] = {}
    updated: set[int] = set()
    for content in contents:
        key = (content["make"].lower(), content["model"].lower(), content["year_from"])
        if key in known:
            change_row(session, catalogue, known[key], content)
            updated.add(known[key])
        else:
            new[key] = content
    if new:
        session.execute(insert(catalogue), list(new.values()))
    after = {"added": len(new), "updated": len(updated), "rows_sha256": content_hash({"rows": contents})}
    trail.record(session, actor, "import", "catalogue", None, None, None, after)
    return CatalogueImport(len(new), len(updated))


def _content(row: CatalogueRow) -> dict[str, Any]:
    problem = catalogue_row_problem(row)
    if problem is not None:
        raise BadInput("said", sentence=problem)
    content = asdict(row)
    content["make"], content["model"] = row.make.strip(), row.model.strip()
    years = " ".join(str(year) for year in (row.year_from, row.year_to) if year is not None)
    content["search_text"] = f" {_folded(f'{row.make} {row.model} {years}')}"
    return content


def _folded(text: str) -> str:
    apart = unicodedata.normalize("NFKD", text)
    plain = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return " ".join(plain.casefold().replace("-", " ").split())


def _entry(row: Mapping[Any, Any]) -> CatalogueEntry:
    return CatalogueEntry(**row)
