"""Why a job failed is kept as a key with its values, and said in the language of whoever asks."""

import json

import numpy as np
import pytest

from sightline.errors import BadInput, SightlineError
from sightline.geometry.board import Board
from sightline.geometry.calibration import calibrate
from sightline.geometry.corners import find_board
from sightline.infra.jobs import registry
from sightline.infra.jobs.runner import Runner
from sightline.infra.jobs.store import get_job
from sightline.infra.services import Services
from sightline.infra.web.spoken import said_by_key, translate_body
from sightline.job_handlers import MODULES
from sightline.messages import say
from sightline.recordings import ingest_job
from tests.infra.jobs import handlers
from tests.infra.jobs.test_runner import queued
from tests.support.app import Client

assert handlers


@pytest.mark.parametrize(
    ("how", "code", "french"),
    [
        (
            "input",
            "said",
            "The video has no picture; upload another.",
        ),  # a sentence that nobody has translated
        ("program", "jobs-broke", "Une erreur du programme a arrêté la tâche (ZeroDivisionError)"),
    ],
)
def test_a_failed_job_says_why_in_the_language_of_who_asks(
    services: Services, viewer: Client, how: str, code: str, french: str
) -> None:
    job = queued(services.sessions, "test_fail", how=how)
    assert Runner(services, "worker").run(job.id)
    with services.reading() as session:
        kept = get_job(session, job.id)
    assert kept.state == "failed" and kept.error is not None and kept.error.code == code
    assert viewer.seen(f"/jobs/{job.id}")["error"] == kept.error.body
    answer = viewer.http.get(f"/api/jobs/{job.id}", headers={"Accept-Language": "fr"}).json()["error"]
    assert answer["message"].startswith(french)
    assert {name: answer[name] for name in ("code", "values")} == kept.error.document


def test_a_sentence_is_said_by_its_key_and_a_value_that_is_a_sentence_too() -> None:
    error = BadInput("no-such-language", language="xx", known="en, fr")
    told = json.loads(translate_body(json.dumps({"error": error.said.body}).encode(), "fr"))["error"]
    assert told["message"].startswith("Il n’y a pas de rapport dans la langue")
    assert (told["code"], told["values"]) == (error.code, error.values)
    within = SightlineError("said", sentence=ingest_job.STOPPED)
    kept = {"code": within.code, "values": within.values}
    assert said_by_key(kept, "", "fr").startswith("L’import a été annulé")


def test_what_a_budget_is_of_stays_a_name_which_the_page_says_in_words() -> None:
    body = {"budget": [{"source": "click, target", "u_m": 0.01}], "reference": {"source": "fit", "value": 3}}
    told = json.loads(translate_body(json.dumps(body).encode(), "fr"))
    assert told == body


def test_pictures_without_a_board_say_why_in_french_to_the_last_word() -> None:
    board = Board(9, 6, 0.1)
    corners = find_board(np.full((120, 160), 128, np.uint8), board)
    with pytest.raises(BadInput, match=r"cut\.png: No board of 9x6") as few:
        calibrate([("cut.png", corners, (160, 120))], board)
    told = said_by_key({"code": few.value.code, "values": few.value.values}, few.value.message, "fr")
    assert told.startswith("Photos utilisables") and "cut.png\u00a0: Aucune mire de 9x6" in told
    assert " the " not in told


@pytest.mark.parametrize("said", [{"code": "gone", "values": {}}, {"code": "said", "values": {}}])
def test_what_this_program_cannot_say_stays_as_it_was_kept(said: dict[str, object]) -> None:
    assert said_by_key(said, "It is gone.", "fr") == "It is gone."


@pytest.mark.parametrize("language", ["en", "fr"])
def test_every_kind_of_job_has_a_name(language: str) -> None:
    assert MODULES  # imported: their handlers are registered
    kinds = [name for name in registry.kinds() if not name.startswith("test_")]
    other = say("jobs-kind", {"kind": "a kind of an earlier program"}, language)
    named = {kind: say("jobs-kind", {"kind": kind}, language) for kind in kinds}
    assert len(kinds) > 10 and other not in named.values(), named
    assert len(set(named.values())) == len(kinds)
