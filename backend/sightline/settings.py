"""What the environment says: every variable begins with SIGHTLINE_. Nothing happens on import."""

from pathlib import Path
from typing import Any

from pydantic import Field, SecretStr
from pydantic_settings import BaseSettings, SettingsConfigDict

from sightline.enums import LogFormat


def default_data_dir() -> Path:
    """`.data` at the root of the checkout, or in the current folder where the package is installed."""
    return (_checkout() or Path.cwd()) / ".data"


def default_frontend_dir() -> Path:
    """Where the built front end is: `frontend/dist` of the checkout, or what a wheel holds."""
    checkout = _checkout()
    return checkout / "frontend" / "dist" if checkout else Path(__file__).with_name("_pages")


class Settings(BaseSettings):
    """Read once when a command starts and handed down; fields given by name win over the environment."""

    model_config = SettingsConfigDict(env_prefix="SIGHTLINE_", env_ignore_empty=True, frozen=True)

    data_dir: Path = Field(default_factory=default_data_dir)
    host: str = "127.0.0.1"
    port: int = Field(default=8000, ge=0, le=65535)
    #: a SQLite file in the data folder, unless named
    database_url: str = Field(default_factory=lambda data: sqlite_url(_absolute(data) / "sightline.db"))
    #: a folder in the data folder, unless named
    media_url: str = Field(default_factory=lambda data: str(_absolute(data) / "media"))
    #: where uploads are gathered: one folder of all app processes, so that any of them goes on; in the data
    #: folder, unless named
    uploads_dir: Path = Field(default_factory=lambda data: _absolute(data) / "uploads")
    #: the PostgreSQL role that serves and owns nothing: `sightline migrate` by the owner gives it its rights
    serving_role: str = ""
    #: with it `sightline migrate` makes that role, or gives it this password
    serving_password: SecretStr | None = None
    frontend_dir: Path = Field(default_factory=default_frontend_dir)
    #: where people find it, as https://heights.example.org: printed in front of sign-in links
    address: str = ""
    #: signs the session cookies; without it the data folder keeps one of its own
    secret: SecretStr | None = None
    #: signs audit checkpoints (64 hexadecimal digits), where several machines share it; without it the data
    #: folder keeps one of its own
    signing_key: SecretStr | None = None
    secure_cookies: bool = False
    #: addresses or networks of the proxies in front, with commas ("*": whoever reaches the port): only what
    #: they say of a caller's address and of https is believed
    proxies: str = ""
    #: jobs done side by side by the processes that `serve` starts (0: it starts none) or `sightline worker`;
    #: one process more takes short jobs alone, so that they never wait behind long ones
    workers: int = Field(default=2, ge=0, le=64)
    #: on PostgreSQL: how long a worker process may be silent before its job is given to another one
    heartbeat_limit_s: float = Field(default=5.0, ge=0.5, le=600)
    #: Prometheus reads on this port of its own, on `host`; 0: nothing listens
    metrics_port: int = Field(default=0, ge=0, le=65535)
    #: lines for people, or JSON with a line for each request
    log_format: LogFormat = "plain"
    #: whether the passes of an upload are looked for as soon as it was read; else a person asks for it
    find_passes: bool = True


def load_settings(**overrides: Any) -> Settings:
    """The settings of this environment with some fields given; None leaves a field to the environment.

    Raises pydantic.ValidationError, which names the variable that cannot be used.
    """
    return Settings(**{name: value for name, value in overrides.items() if value is not None})


def sqlite_url(path: Path) -> str:
    """The address of a SQLite file of any name: `?` and `%` mean something else in an address."""
    from sqlalchemy import URL

    return URL.create("sqlite", database=str(path)).render_as_string(hide_password=False)


def _checkout() -> Path | None:
    root = Path(__file__).resolve().parents[2]
    return root if (root / "pyproject.toml").is_file() else None


def _absolute(data: dict[str, Any]) -> Path:
    return Path(data["data_dir"]).absolute()
