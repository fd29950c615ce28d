"""So much of something within so long, over every process of the app: a moving window in the database."""

import hashlib
import math
from dataclasses import dataclass
from datetime import timedelta

from sqlalchemy import delete, func, insert, select
from sqlalchemy.orm import Session

from sightline.infra.database.types import now
from sightline.infra.limits.tables import counted

#: No window is longer; what is older counts for none and goes.
LONGEST_S = 3600


@dataclass(frozen=True, slots=True)
class Limit:
    """`most` of `what` within `seconds`, for each key."""

    what: str
    most: int
    seconds: int

    def key(self, of: str) -> str:
        return hashlib.sha256(f"{self.what}\n{of}".encode()).hexdigest()


def has_room(session: Session, limit: Limit, of: str, amount: int = 1) -> bool:
    """Whether so much more may be counted."""
    since = now() - timedelta(seconds=limit.seconds)
    c = counted.c
    inside = select(func.coalesce(func.sum(c.amount), 0)).where(c.key == limit.key(of), c.at > since)
    return int(session.execute(inside).scalar_one()) + amount <= limit.most


def wait_s(session: Session, limit: Limit, of: str, *, pace_s: float | None = None) -> int:
    """In how many whole seconds one more may be counted; 0: at once.

    With `pace_s` a key beyond its limit is slowed down to one in so many seconds, not shut out until the
    window has moved on.
    """
    if has_room(session, limit, of):
        return 0
    c, present = counted.c, now()
    inside = (c.key == limit.key(of), c.at > present - timedelta(seconds=limit.seconds))
    if pace_s is not None:
        newest = session.execute(select(func.max(c.at)).where(*inside)).scalar_one()
        left = pace_s - (present - newest).total_seconds()
        return max(0, math.ceil(float(min(left, pace_s))))
    over = 1 - limit.most
    rows = session.execute(select(c.at, c.amount).where(*inside).order_by(c.at)).all()
    over += sum(amount for _, amount in rows)
    for at, amount in rows:
        over -= amount
        if over <= 0:
            return max(1, math.ceil(float(limit.seconds - (present - at).total_seconds())))
    return limit.seconds


def count_tried(session: Session, limit: Limit, of: str, amount: int = 1) -> None:
    """Count so much more, whether there is room or not."""
    session.execute(delete(counted).where(counted.c.at <= now() - timedelta(seconds=LONGEST_S)))
    session.execute(insert(counted), {"key": limit.key(of), "at": now(), "amount": amount})


def count_against(session: Session, limit: Limit, of: str, amount: int = 1) -> bool:
    """Count so much, unless it is too much: then nothing is counted. In a write transaction, the only one."""
    room = has_room(session, limit, of, amount)
    if room:
        count_tried(session, limit, of, amount)
    return room


def uncount(session: Session, limit: Limit, of: str) -> None:
    """Take back what was counted last for this key."""
    c = counted.c
    last = select(c.id).where(c.key == limit.key(of)).order_by(c.id.desc()).limit(1).scalar_subquery()
    session.execute(delete(counted).where(c.id == last))


def forget_counted(session: Session, limit: Limit, of: str) -> None:
    """What was counted for this key counts no more."""
    session.execute(delete(counted).where(counted.c.key == limit.key(of)))
