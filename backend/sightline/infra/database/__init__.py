"""The database. Who only passes a transaction on takes `Session` from here, and never SQLAlchemy itself."""

from sqlalchemy.orm import Session

__all__ = ["Session"]
