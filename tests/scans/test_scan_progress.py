"""What a survey says of its line scans: counts, what comes next, and what its traffic says of the rig."""

from collections.abc import Sequence
from dataclasses import replace

import pytest
from sqlalchemy.orm import Session

from sightline.errors import Conflict
from sightline.messages.said import Said
from sightline.results.overview.query import survey_overview
from sightline.scans.rig.service import rig_of_traffic
from sightline.scans.store import swap_scan_cameras, update_scan
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.store import change_scan_vehicle, create_scan_vehicle, list_scan_vehicles
from sightline.surveys.store import create_survey
from tests.support import samples, scans_samples
from tests.support.samples import Sample
from tests.support.scans_samples import RIG, values

pytestmark = pytest.mark.dialect


def vehicles(session: Session, one: Sample, scan_id: int, bases_m: Sequence[float]) -> list[int]:
    """Vehicles with a measured wheelbase each and a known one of 2.6 m; their measurements' ids."""
    made = []
    for base in bases_m:
        car = create_scan_vehicle(session, scan_id, origin="found", actor=None)
        known = {"true_wheelbase_m": 2.6, "u_true_wheelbase_m": 0.002}
        car = change_scan_vehicle(
            session,
            car.id,
            known,
            version=car.version,
            actor=one.olga.id,
        )
        found = values(wheelbase_m=base, u_wheelbase_m=0.004)
        made.append(
            append_scan_measurement(session, car.id, found, version=car.version, actor=one.olga.id).id
        )
    return made


def test_a_survey_tells_of_its_line_scans(session: Session) -> None:
    one = samples.sample(session)
    told = survey_overview(session, one.survey.id).scans
    assert (told.state, told.scans) == ("none", 0)
    scans_samples.scan(session, one)
    (said,) = survey_overview(session, one.survey.id).scans.summary
    assert str(said) == "1 line scan still being imported."
    scan = scans_samples.ready(session, one)
    assert Said("overview-scans-find", count=1) in survey_overview(session, one.survey.id).scans.summary
    measured = vehicles(session, one, scan.id, [2.6, 2.6])
    add_scan_review(session, measured[0], verdict="accepted", actor=one.rene.id)
    told = survey_overview(session, one.survey.id).scans
    assert (told.state, told.scans, told.ready, told.vehicles) == ("open", 2, 1, 2)
    assert (told.to_review, told.accepted) == (1, 1)
    assert "Review 1 of 2 vehicles." in map(str, told.summary)
    assert any(step.state == "next" for step in survey_overview(session, one.survey.id).steps)
    alone = create_survey(session, name="Scans only", site="", description="", actor=one.olga.id)
    empty = survey_overview(session, alone.id)
    assert empty.scans.state == "none" and empty.steps[0].state == "next"
    scans_samples.scan(session, replace(one, survey=alone))
    scanned = survey_overview(session, alone.id)
    assert scanned.scans.scans == 1 and {step.state for step in scanned.steps} == {"waiting"}


def test_known_wheelbases_imply_a_baseline(session: Session) -> None:
    one = samples.sample(session)
    scan = scans_samples.ready(session, one)
    vehicles(session, one, scan.id, [2.626, 2.627, 2.625, 2.624])
    few = rig_of_traffic(session, scan.id)
    assert few.misalignment.value is None and "5 are needed" in str(few.misalignment.reason)
    assert few.baselines[0].baseline_m is None and few.baselines[0].words == few.baselines[0].ratio.reason
    vehicles(session, one, scan.id, [2.628, 2.626])
    told = rig_of_traffic(session, scan.id)
    assert told.misalignment.value == pytest.approx(0.41) and told.misalignment.n == 6
    assert told.gain.value == pytest.approx(1.04)
    base, length = told.baselines
    assert base.of == "wheelbase" and base.differs and "shorter baseline" in str(base.words)
    assert base.baseline_m == pytest.approx(RIG.baseline_m * 2.6 / 2.626, rel=2e-4)
    assert length.ratio.n == 0 and length.baseline_m is None
    # put in force, the same measurements agree, though they were made with the old one
    change = {"baseline_m": base.baseline_m, "misalignment_px": 0.41}
    update_scan(session, scan.id, change, version=scan.version, actor=one.olga.id)
    again = rig_of_traffic(session, scan.id).baselines[0]
    assert not again.differs and again.baseline_m == pytest.approx(base.baseline_m, rel=1e-9)


def test_cameras_given_the_wrong_way_round_are_exchanged(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.ready(session, one)
    given = update_scan(session, made.id, {"misalignment_px": 0.4}, version=1, actor=one.olga.id)
    swapped = swap_scan_cameras(session, made.id, version=2, actor=one.olga.id)
    assert (swapped.first_name, swapped.second_name) == ("b.tif", "a.tif")
    assert (swapped.first_sha256, swapped.second_key) == (given.second_sha256, given.first_key)
    assert (swapped.rig.misalignment_px, swapped.rig.baseline_m) == (-0.4, given.rig.baseline_m)
    with pytest.raises(Conflict, match="Olga changed Gate"):
        swap_scan_cameras(session, made.id, version=2, actor=one.rene.id)
    vehicles(session, one, made.id, [2.6])
    car = list_scan_vehicles(session, made.id)[0]
    change = {"make": "Fiat"}
    change_scan_vehicle(session, car.id, change, version=car.version, actor=one.olga.id)
    with pytest.raises(Conflict, match="with the strips swapped"):
        swap_scan_cameras(session, made.id, version=3, actor=one.olga.id)
