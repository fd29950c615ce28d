"""What several commands share: the data folder, the settings, and JSON on standard output."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_args

import click
from click.core import ParameterSource

from sightline.enums import FILMED_HZ
from sightline.errors import BadInput
from sightline.messages.said import Said

if TYPE_CHECKING:
    from sightline.infra.services import Services
    from sightline.settings import Settings

Command = TypeVar("Command", bound=Callable[..., Any])
FILE = click.Path(path_type=Path)


def number_option(*names: str, default: float | None = None, **about: Any) -> Callable[[Command], Command]:
    """An option with a number, called as the field of the record that it fills; a default but 0 is shown."""
    if default is not None:
        about |= {"default": default, "show_default": bool(default)}
    return click.option(*names, type=float, **about)


def choice_option(
    *names: str, of: Any, default: str | None = None, **about: Any
) -> Callable[[Command], Command]:
    """An option with one of the words that a type `of` them allows; a default is shown."""
    if default is not None:
        about |= {"default": default, "show_default": True}
    return click.option(*names, type=click.Choice(get_args(of)), **about)


def output_option(what: str, *, required: bool = True) -> Callable[[Command], Command]:
    """`-o`: the file or folder to write."""
    return click.option("-o", "--output", type=FILE, required=required, help=what)


#: `--survey`: which survey of the installation.
survey_option = click.option("--survey", required=True, help="Name (or number) of the survey.")
#: `--data-dir`: where database, media and caches are.
data_dir_option = click.option(
    "--data-dir",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder of the database and the media (SIGHTLINE_DATA_DIR; default .data).",
)


def token_option(scopes: str) -> Callable[[Command], Command]:
    """`--token`: by which a running Sightline knows who asks."""
    about = f"API token with the scopes {scopes} (or SIGHTLINE_TOKEN)."
    return click.option("--token", envvar="SIGHTLINE_TOKEN", help=about)


#: `--json`: one JSON object on standard output.
json_option = click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
#: `--stream`: which of a video's pictures is read.
stream_option = click.option(
    "--stream",
    "stream_number",
    type=click.IntRange(1),
    help="Video track to use, from 1 (default: the first that is not a still image).",
)
#: `--filmed-at`: at what rate a video was filmed, where its times are not those of filming.
filmed_at_option = click.option(
    "--filmed-at",
    "filmed_hz",
    type=click.FloatRange(*FILMED_HZ),
    metavar="RATE",
    help="Filming rate, frames per second, if it differs from the playback rate (slow motion).",
)


def settings_of(**overrides: object) -> Settings:
    """The settings of the environment with the options given. Raises BadInput naming the variable."""
    from pydantic import ValidationError

    from sightline.settings import load_settings

    if isinstance(overrides.get("data_dir"), Path):
        overrides["data_dir"] = Path(str(overrides["data_dir"])).absolute()
    try:
        return load_settings(**overrides)
    except ValidationError as error:
        first = error.errors()[0]
        name = "SIGHTLINE_" + "_".join(str(part) for part in first["loc"]).upper()
        said = str(first["msg"])
        raise BadInput(
            "commands-cannot-used-correct", name=name, said=said[:1].lower(), said_2=said[1:]
        ) from error


def require_database(settings: Settings) -> None:
    """Raise BadInput where the settings name a SQLite file that is not there: reading must not make one."""
    from sightline.infra.database.engine import sqlite_file

    path = sqlite_file(settings.database_url)
    if path is not None and not path.is_file():
        raise BadInput("commands-no-database", path=path)


@contextmanager
def opened_services(data_dir: Path | None) -> Iterator[Services]:
    """The services of an installation that is there, brought up to date; closed in the end."""
    from sightline.infra.database.engine import migrate
    from sightline.infra.services import open_services

    settings = settings_of(data_dir=data_dir)
    require_database(settings)
    services = open_services(settings)
    try:
        migrate(services.engine)
        yield services
    finally:
        services.close()


def refuse_ignored(names: tuple[str, ...], instead: str) -> None:
    """Raise BadInput for an option without effect: no number may rest on other inputs than those given."""
    context = click.get_current_context()
    for option in context.command.params:
        given = context.get_parameter_source(option.name or "") is ParameterSource.COMMANDLINE
        if given and option.name in names:
            name = max(option.opts, key=len).removeprefix("--")
            raise BadInput("commands-option-without-effect", name=name, instead=instead)


def in_words(value: object) -> str:
    """What is said, as a command tells it; for JSON, which has no other form for it."""
    if isinstance(value, Said):
        return str(value)
    raise TypeError(f"{value!r} is no JSON")


def tell(as_json: bool, document: object, *lines: object) -> None:
    """What a command found: one JSON object, or the lines."""
    if as_json:
        print_json(document)
        return
    for line in lines:
        click.echo(line)


def print_json(value: object) -> None:
    """One JSON object, full precision, whole or not at all."""
    click.echo(json_text(value, indent=2))


def json_text(value: object, indent: int | None = None) -> str:
    """JSON as commands print it: a number that is not finite is one that there is not, so null."""
    return json.dumps(_finite(value), indent=indent, ensure_ascii=False, allow_nan=False, default=in_words)


def _finite(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _finite(one) for name, one in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def progress_told() -> Callable[[float, object], None]:
    """Progress on standard error: one line that changes on a terminal, one line a step elsewhere."""
    last = ""

    def tell(fraction: float, words: object) -> None:
        nonlocal last
        line = f"{100 * fraction:3.0f} %  {words}"
        if sys.stderr.isatty():
            end = "\n" if fraction >= 1.0 else ""
            click.echo(f"\r{line:<70}{end}", err=True, nl=False)
        elif str(words) != last:
            click.echo(line, err=True)
        last = str(words)

    return tell
