"""The job that makes the demonstration survey; apart from its making, so that no start loads the renderer."""

from sightline.demo.request import KIND
from sightline.infra.jobs import registry


@registry.handler(KIND, long=True)
def make_demonstration(context: registry.JobContext) -> registry.Outcome:
    """Render, solve and store everything, unless the survey is there."""
    from sightline.demo.build import make

    return make(context)
