"""docker-compose.yml against the Compose specification, and against the settings the code really reads."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from sightline.settings import Settings

pytestmark = pytest.mark.once

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def compose() -> dict[str, Any]:
    loaded: dict[str, Any] = yaml.safe_load((ROOT / "docker-compose.yml").read_text())
    return loaded


def test_follows_the_compose_specification() -> None:
    command = [sys.executable, "-m", "check_jsonschema", "--builtin-schema", "vendor.compose-spec"]
    done = subprocess.run(
        [*command, str(ROOT / "docker-compose.yml")], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_sightline_variable_is_a_setting(compose: dict[str, Any]) -> None:
    known = {f"SIGHTLINE_{name.upper()}" for name in Settings.model_fields}
    for service in ("app", "worker"):
        named = {n for n in compose["services"][service]["environment"] if n.startswith("SIGHTLINE_")}
        assert named
        assert named <= known, named - known


def example_lines() -> list[str]:
    return [
        line
        for line in (ROOT / ".env.example").read_text().splitlines()
        if "=" in line and not line.startswith("#")
    ]


def test_has_all_parts_and_every_secret_must_be_given(compose: dict[str, Any]) -> None:
    assert {"app", "worker", "database", "storage", "proxy"} <= set(compose["services"])
    example = {line.split("=")[0] for line in example_lines()}
    text = (ROOT / "docker-compose.yml").read_text()
    for secret in ("POSTGRES_PASSWORD", "S3_ACCESS_KEY", "S3_SECRET_KEY", "SIGHTLINE_SECRET"):
        assert f"${{{secret}:?" in text
        assert secret in example
    given = dict(line.split("=", 1) for line in example_lines())
    assert {name for name, value in given.items() if value} == {"SIGHTLINE_SITE", "S3_ACCESS_KEY"}


@pytest.mark.parametrize("secret", ["plain", "p@ss%41", 'a"b\\c\\"', "it's", "$HOME `id` %s"])
def test_secrets_of_any_signs_reach_the_storage(compose: dict[str, Any], secret: str, tmp_path: Path) -> None:
    """Its own command, as Compose hands it to the shell, but for the program that it starts."""
    (script,) = compose["services"]["storage"]["command"]
    written = tmp_path / "s3.json"
    script = script.replace("$$", "$").replace("/tmp/s3.json", str(written)).replace("exec weed", ": weed")
    keys = {"S3_ACCESS_KEY": "sightline", "S3_SECRET_KEY": secret, "PATH": os.environ["PATH"]}
    subprocess.run(["/bin/sh", "-c", script], check=True, env=keys)
    (identity,) = json.loads(written.read_text())["identities"]
    assert identity["credentials"] == [{"accessKey": "sightline", "secretKey": secret}]


def test_the_password_stands_beside_the_address(compose: dict[str, Any]) -> None:
    for service in ("app", "worker"):
        environment = compose["services"][service]["environment"]
        assert "PASSWORD" not in environment["SIGHTLINE_DATABASE_URL"]
        assert environment["PGPASSWORD"].startswith("${POSTGRES_PASSWORD:?")


def test_the_image_is_built_from_files_that_exist() -> None:
    for line in (ROOT / "Dockerfile").read_text().splitlines():
        if line.startswith("COPY") and "--from" not in line:
            for source in line.split()[1:-1]:
                assert (ROOT / source).exists(), source


def test_every_image_that_is_not_built_here_is_pinned_by_digest(compose: dict[str, Any]) -> None:
    from_others = [one["image"] for one in compose["services"].values() if "build" not in one]
    built_on = [
        line.split()[1] for line in (ROOT / "Dockerfile").read_text().splitlines() if line.startswith("FROM ")
    ]
    assert len(from_others) == 3 and len(built_on) == 2
    for image in (*from_others, *built_on):
        assert re.fullmatch(r"[\w./-]+:[\w.-]+@sha256:[0-9a-f]{64}", image), image
