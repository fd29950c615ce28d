"""The rules of the records: who may, what conflicts, what follows from what."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any, get_args

import pytest
from sqlalchemy.orm import Session

from sightline.cameras.store import choose_calibration, create_camera, get_camera
from sightline.enums import InsetName
from sightline.errors import BadInput, Conflict, NotAllowed, NotFound, NotSignedIn
from sightline.infra.backup.state import needed_media
from sightline.infra.jobs.store import create_job
from sightline.measurements.sheets.query import get_sheet, list_sheets
from sightline.measurements.store import (
    add_measurement,
    get_measurement,
    list_measurements,
    measurement_revisions,
    restore_measurement,
    revise_measurement,
    withdraw_measurement,
)
from sightline.messages.said import Said
from sightline.people.store import (
    create_person,
    create_sign_in_link,
    set_password,
    update_person,
    use_sign_in_link,
)
from sightline.poses.store import get_pose, list_poses
from sightline.recordings.filming import Filming
from sightline.recordings.records import RecordingChanges
from sightline.recordings.store import (
    get_recording,
    list_recordings,
    note_ingested,
    remove_recording,
    update_recording,
)
from sightline.recordings.uploads.store import (
    create_upload,
    finish_upload,
    get_upload,
    remove_upload,
    unfinished_uploads,
)
from sightline.results.overview.query import survey_overview
from sightline.reviews.query import measurement_history
from sightline.reviews.store import add_review, review_queue
from sightline.surveys.records import Inset
from sightline.surveys.store import create_survey, get_survey, update_survey
from sightline.vehicles.catalogue.records import CatalogueRow
from sightline.vehicles.catalogue.store import add_catalogue_row, import_catalogue_rows, search_catalogue
from sightline.vehicles.store import (
    create_vehicle,
    get_vehicle,
    remove_vehicle,
    restore_vehicle,
    update_vehicle,
)
from tests.support import samples
from tests.support.samples import KEY, Sample, values

pytestmark = pytest.mark.dialect


@pytest.fixture
def one(session: Session) -> Iterator[Sample]:
    yield samples.sample(session)


def state(session: Session, one: Sample) -> str:
    return get_sheet(session, one.vehicle.id).state


def test_a_vehicles_state_follows_from_its_measurements(session: Session, one: Sample) -> None:
    assert state(session, one) == "to_do"
    roof = samples.measure(session, one, "roof", 1)
    assert state(session, one) == "partial"
    others = [samples.measure(session, one, "driver_eye", 2), samples.measure(session, one, "taillight", 3)]
    assert state(session, one) == "measured"
    for made in [roof, *others]:
        add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)
    assert state(session, one) == "accepted"
    add_review(
        session, roof.id, seen_revision=1, verdict="rejected", reason="Not the roof.", actor=one.rene.id
    )
    assert state(session, one) == "rejected"
    again = revise_measurement(session, roof, values(one, target_point=(5.0, 6.0)), actor=one.olga.id)
    assert (again.revision, again.review.verdict, state(session, one)) == (2, "to_review", "measured")
    withdraw_measurement(session, roof.id, seen_revision=2, actor=one.olga.id)
    assert state(session, one) == "partial"
    counts = survey_overview(session, one.survey.id).counts
    assert (counts.measurements, counts.accepted, counts.to_review, counts.vehicles_measured) == (2, 2, 0, 0)
    restore_measurement(session, roof.id, seen_revision=3, actor=one.olga.id)
    assert state(session, one) == "measured"
    assert [r.withdrawn for r in measurement_revisions(session, roof.id)] == [
        False,
        False,
        True,
        False,
    ]


def test_the_steps_of_a_survey_lead_on(session: Session) -> None:
    def steps() -> list[str]:
        return [step.state for step in survey_overview(session, survey.id).steps]

    survey = create_survey(session, name="New", actor=None)
    assert steps() == ["next"] + ["waiting"] * 5
    camera = create_camera(session, survey.id, name="Left", actor=None)
    calibration = samples.calibration(session, camera.id, None)
    assert steps()[:2] == ["done", "next"]
    recording = samples.add_recording(session, survey.id, None)
    samples.road_pose(session, recording.id, calibration.id, None)
    assert steps()[1:4] == ["next", "done", "waiting"]
    filming = Filming(datetime(2026, 5, 3, 6, 10, tzinfo=UTC), "Europe/Paris")
    confirmed: RecordingChanges = {"lighting": "daytime", "filming": filming}
    update_recording(session, recording.id, confirmed, actor=None)
    assert steps() == ["done", "done", "done", "next", "waiting", "waiting"]
    words = [str(one) for step in survey_overview(session, survey.id).steps for one in step.summary]
    assert len(words) == 6 and all(one.endswith(".") and one.count(".") == 1 for one in words)


def test_nobody_reviews_their_own(session: Session, one: Sample) -> None:
    made = samples.measure(session, one)
    with pytest.raises(NotAllowed, match="your own"):
        add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.olga.id)
    assert [item.mine for item in review_queue(session, one.survey.id, actor=one.olga.id)] == [True]
    fix = values(one, target_point=(1.0, 2.0))
    fixed = add_review(session, made.id, seen_revision=1, verdict="fixed", fixed=fix, actor=one.rene.id)
    assert (fixed.revision, fixed.review.verdict, fixed.values.target_point) == (2, "fixed", (1.0, 2.0))
    assert fixed.created_by is not None and fixed.created_by.name == "René"
    with pytest.raises(NotAllowed):
        add_review(session, made.id, seen_revision=2, verdict="accepted", actor=one.rene.id)
    history = measurement_history(session, made.id)
    assert [r.review.verdict for r in history.revisions] == ["to_review", "fixed"]
    assert [(r.revision, r.result_revision) for r in history.reviews] == [(1, 2)]


def test_a_reopened_measurement_waits_again(session: Session, one: Sample) -> None:
    made = samples.measure(session, one)
    with pytest.raises(Conflict, match="waiting for a review"):
        add_review(session, made.id, seen_revision=1, verdict="reopened", actor=one.rene.id)
    add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)
    assert review_queue(session, one.survey.id, actor=None) == ()
    assert len(review_queue(session, one.survey.id, state="accepted", actor=None)) == 1
    add_review(session, made.id, seen_revision=1, verdict="reopened", actor=one.rene.id)
    (item,) = review_queue(session, one.survey.id, actor=None)
    assert item.measurement.review.verdict == "reopened" and item.vehicle.number == 1
    assert survey_overview(session, one.survey.id).counts.to_review == 1


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"verdict": "rejected"}, "needs a reason"),
        ({"verdict": "rejected", "reason": "  "}, "needs a reason"),
        ({"verdict": "fixed"}, "needs the new points"),
    ],
)
def test_a_verdict_needs_what_belongs_to_it(
    session: Session, one: Sample, given: dict[str, Any], words: str
) -> None:
    made = samples.measure(session, one)
    with pytest.raises(BadInput, match=words):
        add_review(session, made.id, seen_revision=1, actor=one.rene.id, **given)


def test_the_second_of_two_tabs_is_told(session: Session, one: Sample) -> None:
    update_vehicle(session, one.vehicle.id, {"make": "Renault"}, version=1, actor=one.rene.id)
    with pytest.raises(Conflict, match=r"^René changed vehicle 1 at \d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC;"):
        update_vehicle(session, one.vehicle.id, {"make": "Dacia"}, version=1, actor=one.olga.id)
    assert get_vehicle(session, one.vehicle.id).make == "Renault"
    with pytest.raises(Conflict, match="René changed vehicle"):
        remove_vehicle(session, one.vehicle.id, version=1, actor=one.olga.id)
    renamed = replace(one.survey, name="S", version=1)
    update_survey(session, renamed, actor=one.rene.id)
    with pytest.raises(Conflict, match=r"^René changed this survey at"):
        update_survey(session, renamed, actor=one.olga.id)
    made = samples.measure(session, one)
    revise_measurement(session, made, values(one), actor=one.rene.id)
    with pytest.raises(Conflict, match=r"^René changed this measurement at"):
        withdraw_measurement(session, made.id, seen_revision=1, actor=one.olga.id)


def test_a_click_sent_twice_is_one_measurement(session: Session, one: Sample) -> None:
    made = samples.measure(session, one)
    again = samples.measure(session, one)
    assert again == made and len(list_measurements(session, one.survey.id)) == 1
    other = create_vehicle(session, one.recording.id, {"first_frame": 1, "last_frame": 2}, actor=None)
    with pytest.raises(Conflict, match="another vehicle"):
        add_measurement(session, other.id, client_key=KEY.format(1), values=values(one), actor=None)
    assert (made.values.height_m, made.values.contact, made.values.sigma_px, made.values.budget) == (
        1.6180339887,
        (301.5, 400.0),
        1.0,
        [{"source": "clicks", "u_m": 0.004}],
    )


def test_a_measurement_stands_on_the_stored_frame(session: Session, one: Sample) -> None:
    for wrong, error in (({"pts": 1}, Conflict), ({"frame_crc32": 1}, Conflict), ({"frame": 500}, NotFound)):
        with pytest.raises(error):
            add_measurement(
                session, one.vehicle.id, client_key=KEY.format(9), values=values(one, **wrong), actor=None
            )
    above = Said("height-contact-above-horizon")
    nothing = values(one, height_m=None, status="not_measurable", reason=above)
    made = add_measurement(session, one.vehicle.id, client_key=KEY.format(9), values=nothing, actor=None)
    assert (made.values.status, made.values.reason, made.values.height_m) == (
        "not_measurable",
        above,
        None,
    )


def test_a_measured_recording_stays_with_its_frames(session: Session, one: Sample) -> None:
    samples.measure(session, one)
    with pytest.raises(Conflict, match="has measurements"):
        remove_recording(session, one.recording.id, actor=None)
    again = samples.frame_table()
    note_ingested(session, one.recording.id, samples.facts(), again, actor=None)
    with pytest.raises(Conflict, match="not those that were measured"):
        note_ingested(session, one.recording.id, samples.facts(), samples.frame_table(99), actor=None)


def test_a_deleted_recording_is_gone_but_its_media_may_be_shared(session: Session, one: Sample) -> None:
    other = samples.add_recording(session, one.survey.id, None)
    remove_recording(session, other.id, actor=None)
    with pytest.raises(NotFound, match=f"no recording {other.id}"):
        get_recording(session, other.id)
    assert needed_media(session, other.media_key)
    assert [r.id for r in list_recordings(session, one.survey.id)] == [one.recording.id]


def test_a_deleted_vehicle_leaves_lists_and_counts_and_comes_back(session: Session, one: Sample) -> None:
    samples.measure(session, one)
    assert remove_vehicle(session, one.vehicle.id, version=1, actor=None).deleted
    assert list_sheets(session, one.survey.id) == ()
    assert list_measurements(session, one.survey.id) == ()
    assert review_queue(session, one.survey.id, actor=None) == ()
    counts = survey_overview(session, one.survey.id).counts
    assert (counts.vehicles, counts.measurements) == (0, 0)
    restore_vehicle(session, one.vehicle.id, actor=None)
    assert state(session, one) == "partial"
    assert len(review_queue(session, one.survey.id, actor=None)) == 1


@pytest.mark.parametrize(
    "wrong",
    [
        {"first_frame": 9, "last_frame": 8},
        {"first_frame": 0, "last_frame": 100},
        {"best_frame": 99, "first_frame": 0, "last_frame": 9},
        {"manufacturer_height_m": 1624.0},
        {"colour": "red"},
    ],
)
def test_a_vehicle_that_cannot_be_is_refused(session: Session, one: Sample, wrong: Any) -> None:
    with pytest.raises(BadInput):
        update_vehicle(session, one.vehicle.id, wrong, version=1, actor=None)


def test_things_of_another_survey_are_refused(session: Session, one: Sample) -> None:
    survey = create_survey(session, name="Other", actor=None)
    camera = create_camera(session, survey.id, name="Other", actor=None)
    calibration = samples.calibration(session, camera.id, None)
    with pytest.raises(BadInput, match="another"):
        update_recording(session, one.recording.id, {"camera_id": camera.id}, actor=None)
    with pytest.raises(BadInput, match="another"):
        samples.road_pose(session, one.recording.id, calibration.id, None)
    with pytest.raises(BadInput, match="another"):
        choose_calibration(session, one.camera.id, calibration.id, actor=None)
    assert [pose.id for pose in list_poses(session, one.survey.id)] == [one.pose.id]


def test_the_catalogue_completes_words(session: Session) -> None:
    rows = [
        CatalogueRow("Citroën", "C3 Aircross", 2017, None, "suv", 1.637),
        CatalogueRow("Peugeot", "3008", 2016, 2023, "suv", 1.624),
        CatalogueRow("Toyota", "Corolla Liftback", 1997),
        CatalogueRow("Corvus", "100%_x", 2001),
    ]
    import_catalogue_rows(session, rows, actor=None)

    def found(q: str) -> list[str]:
        return [entry.model for entry in search_catalogue(session, q)]

    assert found("cor li") == ["Corolla Liftback"] and found("COR") == ["100%_x", "Corolla Liftback"]
    assert found("citroen") == found("Citroë") == ["C3 Aircross"]
    assert found("peu 3008 2016") == ["3008"] and found("008") == [] and found("%") == []
    assert found("100%_") == ["100%_x"] and len(found("")) == 4
    again = import_catalogue_rows(
        session, [CatalogueRow("PEUGEOT", "3008", 2016, None, None, 1.6)], actor=None
    )
    assert (again.added, again.updated) == (0, 1)
    assert search_catalogue(session, "3008")[0].height_m == 1.6
    with pytest.raises(BadInput, match="in metres"):
        add_catalogue_row(session, CatalogueRow("A", "B", height_m=1624), actor=None)


def test_sign_in_links_work_once_and_not_for_ever(session: Session) -> None:
    ada = samples.person(session, "Ada", "admin")
    first, second = (create_sign_in_link(session, ada.id, actor=None) for _ in range(2))
    with pytest.raises(NotSignedIn):
        use_sign_in_link(session, first)  # a newer one was made
    assert use_sign_in_link(session, second).id == ada.id
    for token in (second, "guess", ""):
        with pytest.raises(NotSignedIn):
            use_sign_in_link(session, token)
    old = create_sign_in_link(session, ada.id, actor=None, valid_for=timedelta(seconds=-1))
    with pytest.raises(NotSignedIn):
        use_sign_in_link(session, old)


def test_the_last_admin_stays(session: Session) -> None:
    ada = samples.person(session, "Ada", "admin")
    for change in ({"role": "viewer", "active": True}, {"role": "admin", "active": False}):
        with pytest.raises(Conflict, match="last admin"):
            update_person(session, ada.id, name="Ada", actor=ada.id, **change)  # type: ignore[arg-type]
    samples.person(session, "Bob", "admin")
    gone = update_person(session, ada.id, name="Ada", role="admin", active=False, actor=None)
    assert gone.session_key != ada.session_key
    with pytest.raises(Conflict, match="already an account"):
        create_person(session, name="x", email="ADA@example.org ", role="viewer", actor=None)
    assert set_password(session, ada.id, "h", actor=None).has_password


def test_an_upload_ends_once(session: Session, one: Sample) -> None:
    size = 3 * 2**31
    up = create_upload(
        session, one.survey.id, filename="a.mp4", size_bytes=size, media_key="u", actor=one.olga.id
    )
    assert get_upload(session, up.id).size_bytes == size
    assert [one_.id for one_ in unfinished_uploads(session)] == [up.id]
    finish_upload(session, up.id, recording_id=one.recording.id, actor=None)
    assert unfinished_uploads(session, one.survey.id) == ()
    with pytest.raises(Conflict):
        remove_upload(session, up.id, actor=None)


def test_insets_start_with_defaults_and_are_checked(session: Session, one: Sample) -> None:
    assert set(one.survey.insets) == set(get_args(InsetName))
    seen = replace(one.survey, insets={"roof": Inset(0.4, 0.05, "seen")})
    changed = update_survey(session, seen, actor=None)
    assert changed.insets["roof"] == Inset(0.4, 0.05, "seen")
    assert changed.insets["taillight"] == one.survey.insets["taillight"]
    with pytest.raises(BadInput, match="wheel"):
        update_survey(session, replace(changed, insets={"wheel": Inset(0, 0)}), actor=None)


def test_a_recording_shows_its_latest_job(session: Session, one: Sample) -> None:
    for _ in range(2):
        made = create_job(
            session, "ingest", {}, survey_id=one.survey.id, recording_id=one.recording.id, actor=None
        )
    shown = list_recordings(session, one.survey.id)[0].job
    assert shown is not None and shown.id == made.id


def test_what_is_not_there_is_said_in_words(session: Session) -> None:
    for look in (get_survey, get_camera, get_recording, get_vehicle, get_measurement, get_pose):
        with pytest.raises(NotFound, match=r"^There is no [a-z ]+ 77; "):
            look(session, 77)
