"""What the environment says: every variable begins with SIGHTLINE_. Nothing happens on import."""

import os
import secrets
from functools import cached_property
from pathlib import Path

from pydantic import Field, SecretStr
from pydantic_settings import BaseSettings, SettingsConfigDict


class Settings(BaseSettings):
    """Read once when a command starts and handed down; give fields by name to override the environment."""

    model_config = SettingsConfigDict(env_prefix="SIGHTLINE_", env_ignore_empty=True, frozen=True)

    data_dir: Path = Field(default_factory=lambda: default_data_dir())
    host: str = "127.0.0.1"
    port: int = Field(default=8000, ge=0, le=65535)
    database_url: str = ""
    media_url: str = ""
    secret: SecretStr | None = None
    secure_cookies: bool = False
    workers: int = Field(default=1, ge=0, le=64)
    lease_s: float = Field(default=5.0, gt=0.5, le=600)

    @property
    def database(self) -> str:
        """The database's URL: SIGHTLINE_DATABASE_URL, else a file in the data folder."""
        return self.database_url or f"sqlite:///{self.data_dir / 'sightline.db'}"

    @property
    def media(self) -> str:
        """Where media are kept: SIGHTLINE_MEDIA_URL, else a folder in the data folder."""
        return self.media_url or str(self.data_dir / "media")

    @cached_property
    def signing_key(self) -> str:
        """The key that signs sessions: SIGHTLINE_SECRET, else made once and kept in the data folder."""
        if self.secret is not None:
            return self.secret.get_secret_value()
        return _kept_secret(self.data_dir / "secret")


def load_settings(**overrides: object) -> Settings:
    """The settings of this environment with some fields given; pydantic.ValidationError names a bad one."""
    given = {name: value for name, value in overrides.items() if value is not None}
    return Settings(**given)  # type: ignore[arg-type]


def default_data_dir() -> Path:
    """`.data` at the root of the checkout, or in the current folder where the package is installed."""
    root = Path(__file__).resolve().parents[1]
    return (root if (root / "pyproject.toml").is_file() else Path.cwd()) / ".data"


def _kept_secret(path: Path) -> str:
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    except FileExistsError:
        kept = path.read_text(encoding="ascii").strip()
        return kept if len(kept) >= 32 else _new_secret(path)
    with os.fdopen(handle, "w", encoding="ascii") as file:
        key = secrets.token_urlsafe(48)
        file.write(key)
    return key


def _new_secret(path: Path) -> str:
    """Replace a key that was cut short (a full disk, a crash between making and writing)."""
    key = secrets.token_urlsafe(48)
    half = path.with_suffix(f".{os.getpid()}")
    half.touch(mode=0o600)
    half.write_text(key, encoding="ascii")
    half.replace(path)
    return key
