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
from sqlalchemy import make_url

from sightline.settings import Settings

pytestmark = pytest.mark.once

SERVING = ("app", "second-app", "worker")
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
    for service in (*SERVING, "migrate"):
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
    assert {*SERVING, "migrate", "database", "storage", "proxy"} <= set(compose["services"])
    example = {line.split("=")[0] for line in example_lines()}
    text = (ROOT / "docker-compose.yml").read_text()
    for secret in (
        "POSTGRES_PASSWORD",
        "SERVING_PASSWORD",
        "S3_ACCESS_KEY",
        "S3_SECRET_KEY",
        "SIGHTLINE_SECRET",
    ):
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
    for service, secret in {**dict.fromkeys(SERVING, "SERVING"), "migrate": "POSTGRES"}.items():
        environment = compose["services"][service]["environment"]
        assert "PASSWORD" not in environment["SIGHTLINE_DATABASE_URL"]
        assert environment["PGPASSWORD"].startswith(f"${{{secret}_PASSWORD:?")


def test_who_serves_is_not_who_owns(compose: dict[str, Any]) -> None:
    services = compose["services"]
    owner, role = services["database"]["environment"]["POSTGRES_USER"], "serving"
    migrating = services["migrate"]["environment"]
    assert make_url(migrating["SIGHTLINE_DATABASE_URL"]).username == owner
    assert migrating["SIGHTLINE_SERVING_ROLE"] == role != owner
    for service in SERVING:
        environment = services[service]["environment"]
        assert make_url(environment["SIGHTLINE_DATABASE_URL"]).username == role
        assert not {name for name in environment if name.startswith("SIGHTLINE_SERVING_")}
        waits = services[service]["depends_on"]["migrate"]
        assert waits == {"condition": "service_completed_successfully"}


def test_settings_that_must_be_equal_are(compose: dict[str, Any]) -> None:
    """What a start would refuse: see infra/installation.py."""
    apps = [compose["services"][name] for name in SERVING]
    for name in ("SIGHTLINE_SECRET", "SIGHTLINE_SIGNING_KEY", "SIGHTLINE_MEDIA_URL"):
        assert len({one["environment"][name] for one in apps}) == 1
    assert len({tuple(one["volumes"]) for one in apps}) == 1


def test_the_proxy_asks_every_app(compose: dict[str, Any]) -> None:
    (asked, otherwise) = re.findall(
        r"reverse_proxy {\$SIGHTLINE_APPS:([^}]+)}", (ROOT / "Caddyfile").read_text()
    )
    assert asked == otherwise == "app:8000 second-app:8000"
    assert [mount.split(":")[0] for mount in compose["services"]["proxy"]["volumes"]] == [
        "./Caddyfile",
        "proxy",
    ]


def test_every_part_has_limits_and_says_how_it_is(compose: dict[str, Any]) -> None:
    for name, one in compose["services"].items():
        assert one["init"] is True and one["logging"]["options"]["max-size"], name
        assert name == "migrate" or one["mem_limit"], name
    for name in ("worker", "database", "storage"):  # the apps' is the image's
        assert compose["services"][name]["healthcheck"]["test"]


def test_the_image_is_told_its_version_without_an_environment_of_the_host(tmp_path: Path) -> None:
    docker = tmp_path / "docker"
    docker.write_text('#!/bin/sh\necho "$SIGHTLINE_VERSION $*"\n')
    docker.chmod(0o755)
    path = f"{tmp_path}:{os.environ['PATH']}"
    told = subprocess.run(
        ["make", "-s", "image", "BIN=/nowhere"],
        cwd=ROOT,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    commit = subprocess.run(
        ["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout
    assert re.fullmatch(rf"\d+\.\d+\.\d+\+g{commit[:12]}(\.dirty)? compose build\n", told)


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
