"""A large survey made in the database itself, by `INSERT ... SELECT` alike on SQLite and PostgreSQL."""

from __future__ import annotations

from sqlalchemy import Table, text
from sqlalchemy.orm import Session

from sightline.infra.database.engine import SessionFactory, writing
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.vehicles.tables import vehicles
from tests.support import samples
from tests.support.samples import Sample

NUMBERS = (
    "WITH RECURSIVE numbers(i) AS "
    "(SELECT CAST({first} AS BIGINT) UNION ALL SELECT i + 1 FROM numbers WHERE i < {last})"
)
TARGETS = ("roof", "driver_eye", "taillight")
FIRST = 1000  # ids below belong to the sample


def seed(factory: SessionFactory, count: int) -> Sample:
    """`count` measurements, three of each vehicle; every fifth revised, nine of ten accepted, one waiting."""
    with writing(factory) as session:
        one = samples.sample(session)
        made = samples.measure(session, one)
        _vehicles(session, one.vehicle.id, count // 3)
        for k, target in enumerate(TARGETS):
            _measurements(session, one, made.revision_id, count // 3, k, target)
        session.execute(text("ANALYZE"))
    return one


def _scattered(salt: int) -> str:
    """A number of mean 0 and standard deviation 1 that goes with i, about normal: the sum of three others."""
    parts = (f"((i * {step} + {salt}) % 9973) / 9973.0" for step in (4271, 7919, 6131))
    return f"2.0 * ({' + '.join(parts)} - 1.5)"


def _insert(session: Session, table: Table, template: int, changed: dict[str, str], count: int) -> None:
    """Rows like the one with id `template`, for i from FIRST; `changed`: expressions of i."""
    names = [c.name for c in table.columns if c.name != "id" or "id" in changed]
    values = [changed.get(name, f'template."{name}"') for name in names]
    columns = ", ".join(f'"{name}"' for name in names)
    numbers = NUMBERS.format(first=FIRST, last=FIRST + count - 1)
    session.execute(
        text(
            f"INSERT INTO {table.name} ({columns}) {numbers} SELECT {', '.join(values)} "
            f"FROM numbers CROSS JOIN {table.name} AS template WHERE template.id = {template}"
        )
    )


def _vehicles(session: Session, template: int, count: int) -> None:
    words = "CASE i % {n} " + "{cases} END"
    categories = " ".join(
        f"WHEN {k} THEN '{word}'" for k, word in enumerate(("hatchback", "saloon", "suv", "van"))
    )
    changed = {
        "id": "i",
        "number": "i",
        "lighting": "CASE i % 3 WHEN 0 THEN 'low_light' ELSE 'daytime' END",
        "category": words.format(n=5, cases=categories),
        "manufacturer_height_m": f"1.55 + 0.12 * ({_scattered(1)})",
    }
    _insert(session, vehicles, template, changed, count)


def _measurements(session: Session, one: Sample, template: int, count: int, k: int, target: str) -> None:
    series = f"(i * 3 + {k})"
    true = {"roof": f"1.55 + 0.12 * ({_scattered(1)})", "driver_eye": f"1.18 + 0.07 * ({_scattered(2)})"}
    height = f"{true.get(target, f'0.85 + 0.06 * ({_scattered(3)})')} + 0.015 * ({_scattered(7 + k)})"
    _insert(
        session,
        measurement_series,
        1,
        {"id": series, "vehicle_id": "i", "client_key": f"CAST({series} AS VARCHAR(36))"},
        count,
    )
    changed = {"series_id": series, "target": f"'{target}'", "height_m": height}
    changed["uncorrected_height_m"] = f"{height} + 0.04"
    _insert(session, measurements, template, changed, count)
    again = {**changed, "revision": "2", "series_id": f"(((i - {FIRST}) * 5 + {FIRST}) * 3 + {k})"}
    _insert(session, measurements, template, again, count // 5)
    _verdicts(session, one, count, k)


def _verdicts(session: Session, one: Sample, count: int, k: int) -> None:
    numbers = NUMBERS.format(first=FIRST, last=FIRST + count - 1)
    newest = f"CASE WHEN (i - {FIRST}) % 5 = 0 AND (i - {FIRST}) / 5 < {count // 5} THEN 2 ELSE 1 END"
    columns = "series_id, revision, result_revision, verdict, created_at, created_by"
    session.execute(
        text(
            f"INSERT INTO {reviews.name} ({columns}) {numbers} "
            f"SELECT i * 3 + {k}, {newest}, {newest}, 'accepted', created_at, {one.rene.id} "
            f"FROM numbers CROSS JOIN measurements AS template WHERE template.id = 1 AND (i + {k}) % 10 <> 0"
        )
    )
