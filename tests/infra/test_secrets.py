"""What a start refuses: secrets that can be guessed or were printed, signing keys that are none."""

from pathlib import Path

import pytest
from pydantic import SecretStr

from sightline.errors import BadInput, Damaged
from sightline.infra.web.secret import require_secrets
from sightline.settings import Settings

pytestmark = pytest.mark.once

GOOD, KEY = SecretStr("x9" * 16), SecretStr("ab" * 32)
AGENCY = "postgresql+psycopg://sightline@database/sightline"


@pytest.mark.parametrize("secret", ["x", "x" * 31, "at-least-32-random-characters-go-here"])
def test_a_secret_that_can_be_guessed_is_refused(tmp_path: Path, secret: str) -> None:
    with pytest.raises(BadInput, match="can be guessed; use at least 32 random characters"):
        require_secrets(Settings(data_dir=tmp_path, secret=SecretStr(secret)))


def test_what_is_good_is_taken(tmp_path: Path) -> None:
    require_secrets(Settings(data_dir=tmp_path))  # the data folder keeps its own
    require_secrets(Settings(data_dir=tmp_path, secret=GOOD, signing_key=KEY, database_url=AGENCY))


def test_a_signing_key_that_is_none_is_told_at_the_start(tmp_path: Path) -> None:
    with pytest.raises(Damaged, match="SIGHTLINE_SIGNING_KEY"):
        require_secrets(Settings(data_dir=tmp_path, signing_key=SecretStr("abc")))


@pytest.mark.parametrize("address", [AGENCY, "postgres://sightline@database/sightline"])
def test_several_machines_need_one_signing_key(tmp_path: Path, address: str) -> None:
    with pytest.raises(BadInput, match="each machine would sign with a key of its own"):
        require_secrets(Settings(data_dir=tmp_path, secret=GOOD, database_url=address))
