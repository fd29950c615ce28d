"""Every error of the command line is one sentence on standard error: status 2 for bad input, no traceback."""

import sqlite3
from pathlib import Path

import pytest

from sightline.cli import COMMANDS, cli, main
from tests.commands.running import sightline

pytestmark = pytest.mark.once


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_explains_itself(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([name, "--help"]) == 0
    assert f"sightline {name}" in capsys.readouterr().out


def test_help_lists_the_commands_of_the_contract(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    said = capsys.readouterr().out
    for name in (
        "serve",
        "demo",
        "calibrate",
        "import-camera",
        "pose",
        "height",
        "plan",
        "distribution",
        "linescan",
        "export",
        "verify",
        "worker",
        "sign-in-link",
    ):
        assert f"\n  {name} " in said
    assert cli.name == "cli"


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ([], "Usage"),
        (["measure"], "measure"),
        (["distribution", "nowhere.csv"], "nowhere.csv"),
        (["height"], "--pose"),
        (["height", "--pose", "nowhere.json", "--contact", "1,2", "--target", "3,4"], "nowhere.json"),
        (["export", "--survey", "X"], "--output"),
        (["export", "--survey", "X", "-o", "out", "--data-dir", "nowhere"], "nowhere"),
        (["verify", "nowhere"], "nowhere"),
        (["verify", "text.db"], "text.db"),
        (["verify", "other.db"], "other.db"),
        (["verify", "broken.zip"], "broken.zip"),
        (["verify", "empty"], "SHA256SUMS"),
        (["verify", "mysql://somewhere/else"], "mysql"),
        (["verify", "other.db", "--head", "0" * 15], "audit head is too short"),
        (["verify", "other.db", "--key", "0" * 15], "key is too short"),
        (["verify", "other.db", "--checkpoint", "text.db"], "text.db"),
        (["verify", "one.html", "--head", "0" * 64], "--head has no effect here"),
        (["worker", "--workers", "0"], "--workers"),
        (["sign-in-link"], "EMAIL"),
        (["sign-in-link", "ada@example.org", "--data-dir", "nowhere"], "nowhere"),
    ],
)
def test_bad_input_is_status_2_and_one_line(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    word: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("text.db").write_text("not a database, but long enough to have a header of a hundred bytes " * 3)
    Path("broken.zip").write_text("PK")
    Path("one.html").write_text("not the file of a vehicle")
    Path("empty").mkdir()
    sqlite3.connect("other.db").execute("CREATE TABLE letters (x)").connection.close()
    status = main(arguments)
    printed = capsys.readouterr()
    assert status == (1 if arguments == ["verify", "empty"] else 2), printed
    assert word in printed.err + printed.out
    assert "Traceback" not in printed.err
    if arguments:
        assert printed.err.count("\n") == 1 and printed.err.strip().endswith((".", "--help."))
    assert not Path("nowhere").exists() and not Path("out").exists()


def test_a_pipe_that_closes_early_is_no_error(tmp_path: Path) -> None:
    done = sightline("--version", cwd=tmp_path)
    assert done.returncode == 0 and done.stdout.startswith("sightline")


def test_what_nobody_expected_is_one_sentence_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from sightline.commands import verify

    def break_down(*_: object) -> dict[str, object]:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr(verify, "check", break_down)
    assert main(["verify", "x"]) == 1
    said = capsys.readouterr().err
    assert "ZeroDivisionError" in said and "SIGHTLINE_DEBUG" in said and said.count("\n") == 1
