"""The table of a survey's audit chain in the package."""

from sightline.infra.csv_package.columns import integer, key, text
from sightline.infra.csv_package.schema import Row, Table

AUDIT: Table[Row] = Table(
    "audit",
    "The survey's whole audit chain: who did what, when. hash = SHA-256 of previous_hash followed by "
    "content_sha256, content_sha256 = SHA-256 of the canonical JSON (keys sorted, no spaces, empty cells "
    "null) of chain (survey/ and the survey's number), number, at, actor_id, action, entity, entity_id, "
    "survey_id, before and after. checkpoint.json holds the signature over its end.",
    (
        key("number", "audit event in the survey's chain, from 1"),
        text("at", "when (ISO 8601, UTC), as it was hashed", required=True),
        integer("actor_id", "who; empty for the program itself"),
        text("action", "what was done", required=True),
        text("entity", "to what kind of thing", required=True),
        integer("entity_id", "to which one"),
        integer("survey_id", "survey it belongs to", required=True),
        text("before", "the thing before, as JSON"),
        text("after", "the thing after, as JSON"),
        text("previous_hash", "hash of the event before; 64 zeros for the first", required=True),
        text("content_sha256", "hash of this event's content", required=True),
        text("hash", "hash of this event", required=True),
    ),
    primary=("number",),
    folder="",
)
