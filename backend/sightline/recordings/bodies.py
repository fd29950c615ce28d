"""What comes in about when something was recorded."""

from pydantic import Field

from sightline.infra.web.bodies import In


class StartIn(In):
    """When a recording was begun, as clocks of the place showed it."""

    local: str = Field(
        max_length=40, description="ISO 8601; with its offset where the clocks showed that time twice."
    )
    time_zone: str = Field(max_length=60, description="IANA, as Europe/Paris.")
