"""A study is no way around membership: who computes, opens or downloads it sees its surveys just then."""

from collections.abc import Callable

import pytest

from sightline.infra.audit import trail
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.studies.store import add_study_result, get_study
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect
EMPTY = ("notes", "curves", "packages", "figures", "rules", "years", "errors", "classes", "plan")
FOUND = {"heights": 3, "vehicles": 3, "consequence": None, "language": "en", **{name: [] for name in EMPTY}}


def id_of(client: Client) -> int:
    return int(client.seen("/session")["person"]["id"])


@pytest.fixture
def surveys(admin: Client, operator: Client, reviewer: Client) -> tuple[int, int]:
    """Two closed surveys that the operator looks at; the first is the reviewer's own."""
    first = int(reviewer.made("/surveys", {"name": "Hill"})["id"])
    second = int(admin.made("/surveys", {"name": "Dale"})["id"])
    for survey in (first, second):
        put(admin, survey, operator, "viewer")
    return first, second


def put(admin: Client, survey_id: int, client: Client, role: str) -> None:
    answer = admin.put(f"/surveys/{survey_id}/members/{id_of(client)}", {"role": role})
    assert answer.status_code == 200, answer.text


def take_out(admin: Client, survey_id: int, client: Client) -> None:
    assert admin.delete(f"/surveys/{survey_id}/members/{id_of(client)}").status_code == 200


def study_of(client: Client, survey_ids: tuple[int, ...], name: str = "Both") -> str:
    body = {"name": name, "surveys": [{"survey_id": one} for one in survey_ids]}
    return f"/studies/{client.made('/studies', body)['id']}"


def computed(services: Services, study_id: int, survey_ids: tuple[int, ...]) -> int:
    """A result of a study, as its job stores one."""
    files = {}
    for name in ("media_key", "report_key"):
        path = services.scratch / name
        path.write_bytes(b"%PDF")
        files[name] = f"of-study/{name}"
        services.media.put_file(files[name], path)
    with services.writing() as session:
        heads = {one: trail.head(session, one).hash for one in survey_ids}
        made = add_study_result(
            session,
            get_study(session, study_id),
            heads=heads,
            document=FOUND,
            **files,
            size_bytes=4,
            sha256="0" * 64,
            report_sha256="0" * 64,
            actor=None,
        )
    return made.id


def test_who_was_taken_out_of_a_survey_has_no_study_of_it(
    admin: Client, operator: Client, surveys: tuple[int, int], services: Services
) -> None:
    address = study_of(operator, surveys)
    study_id = int(address.rpartition("/")[2])
    result = computed(services, study_id, surveys)
    files = [f"{address}/results/{result}.{kind}" for kind in ("zip", "pdf")]
    for one in files:
        answer = operator.get(one)
        assert (answer.status_code, answer.headers["cache-control"]) == (200, "no-store")
    assert operator.seen(address)["result"]["id"] == result
    job = operator.made(f"{address}/computings")["id"]
    take_out(admin, surveys[0], operator)
    for one in (address, *files, f"{address}/members", f"{address}/beside{address}", f"/jobs/{job}"):
        assert operator.get(one).status_code == 404, one
    assert operator.seen("/studies") == [] and operator.seen("/jobs") == []
    for one in (f"{address}/computings", f"/jobs/{job}/cancel", f"/jobs/{job}/again"):
        assert operator.post(one).status_code == 404, one
    assert operator.put(f"{address}/open-to-all", {"open_to_all": True}).status_code == 404
    put(admin, surveys[0], operator, "viewer")
    assert operator.seen(address)["result"]["id"] == result


def test_what_waits_is_computed_only_for_who_still_sees_the_surveys(
    admin: Client, operator: Client, surveys: tuple[int, int], work: Callable[[], list[Job]]
) -> None:
    address = study_of(operator, surveys)
    operator.made(f"{address}/computings")
    take_out(admin, surveys[0], operator)
    (job,) = work()
    assert job.state == "failed" and job.error is not None
    assert str(job.error).startswith("You do not see every survey of this study now") and "Hill" not in str(
        job.error
    )


def test_a_result_of_more_surveys_than_one_sees_is_not_there(
    admin: Client, operator: Client, viewer: Client, surveys: tuple[int, int], services: Services
) -> None:
    """The study takes one survey less since: its members may see that one alone."""
    address = study_of(operator, surveys)
    study_id = int(address.rpartition("/")[2])
    result = computed(services, study_id, surveys)
    change = {"name": "Both", "version": 1, "surveys": [{"survey_id": surveys[1]}]}
    assert operator.put(address, change).status_code == 200
    put(admin, surveys[1], viewer, "viewer")
    assert operator.put(f"{address}/members/{id_of(viewer)}").status_code == 200
    assert viewer.seen(address)["result"] is None
    assert [one["heights"] for one in viewer.seen("/studies")] == [None]
    hidden, nothing = (viewer.get(f"{address}/results/{one}.zip") for one in (result, 4711))
    assert hidden.status_code == nothing.status_code == 404
    assert error_of(hidden).replace(str(result), "N") == error_of(nothing).replace("4711", "N")
    other = study_of(viewer_as_operator(admin, viewer), (surveys[1],), "Other")
    assert "has not been computed" in error_of(viewer.get(f"{other}/beside{address}"))
    assert operator.seen(address)["result"]["id"] == result


def viewer_as_operator(admin: Client, viewer: Client) -> Client:
    body = {"name": "Viewer", "role": "operator", "active": True}
    assert admin.put(f"/people/{id_of(viewer)}", body).status_code == 200
    return viewer


def test_only_who_manages_each_survey_opens_a_study_to_all(
    admin: Client, operator: Client, reviewer: Client, viewer: Client, surveys: tuple[int, int]
) -> None:
    address = study_of(operator, surveys)
    opened = {"open_to_all": True}
    refused = operator.put(f"{address}/open-to-all", opened)
    assert refused.status_code == 403 and "You do not manage Hill" in error_of(refused)
    put(admin, surveys[0], operator, "manager")
    refused = operator.put(f"{address}/open-to-all", opened)
    assert refused.status_code == 403 and "You do not manage Dale" in error_of(refused)
    assert viewer.get(address).status_code == 404
    put(admin, surveys[1], operator, "manager")
    assert operator.put(f"{address}/open-to-all", opened).status_code == 200
    assert viewer.seen(address)["study"]["name"] == "Both"
    # seen by all now; worked on by who sees each survey
    for answer in (
        reviewer.post(f"{address}/computings"),
        reviewer.put(address, {"name": "Mine", "version": 1}),
        reviewer.delete(f"{address}?version=1"),
        reviewer.put(f"{address}/open-to-all", {"open_to_all": False}),
        reviewer.put(f"{address}/members/{id_of(viewer)}"),
    ):
        assert answer.status_code == 403 and "every survey of this study" in error_of(answer), answer.text
    # and nothing is shown to all that its manager did not show
    third = int(admin.made("/surveys", {"name": "Moor"})["id"])
    put(admin, third, operator, "viewer")
    more = {"name": "Three", "version": 1, "surveys": [{"survey_id": one} for one in (*surveys, third)]}
    refused = operator.put(address, more)
    assert refused.status_code == 403 and "You do not manage Moor" in error_of(refused)


def test_what_went_into_a_result_is_asked_for_too(
    admin: Client, operator: Client, surveys: tuple[int, int], services: Services
) -> None:
    """A survey that was taken out of the study stands in its older results."""
    address = study_of(operator, surveys)
    computed(services, int(address.rpartition("/")[2]), surveys)
    change = {"name": "Both", "version": 1, "surveys": [{"survey_id": surveys[1]}]}
    assert operator.put(address, change).status_code == 200
    put(admin, surveys[1], operator, "manager")
    refused = operator.put(f"{address}/open-to-all", {"open_to_all": True})
    assert refused.status_code == 403 and "You do not manage Hill" in error_of(refused)


def test_an_administrator_sees_and_opens_every_study(
    admin: Client, operator: Client, viewer: Client, surveys: tuple[int, int]
) -> None:
    address = study_of(operator, surveys)
    assert admin.put(f"{address}/open-to-all", {"open_to_all": True}).status_code == 200
    assert viewer.get(address).status_code == 200
