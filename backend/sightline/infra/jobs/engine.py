"""How worker processes come by queued jobs: one interface, two engines.

SQLite is one machine: the supervisor of the worker processes hands jobs out itself (`one_machine`). On
PostgreSQL several machines share the work: Procrastinate carries the ids (`postgres`). Either way the job
table says what is to be done and what became of it.

A supervisor may fork once `start` says so; `hand_out` gives idle processes their jobs where they do not fetch
them themselves, in `work`, `short_only` ones none that are long.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sightline.infra.jobs.one_machine import OneMachine
    from sightline.infra.jobs.postgres import OnPostgres


def engine_of(dialect: str) -> OneMachine | OnPostgres:
    """The engine for "sqlite" or "postgresql"."""
    # Procrastinate is imported only where it is used: a laptop's start needs none of it.
    if dialect == "postgresql":
        from sightline.infra.jobs.postgres import OnPostgres

        return OnPostgres()
    from sightline.infra.jobs.one_machine import OneMachine

    return OneMachine()
