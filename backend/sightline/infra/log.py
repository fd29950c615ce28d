"""How the log is written: lines for people, or one JSON object a line; each with its request's number."""

import json
import logging
from contextvars import ContextVar
from datetime import UTC, datetime

from sightline.enums import LogFormat

#: The request that is being answered; empty beside requests.
REQUEST: ContextVar[str] = ContextVar("request", default="")
PLAIN = "%(asctime)s %(name)s: %(message)s"


class JsonLines(logging.Formatter):
    """One object a line: time (UTC), level, logger, message, request, its own fields, and any traceback."""

    def format(self, record: logging.LogRecord) -> str:
        line = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
            "request": REQUEST.get() or None,
            **getattr(record, "fields", {}),
        }
        if record.exc_info:
            line["traceback"] = self.formatException(record.exc_info)
        return json.dumps({name: value for name, value in line.items() if value is not None})


def begin_log(how: LogFormat, level: int) -> None:
    """Set the log of this process up; once, when a command starts."""
    handler = logging.StreamHandler()
    handler.setFormatter(JsonLines() if how == "json" else logging.Formatter(PLAIN))
    logging.basicConfig(level=level, handlers=[handler])
    # Procrastinate tells of every delivery; what matters of them is in the job table.
    logging.getLogger("procrastinate").setLevel(logging.WARNING)
