"""The job that makes the demonstration survey; apart from its making, for a start needs none of it."""

from sightline.demo.request import KIND
from sightline.infra.jobs import registry


@registry.handler(KIND, long=True)
def make_demonstration(context: registry.JobContext) -> registry.Outcome:
    """Solve and store everything, unless the survey is there."""
    from sightline.demo.build import make

    return make(context)
