"""The catalogue of models with the manufacturers' dimensions."""

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any, get_args

from sqlalchemy import ColumnElement, Select, bindparam, func, insert, select, update
from sqlalchemy.orm import Session

from sightline.enums import Category, ModelSize, SizeUnit
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.hashing import content_hash
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import columns_of, now
from sightline.messages import write_fixed
from sightline.vehicles.catalogue.records import (
    SIZES,
    CatalogueEntry,
    CatalogueImport,
    CataloguePage,
    CatalogueRow,
)
from sightline.vehicles.catalogue.tables import catalogue

#: What a vehicle's sizes lie within, metres; heights of lamps are those of their lower edges.
POSSIBLE_M: dict[ModelSize, tuple[float, float]] = {
    "height": (0.5, 4.6),
    "length": (1.2, 30.0),
    "width": (0.4, 3.2),
    "wheelbase": (0.8, 15.0),
    "taillight": (0.1, 2.5),
    "headlight": (0.1, 2.5),
}
METRES: dict[SizeUnit, float] = {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
UNIT_WORDS: dict[SizeUnit, str] = {
    "m": "metres",
    "cm": "centimetres",
    "mm": "millimetres",
    "ft": "feet",
    "in": "inches",
}
MOST_U_M, MOST_U_SHARE = 1.0, 0.2  # of any size, and of a known one: a larger u was given in another unit
MOST_MAKE, MOST_MODEL = 100, 200  # signs
_FIELDS = tuple(one.name for one in fields(CatalogueRow))
# Nothing that is shown; PostgreSQL's texts hold no NUL. Sources may have lines.
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
_LIVING: ColumnElement[bool] = catalogue.c.retired_at.is_(None)
Key = tuple[str, str, int | None]


def search_catalogue(session: Session, q: str) -> tuple[CatalogueEntry, ...]:
    """Models of which every word of `q` begins a word, accents and case aside ("corv li"); none retired."""
    return _entries(session, _search_query(q).where(_LIVING).limit(20))


def page_of_catalogue(session: Session, q: str, *, retired: bool, offset: int) -> CataloguePage:
    """A part of what a search finds, and how many there are; with `retired` those alone."""
    query = _search_query(q).where(catalogue.c.retired_at.is_not(None) if retired else _LIVING)
    total = session.execute(select(func.count()).select_from(query.order_by(None).subquery())).scalar_one()
    return CataloguePage(total, _entries(session, query.offset(offset).limit(50)))


def all_of_catalogue(session: Session) -> tuple[CatalogueEntry, ...]:
    """Every model that is not retired."""
    return _entries(session, _search_query("").where(_LIVING))


def catalogue_of_models(session: Session, models: Iterable[tuple[str, str]]) -> tuple[CatalogueEntry, ...]:
    """The models of these makes and names, in any case, retired ones too."""
    wanted = {(make.lower(), model.lower()) for make, model in models}
    # SQLite's lower() leaves the Š of Škoda as it is
    every = _entries(session, _search_query("")) if wanted else ()
    return tuple(one for one in every if (one.make.lower(), one.model.lower()) in wanted)


def get_catalogue_row(session: Session, entry_id: int) -> CatalogueEntry:
    """One model. Raises NotFound."""
    row = get_row(session, catalogue, entry_id, "catalogue row")
    return _entry({key: value for key, value in row.items() if key != "search_text"})


def add_catalogue_row(session: Session, row: CatalogueRow, *, actor: int | None) -> CatalogueEntry:
    """One more model. Raises BadInput for a row that cannot be true or is there already."""
    require_possible(row)
    if key_of(row) in known_models(session):
        raise BadInput("catalogue-there-already", make=row.make, model=row.model, year=row.year_from or "–")
    entry_id = add_row(session, catalogue, {**_content(row), "version": 1})
    trail.record(session, actor, "create", "catalogue", entry_id, None, None, asdict(row))
    return get_catalogue_row(session, entry_id)


def correct_catalogue_row(
    session: Session, entry_id: int, row: CatalogueRow, *, version: int, actor: int | None
) -> CatalogueEntry:
    """Put other values in a model's place. Raises NotFound, Conflict for another version, BadInput."""
    before = _require_version(session, entry_id, version)
    require_possible(row)
    other = known_models(session).get(key_of(row))
    if other is not None and other.id != entry_id:
        raise BadInput("catalogue-there-already", make=row.make, model=row.model, year=row.year_from or "–")
    change_row(session, catalogue, entry_id, {**_content(row), "version": version + 1})
    what = trail.changed_fields({name: getattr(before, name) for name in _FIELDS}, asdict(row), asdict(row))
    trail.record(session, actor, "update", "catalogue", entry_id, None, *what)
    return get_catalogue_row(session, entry_id)


def retire_catalogue_row(
    session: Session, entry_id: int, *, version: int, retired: bool, actor: int | None
) -> CatalogueEntry:
    """No longer offer a model, or offer it again. Raises NotFound, Conflict for another version."""
    before = _require_version(session, entry_id, version)
    moment = now() if retired else None
    change_row(session, catalogue, entry_id, {"retired_at": moment, "version": version + 1})
    then, after = ({"retired": one} for one in (before.retired_at is not None, retired))
    trail.record(session, actor, "retire" if retired else "restore", "catalogue", entry_id, None, then, after)
    return get_catalogue_row(session, entry_id)


def require_possible(row: CatalogueRow) -> None:
    """Raise BadInput for a row that cannot be true."""
    if not row.make.strip() or not row.model.strip():
        raise BadInput("catalogue-make-and-model")
    if _CONTROL.search(f"{row.make}{row.model}{row.source}{''.join(map(row.source_of, SIZES))}"):
        raise BadInput("catalogue-control-characters")
    if len(row.make) > MOST_MAKE or len(row.model) > MOST_MODEL:
        raise BadInput("catalogue-too-long", most_make=MOST_MAKE, most_model=MOST_MODEL)
    if row.category is not None and row.category not in get_args(Category):
        raise BadInput(
            "vehicles-category-unknown", category=row.category, categories=", ".join(get_args(Category))
        )
    for name in SIZES:
        _require_size(name, row.size(name))
        u, size = getattr(row, f"u_{name}_m"), row.size(name)
        most_m = MOST_U_M if size is None else min(MOST_U_M, MOST_U_SHARE * size)
        if u is not None and not 0.0 <= u <= most_m:
            raise BadInput(
                "catalogue-u-impossible", column=f"u_{name}_m", value=round(u, 3), most=round(most_m, 3)
            )
    _require_together(row)
    if row.year_from is not None and row.year_to is not None and row.year_to < row.year_from:
        raise BadInput("catalogue-years-reversed")


#: Of every vehicle a size is smaller than the other one.
_SMALLER: dict[ModelSize, ModelSize] = {"taillight": "height", "headlight": "height", "wheelbase": "length"}


def _require_together(row: CatalogueRow) -> None:
    """Raise BadInput where two sizes, each possible by itself, cannot be of one vehicle."""
    for small, large in _SMALLER.items():
        smaller, larger = row.size(small), row.size(large)
        if smaller is not None and larger is not None and smaller >= larger:
            raise BadInput(
                "catalogue-sizes-contradict",
                column=f"{small}_m",
                value=f"{smaller:g}",
                other=f"{large}_m",
                large=f"{larger:g}",
            )


def _require_size(name: ModelSize, value: float | None) -> None:
    low, high = POSSIBLE_M[name]
    if value is None or low <= value <= high:
        return
    others: tuple[SizeUnit, ...] = ("ft", "mm", "cm", "in")
    for unit in others:
        if low <= value * METRES[unit] <= high:
            raise BadInput(
                "catalogue-size-unit",
                column=f"{name}_m",
                value=f"{value:g}",
                unit=UNIT_WORDS[unit],
                metres=write_fixed(value * METRES[unit], 3),
            )
    raise BadInput("catalogue-size-impossible", column=f"{name}_m", value=f"{value:g}", low=low, high=high)


def key_of(row: CatalogueRow) -> Key:
    """What makes a model the same: make, name and first year."""
    return row.make.strip().lower(), row.model.strip().lower(), row.year_from


def known_models(session: Session) -> dict[Key, CatalogueEntry]:
    """Every model by its key, retired ones too."""
    return {key_of(entry): entry for entry in _entries(session, _columns())}


def import_catalogue_rows(
    session: Session,
    rows: Sequence[CatalogueRow],
    *,
    known: Mapping[Key, CatalogueEntry] | None = None,
    actor: int | None,
) -> CatalogueImport:
    """Add many models at once; of one that is there already, what is given takes the place of what was.

    `known`: `known_models` of the same transaction, where it is at hand. Raises BadInput for a row that
    cannot be true.
    """
    known = known_models(session) if known is None else known
    merged: dict[Key, CatalogueRow] = {}
    for row in rows:
        require_possible(row)
        key = key_of(row)
        before = merged.get(key) or known.get(key)
        merged[key] = row if before is None else merge(before, row)
    contents = {key: _content(row) for key, row in merged.items()}
    new = [{**content, "version": 1} for key, content in contents.items() if key not in known]
    changed = [
        {**content, "row_id": known[key].id, "version": known[key].version + 1}
        for key, content in contents.items()
        if key in known and changes(known[key], merged[key])
    ]
    if new:
        session.execute(insert(catalogue), new)
    if changed:
        values: dict[str, Any] = {name: bindparam(name) for name in (*_FIELDS, "search_text", "version")}
        statement = update(catalogue).where(catalogue.c.id == bindparam("row_id")).values(values)
        session.connection().execute(statement, changed)
    told = [{name: row[name] for name in _FIELDS if row[name] is not None} for row in contents.values()]
    digest = content_hash({"rows": told})
    after = {"added": len(new), "updated": len(changed), "rows_sha256": digest}
    trail.record(session, actor, "import", "catalogue", None, None, None, after)
    return CatalogueImport(len(new), len(changed))


def merge(before: CatalogueRow, given: CatalogueRow) -> CatalogueRow:
    """What is given, and behind it what was there; a size that is given brings its own u and source, but one
    that was known alike with a u, and is given without, says nothing new.
    """
    values: dict[str, Any] = {name: getattr(before, name) for name in _FIELDS}
    for name in _FIELDS:
        value = getattr(given, name)
        if value is not None and value != "":
            values[name] = value
    for name in SIZES:
        new, u_m = given.size(name), getattr(given, f"u_{name}_m")
        known = (
            u_m is None
            and getattr(before, f"u_{name}_m") is not None
            and is_same_cell(before.size(name), new)
        )
        if new is not None and not known:
            values[f"u_{name}_m"] = u_m
            values[f"{name}_source"] = given.source_of(name) or None
        elif before.size(name) is not None:
            values[f"{name}_source"] = before.source_of(name) or None
    values["make"], values["model"] = before.make, before.model
    return CatalogueRow(**values)


def is_same_cell(old: object, new: object) -> bool:
    """Whether two cells of a model say the same."""
    if isinstance(old, float) and isinstance(new, float):
        return abs(old - new) <= 5e-7  # files carry six decimals
    return old == new


def changes(before: CatalogueRow, after: CatalogueRow) -> bool:
    """Whether anything is told of a model otherwise than before, wherever a size's source stands."""
    return _told_fields(before) != _told_fields(after)


def _told_fields(row: CatalogueRow) -> dict[str, Any]:
    told: dict[str, Any] = {name: getattr(row, name) for name in _FIELDS}
    sources = {
        f"{name}_source": row.source_of(name) if row.size(name) is not None else None for name in SIZES
    }
    return {name: None if value == "" else value for name, value in {**told, **sources}.items()}


def _require_version(session: Session, entry_id: int, version: int) -> CatalogueEntry:
    before = get_catalogue_row(session, entry_id)
    if before.version != version:
        raise Conflict("catalogue-changed-meanwhile", current=before, make=before.make, model=before.model)
    return before


def _content(row: CatalogueRow) -> dict[str, Any]:
    content = {name: getattr(row, name) for name in _FIELDS}
    content["make"], content["model"] = row.make.strip(), row.model.strip()
    years = " ".join(str(year) for year in (row.year_from, row.year_to) if year is not None)
    content["search_text"] = f" {_folded(f'{row.make} {row.model} {years}')}"
    return content


def _folded(text: str) -> str:
    apart = unicodedata.normalize("NFKD", text)
    plain = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return " ".join(plain.casefold().replace("-", " ").split())


def _columns() -> Select[Any]:
    return select(*columns_of(catalogue, "search_text"))


def _search_query(q: str) -> Select[Any]:
    query = _columns()
    for word in _folded(q).split():
        escaped = word.replace("\\", "\\\\").replace("%", "\\%").replace("_", "\\_")
        query = query.where(catalogue.c.search_text.like(f"% {escaped}%", escape="\\"))
    return query.order_by(catalogue.c.make, catalogue.c.model, catalogue.c.year_from, catalogue.c.id)


def _entries(session: Session, query: Select[Any]) -> tuple[CatalogueEntry, ...]:
    return tuple(_entry(row) for row in session.execute(query).mappings())


def _entry(row: Mapping[Any, Any]) -> CatalogueEntry:
    return CatalogueEntry(**row)
