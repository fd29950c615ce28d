"""Lots of heights that are judged by a sample: their plan, their items, and what became of them."""

from sqlalchemy import CheckConstraint, Column, ForeignKey, Integer, String, UniqueConstraint

from sightline.infra.audit.vouched import WrittenOnceApart, table_written_once, vouched_info
from sightline.infra.database.types import CanonicalJson, columns_for, numbered_table
from sightline.reviews.lots.records import Decision, Lot
from sightline.statistics.acceptance import RiskPoints

# Heights of a survey that are judged by a sample. The audit event names its items and binds the draw.
lots = table_written_once(
    "lots",
    "lot",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("number", Integer, nullable=False),
    # what its heights have in common: {target, lighting, operator_id, day}, those that were asked for
    Column("common", CanonicalJson, nullable=False),
    *columns_for(Lot, only="size sample_size acceptance_number"),
    *columns_for(RiskPoints),
    Column("seed", String(64), nullable=False),
    UniqueConstraint("survey_id", "number"),
    CheckConstraint("acceptance_number < sample_size AND sample_size <= size", name="plan_fits"),
)


# `place`: when it is drawn, from 1.
lot_items = numbered_table(
    "lot_items",
    Column("lot_id", ForeignKey("lots.id"), nullable=False),
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False, index=True),
    Column("revision", Integer, nullable=False),
    Column("place", Integer, nullable=False),
    UniqueConstraint("lot_id", "place"),
    UniqueConstraint("lot_id", "series_id"),
    info=vouched_info(WrittenOnceApart("lot_items")),
)


# What became of a lot; the newest row counts. `sample`: series judged; `left_out`: reason by series.
lot_decisions = table_written_once(
    "lot_decisions",
    "lot_decision",
    Column("lot_id", ForeignKey("lots.id"), nullable=False, index=True),
    *columns_for(Decision, only="choice judged nonconforming rest sample left_out"),
)
