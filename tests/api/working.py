"""Does queued jobs in the test's own process, one after the other."""

from backend.errors import SightlineError
from backend.storage import jobs as table
from backend.storage.records import Job
from backend.work import jobs
from backend.work.services import Services


def run_jobs(services: Services) -> list[Job]:
    """Run every queued job to its end and give them back as they ended."""
    jobs.load_handlers()
    with services.reading() as session:
        waiting = table.queued(session)
    done = []
    for job_id in waiting:
        with services.writing() as session:
            job = table.claim(session, job_id, worker="test", lease_s=60)
        assert job is not None
        done.append(_run(services, job))
    return done


def _run(services: Services, job: Job) -> Job:
    registered = jobs.registered(job.kind)
    assert registered is not None, job.kind
    context = jobs.JobContext(
        job, services.settings, services.sessions, lambda _share, _said: None, lambda: False
    )
    try:
        outcome = registered.run(context)
        with services.writing() as session:
            result = outcome(session) if callable(outcome) else outcome
            return table.finish(session, job, result)
    except SightlineError as error:
        with services.writing() as session:
            if registered.failed is not None:
                registered.failed(session, job, error.message)
            return table.fail(session, job, error.message)
