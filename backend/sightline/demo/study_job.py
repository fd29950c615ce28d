"""The job that makes the demonstration study; apart from its making, so that no start loads what it needs."""

from sightline.demo.request import STUDY_KIND
from sightline.infra.jobs import registry


@registry.handler(STUDY_KIND, long=True)
def make_demonstration_study(context: registry.JobContext) -> registry.Outcome:
    """Simulate and store each site that is not there."""
    from sightline.demo.invented import make

    return make(context)
