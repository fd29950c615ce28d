"""The table of uploads."""

from sqlalchemy import BigInteger, Column, ForeignKey, Integer, String

from sightline.enums import UploadPurpose
from sightline.infra.database.types import UtcDateTime, enum_check, made_columns, needs_media, numbered_table

uploads = numbered_table(
    "uploads",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("filename", String(400), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    # of a strip, once it is here; its scan needs the file from then on
    Column(
        "media_key",
        String(400),
        nullable=False,
        info=needs_media(lambda its: its.scan_id.is_(None) & (its.media_key != "")),
    ),
    Column("recording_id", ForeignKey("recordings.id")),
    *made_columns(),
    Column("finished_at", UtcDateTime),
    # a video becomes a recording; a strip waits, with its content's hash, for the scan that it belongs to
    Column("purpose", String(20), nullable=False, server_default="video"),
    Column("sha256", String(64)),
    Column("scan_id", Integer, ForeignKey("scans.id", use_alter=True)),
    enum_check("purpose", UploadPurpose),
    # a client goes on by number: that of one given up is no other's
    sqlite_autoincrement=True,
)
