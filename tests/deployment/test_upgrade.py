"""What earlier releases stored is taken over by this program: migrated, verified, nothing lost."""

import re
from pathlib import Path

import pytest

from sightline.infra.audit.verification import verify_database
from sightline.infra.backup.make import make_backup
from sightline.infra.backup.manifest import read_manifest
from sightline.infra.backup.restore import restore_backup
from sightline.infra.database.engine import make_engine
from sightline.infra.database.revisions import newest_revision, stored_revision
from sightline.infra.services import Services
from sightline.settings import Settings
from tests.conftest import SERVER
from tests.infra.test_backup import NewPlace, new_place
from tests.support import samples

pytestmark = pytest.mark.dialect

assert new_place  # the fixture
HERE = Path(__file__).parent / "released"
ROOT = Path(__file__).resolve().parents[2]
KIND = "postgresql" if SERVER else "sqlite"
STORED = sorted(path for path in HERE.iterdir() if path.name.endswith(f"-{KIND}"))


def upgraded(folder: Path, place: Settings) -> None:
    """Restore what a release backed up and hold it against what the release said of it."""
    manifest = read_manifest(folder)
    found = restore_backup(folder, place, lambda _share, _words: None)
    assert found.audit is not None and found.audit.ok
    assert found.audit.checked == sum(count for count, _ in manifest.heads.values())
    engine = make_engine(place.database_url)
    with engine.connect() as connection:
        assert stored_revision(connection) == newest_revision()
    engine.dispose()
    assert verify_database(place.database_url).ok


@pytest.mark.parametrize("folder", STORED, ids=lambda path: path.name)
def test_a_released_database_is_upgraded(folder: Path, new_place: NewPlace) -> None:
    upgraded(folder, new_place("upgraded"))


def test_the_present_one_would_be(services: Services, tmp_path: Path, new_place: NewPlace) -> None:
    """The way itself, while nothing is released."""
    with services.writing() as session:
        samples.measure(session, samples.sample(session))
    make_backup(services, tmp_path / "backup", lambda _share, _words: None)
    upgraded(tmp_path / "backup", new_place("upgraded"))


@pytest.mark.once
def test_every_release_left_a_database() -> None:
    headings = re.findall(r"^## (\d+\.\d+\.\d+)(.*)$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    released = [version for version, more in headings if "unreleased" not in more]
    wanted = {f"{version}-{kind}" for version in released for kind in ("sqlite", "postgresql")}
    assert wanted <= {path.name for path in HERE.iterdir()}
