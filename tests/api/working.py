"""Does queued jobs in the test's own process, one after the other, as a worker would."""

from backend.storage import jobs as table
from backend.storage.records import Job
from backend.work import jobs
from backend.work.runner import Runner
from backend.work.services import Services


def run_jobs(services: Services) -> list[Job]:
    """Run every queued job to its end and give them back as they ended."""
    jobs.load_handlers()
    runner = Runner(services.settings, services.sessions)
    with services.reading() as session:
        waiting = table.queued(session)
    for job_id in waiting:
        runner.run(job_id)
    with services.reading() as session:
        return [table.get(session, job_id) for job_id in waiting]
