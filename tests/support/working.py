"""Does queued jobs in the test's own process, one after the other, as a worker would."""

from sightline import job_handlers
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.runner import Runner
from sightline.infra.jobs.store import get_job, queued_jobs
from sightline.infra.services import Services


def run_jobs(services: Services) -> list[Job]:
    """Run every queued job to its end and give them back as they ended."""
    assert job_handlers.MODULES
    runner = Runner(services, "this process")
    with services.reading() as session:
        waiting = queued_jobs(session)
    for job_id in waiting:
        runner.run(job_id)
    with services.reading() as session:
        return [get_job(session, job_id) for job_id in waiting]
