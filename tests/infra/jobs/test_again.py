"""Work that failed or was stopped is done once more; work that begins on a page of its own is not."""

import pytest

from sightline.errors import BadInput, Conflict
from sightline.infra.jobs import registry
from sightline.infra.services import Services
from sightline.people.store import create_person
from tests.infra.jobs import handlers

assert handlers


def test_only_what_failed_or_was_stopped_begins_once_more(services: Services) -> None:
    with services.writing() as session:
        actor = create_person(session, name="A", email="a@x.org", role="operator", actor=None).id
        made = registry.enqueue(session, "test_make_survey", {"name": "B"}, survey_id=None, actor=actor)
        with pytest.raises(Conflict, match="still queued"):
            registry.enqueue_again(session, made, actor)
        stopped = registry.cancel(session, made, actor)
        again = registry.enqueue_again(session, stopped, actor)
        assert (again.kind, again.payload, again.state) == (made.kind, made.payload, "queued")
        assert again.id != made.id
        marked = registry.enqueue(session, "test_fail", {"how": "input"}, survey_id=None, actor=actor)
        with pytest.raises(BadInput, match="page"):
            registry.enqueue_again(session, registry.cancel(session, marked, actor), actor)
