"""A package is outdated when what its tables hold was added to or changed, counted by places in the chain."""

import pytest
from sqlalchemy import event
from sqlalchemy.orm import Session

from sightline.export.store import add_export, seal_package
from sightline.infra.audit import trail
from sightline.infra.jobs.store import create_job
from sightline.measurements.store import withdraw_measurement
from sightline.results.overview.package_query import changes_since_packages
from sightline.results.overview.query import survey_overview, survey_overviews
from sightline.results.overview.records import ChangesSince, Step
from sightline.reviews.plan_store import choose_review_plan
from sightline.reviews.store import add_review
from tests.support import samples, scans_samples
from tests.support.samples import Sample

pytestmark = pytest.mark.dialect


def package(session: Session, one: Sample, as_of: int | None = None) -> int:
    """A package that was sealed now, whose tables were read after the event `as_of`, by default after all."""
    read = trail.head(session, one.survey.id).count if as_of is None else as_of
    seal_package(session, one.survey.id, {"as_of": read, "files": {}}, actor=None)
    content = {"media_key": "a.zip", "size_bytes": 9, "sha256": "0" * 64}
    head = trail.head(session, one.survey.id)
    return add_export(session, one.survey.id, **content, head=head, actor=one.olga.id).id


def results(session: Session, one: Sample) -> Step:
    return survey_overview(session, one.survey.id).steps[-1]


def since(session: Session, one: Sample) -> ChangesSince | None:
    return survey_overview(session, one.survey.id).since_package


def test_without_a_package_none_is_outdated(session: Session) -> None:
    one = samples.sample(session)
    samples.measure(session, one)
    assert since(session, one) is None and results(session, one).state == "waiting"


def test_heights_since_are_counted_once_each_and_the_step_is_not_done(session: Session) -> None:
    one = samples.sample(session)
    samples.measure(session, one)
    first = package(session, one)
    assert since(session, one) == ChangesSince() and results(session, one).state == "done"
    roof = samples.measure(session, one, "taillight", key=2)
    samples.measure(session, one, "driver_eye", key=3)
    withdraw_measurement(session, roof.id, seen_revision=1, actor=one.olga.id)
    assert since(session, one) == ChangesSince(heights=2)
    assert results(session, one).state == "begun"
    second = package(session, one)
    assert since(session, one) == ChangesSince() and results(session, one).state == "done"
    # what the older one lacks is told of it still
    found = changes_since_packages(session, [first, second])
    assert found == {first: ChangesSince(heights=2), second: ChangesSince()}


def test_what_came_while_a_package_was_built_is_not_in_it(session: Session) -> None:
    one = samples.sample(session)
    read = trail.head(session, one.survey.id).count
    samples.measure(session, one)
    package(session, one, as_of=read)
    assert since(session, one) == ChangesSince(heights=1)


def test_verdicts_and_facts_count_and_what_no_table_holds_does_not(session: Session) -> None:
    one = samples.sample(session)
    made = samples.measure(session, one)
    package(session, one)
    create_job(session, "ingest", {}, survey_id=one.survey.id, actor=one.olga.id)
    choose_review_plan(session, one.survey.id, blind_one_in=3, version=0, actor=one.rene.id)
    assert since(session, one) == ChangesSince() and results(session, one).state == "done"
    add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)
    assert since(session, one) == ChangesSince(reviews=1)
    samples.photograph(session, one)
    assert since(session, one) == ChangesSince(reviews=1, other=1)


def test_a_height_of_a_line_scan_counts_once_however_often_it_is_clicked(session: Session) -> None:
    one = samples.sample(session)
    car = scans_samples.vehicle(session, one)
    pose = scans_samples.rod(session, one, car.scan_id)
    package(session, one)
    scans_samples.tall(session, one, car.id, pose)
    scans_samples.tall(session, one, car.id, pose, seen_revision=1)
    scans_samples.tall(session, one, car.id, pose, target="taillight")
    assert since(session, one) == ChangesSince(heights=2)


def test_another_survey_s_heights_make_no_package_outdated_and_many_surveys_take_no_more_queries(
    session: Session,
) -> None:
    one = samples.sample(session)
    package(session, one)
    other = samples.sample(session, of=("Ada", "Bob"))
    samples.measure(session, other, key=9)
    assert since(session, one) == ChangesSince()
    asked: list[str] = []
    event.listen(session.get_bind(), "before_cursor_execute", lambda *told: asked.append(told[2]))
    survey_overviews(session)
    few = len(asked)
    package(session, other)
    samples.measure(session, other, "taillight", key=10)
    asked.clear()
    by_id = {found.survey.id: found.since_package for found in survey_overviews(session)}
    assert by_id == {one.survey.id: ChangesSince(), other.survey.id: ChangesSince(heights=1)}
    assert len(asked) == few
