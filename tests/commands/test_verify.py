"""`sightline verify` with what was kept elsewhere: of data folders and backups, of several places at once."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.infra.audit.checkpoints import sign_checkpoint
from sightline.infra.audit.signing import SigningKey, signing_key
from sightline.infra.backup.make import make_backup
from sightline.infra.database.engine import make_engine, migrate
from sightline.infra.services import Services, open_services
from sightline.settings import Settings
from tests.support import samples

pytestmark = pytest.mark.once
Places = dict[str, str]


def installed(folder: Path) -> Services:
    """A data folder with an empty database."""
    folder.mkdir(exist_ok=True)
    settings = Settings(data_dir=folder)
    engine = make_engine(settings.database_url)
    migrate(engine)
    engine.dispose()
    return open_services(settings)


@pytest.fixture(scope="module")
def places(tmp_path_factory: pytest.TempPathFactory) -> Places:
    """A data folder that was signed, its backup, its signed checkpoint, key and heads; another's too."""
    folder = tmp_path_factory.mktemp("places")
    made: Places = {}
    for name in ("own", "other"):
        services = installed(folder / name)
        with services.writing() as session:
            samples.measure(session, samples.sample(session))
            signed = sign_checkpoint(session, signing_key(services.settings), actor=None)
        make_backup(services, folder / f"{name}-backup", lambda *_: None)
        services.close()
        kept = folder / f"{name}.json"
        kept.write_text(json.dumps(signed))
        made |= {name: str(folder / name), f"{name} backup": str(folder / f"{name}-backup")}
        made |= {f"{name} checkpoint": str(kept), f"{name} key": signed["key"]}
        made |= {f"{name} head": signed["ends"][-1][2]}
    (folder / "page.html").write_text("<!doctype html>")
    return made | {"evidence": str(folder / "page.html"), "missing": str(folder / "nothing")}


def verified(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any], str]:
    status = main(["verify", *arguments, "--json"])
    said = capsys.readouterr()
    assert "Traceback" not in said.err
    return status, json.loads(said.out) if said.out else {}, said.err


@pytest.mark.parametrize("place", ["own", "own backup"])
@pytest.mark.parametrize("anchor", ["head", "checkpoint"])
def test_each_anchor_holds_where_it_was_kept_and_nowhere_else(
    places: Places, capsys: pytest.CaptureFixture[str], place: str, anchor: str
) -> None:
    """Whatever does not hold is one JSON object with its problem, of a backup too."""
    status, told, _ = verified(capsys, places[place], f"--{anchor}", places[f"own {anchor}"])
    assert (status, told["status"], told["problems"], told["not_checked"]) == (0, "holds", [], [])
    assert told["count"] > 0 and len(told["head"]) == 64 and "key" in told
    status, told, said = verified(capsys, places[place], f"--{anchor}", places[f"other {anchor}"])
    assert (status, told["status"], len(told["problems"])) == (1, "broken", 1)
    assert places[place] in said and told["problems"][0] in said


def test_places_of_several_kinds_are_each_told(places: Places, capsys: pytest.CaptureFixture[str]) -> None:
    own, backup, other = places["own"], places["own backup"], places["other backup"]
    head = ["--head", places["own head"][:16].upper()]
    status, told, _ = verified(capsys, own, backup, own, *head, "--checkpoint", places["own checkpoint"])
    assert (status, told["status"]) == (0, "holds")
    assert [one["kind"] for one in told["places"]] == ["database", "backup", "database"]
    status, told, said = verified(capsys, own, other, backup, *head)
    assert (status, [one["status"] for one in told["places"]]) == (1, ["holds", "broken", "holds"])
    assert f"{other}: " in said and f"{own}: " not in said


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("own", "--head", "0123456789abcde"), "too short"),
        (("own", "--head", ""), "too short"),
        (("own", "--key", "0123456789abcde"), "too short"),
        (("own", "missing"), "does not exist"),
        (("missing",), "does not exist"),
        (("evidence", "--head", "own head"), "--head has no effect"),
        (("evidence", "--checkpoint", "own checkpoint"), "--checkpoint has no effect"),
        (("own", "evidence", "--head", "own head"), "--head has no effect"),
    ],
)
def test_what_cannot_be_read_or_means_nothing_is_status_2(
    places: Places, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], said: str
) -> None:
    status, told, told_of = verified(capsys, *(places.get(one, one) for one in arguments))
    assert status == 2 and told.get("status", "refused") == "refused" and said in told_of


@pytest.mark.parametrize("text", ["[]", "1", "null", "{}", '{"format": "sightline-checkpoint-1"}', "{"])
def test_what_is_no_checkpoint_is_status_2(
    places: Places, tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str
) -> None:
    (tmp_path / "kept.json").write_text(text)
    status, _, said = verified(capsys, places["own"], "--checkpoint", str(tmp_path / "kept.json"))
    assert status == 2 and "checkpoint" in said


def test_of_two_checkpoints_of_one_moment_both_are_held(
    places: Places, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """That of a package, which tells one chain, took the place of the whole one."""
    kept, other = (json.loads(Path(places[f"{name} checkpoint"]).read_text()) for name in ("own", "other"))
    key = SigningKey(b"2" * 32)
    named = {name: other[name] for name in ("format", "chains", "root")} | {
        "at": kept["at"],
        "key": key.public,
    }
    same = {**named, "signature": key.sign(named), "ends": other["ends"]}
    (tmp_path / "same.json").write_text(json.dumps(same))
    for order in (
        [str(tmp_path / "same.json"), places["own checkpoint"]],
        [places["own checkpoint"], str(tmp_path / "same.json")],
    ):
        given = [value for one in order for value in ("--checkpoint", one)]
        status, told, _ = verified(capsys, places["own"], *given)
        assert (status, told["status"]) == (1, "broken")
