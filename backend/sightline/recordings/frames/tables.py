"""The table of frame tables."""

from sqlalchemy import BigInteger, Boolean, CheckConstraint, Column, Float, ForeignKey, Integer, Table

from sightline.infra.database.types import metadata

frames = Table(
    "frames",
    metadata,
    Column("recording_id", ForeignKey("recordings.id"), primary_key=True),
    Column("n", Integer, primary_key=True, autoincrement=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("key", Boolean, nullable=False),
    Column("crc32", BigInteger, nullable=False),
    CheckConstraint("n >= 0", name="n_counts"),
    sqlite_with_rowid=False,
)
