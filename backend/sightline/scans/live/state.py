"""How a live stream is, from when it was last heard: a killed process tells nobody that it ended."""

from datetime import datetime, timedelta

from sightline.enums import LiveState

#: A stream is heard every second.
SILENT_AFTER = timedelta(seconds=10)
STOPPED_AFTER = timedelta(minutes=2)


def live_state(heard_at: datetime, ended_at: datetime | None, at: datetime) -> LiveState:
    """As of `at`: a stream that was not heard for two minutes has stopped, whatever it meant to do."""
    if ended_at is not None:
        return "ended"
    quiet = at - heard_at
    if quiet > STOPPED_AFTER:
        return "stopped"
    return "silent" if quiet > SILENT_AFTER else "running"
