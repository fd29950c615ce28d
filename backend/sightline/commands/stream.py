"""The command stream (docs/formats.md): vehicles from live lines of both cameras, while they pass."""

import math
import signal
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from sightline.commands.options import (
    data_dir_option,
    json_text,
    opened_services,
    refuse_ignored,
    token_option,
)
from sightline.commands.scanned import left_out, object_of, rig_options
from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.infra.file_lock import take_lock
from sightline.linescan.parts import Rig
from sightline.media.lines.source import Ending, LineSource
from sightline.media.strips.reader import LEAST_ROWS, MOST_ROWS
from sightline.messages.said import Said
from sightline.scans.live.records import STANDARD_INPUT, Keeper, LiveVehicle
from sightline.scans.live.run import LiveRun


@click.command()
@click.option("--rows", type=click.IntRange(LEAST_ROWS, MOST_ROWS), required=True, help="Pixels per line.")
@rig_options
@click.option(
    "--follow",
    type=click.Path(dir_okay=False, path_type=Path),
    help=(
        "Read a growing file instead of standard input; its last line was taken when the file was last "
        "modified, so a copy must keep that time."
    ),
)
@click.option(
    "--until-idle",
    type=click.FloatRange(min=0.1),
    help="End when the file of --follow has not grown for this time, seconds.",
)
@click.option(
    "--camera",
    "cameras",
    multiple=True,
    help=(
        "GigE Vision camera (name, serial number or address); give it twice, first the "
        "one that vehicles reach first."
    ),
)
@click.option(
    "--frame-lines",
    type=click.IntRange(1, 65_536),
    default=256,
    show_default=True,
    help="Lines per frame of a GigE Vision camera.",
)
@click.option(
    "--spool",
    type=click.Path(file_okay=False, path_type=Path),
    help=("Folder in which to keep the lines (BigTIFF); an interrupted stream is resumed from there."),
)
@click.option("--survey", help="Name (or number) of a survey in which to store the vehicles too.")
@click.option("--server", help="Address of the running Sightline that has the survey (default: --data-dir).")
@token_option("read, upload and measure")
@click.option(
    "--segment-minutes",
    type=click.FloatRange(min=0.02, max=24 * 60),
    default=60.0,
    show_default=True,
    help="Duration of one pair of files, and of one line-scan recording in the survey.",
)
@data_dir_option
def stream(
    rows: int,
    rig: Rig,
    method: ScanMethod,
    follow: Path | None,
    until_idle: float | None,
    cameras: tuple[str, ...],
    frame_lines: int,
    spool: Path | None,
    survey: str | None,
    server: str | None,
    token: str | None,
    segment_minutes: float,
    data_dir: Path | None,
) -> None:
    """Measure vehicles from live lines; prints one JSON object per vehicle as soon as it is measured.

    Input is 8-bit line pairs without headers: --rows bytes of camera 1 (top pixel first), the same number of
    camera 2, and so on, on standard input or in a growing file; or two GigE Vision cameras. At the end of the
    input, or on Ctrl+C, complete vehicles are measured. With --spool the lines are kept in pairs of files
    that `sightline linescan --time-axis height` can read, and the same command resumes an interrupted stream.
    With --survey the vehicles appear on the Live page of the survey, also of a Sightline on another machine
    (--server, with --spool).
    """
    if cameras and (len(cameras) != 2 or follow or cameras[0] == cameras[1]):
        raise BadInput("commands-stream-two-cameras")
    if until_idle is not None and follow is None:
        raise BadInput("commands-idle-without-follow")
    name = ", ".join(cameras) or (str(follow.absolute()) if follow else STANDARD_INPUT)
    if server is None:
        kept = _in_database(survey, data_dir, rig, method, spool)
    else:
        kept = _on_server(survey, server, token, rig, method, spool)
    with until_told() as ending, kept as (keeper, folder):

        def source(begin: int) -> LineSource:
            return _source(ending, rows, rig.line_rate_hz, begin, follow, until_idle, cameras, frame_lines)

        run = LiveRun(
            source,
            rows,
            rig,
            method,
            folder=folder,
            keeper=keeper,
            say=_say,
            name=name,
            can_go_back=follow is not None,
            segment_s=60 * segment_minutes if folder else math.inf,
        )
        for vehicle in run.vehicles():
            click.echo(json_text(said_of(vehicle, rig.line_rate_hz)))
            sys.stdout.flush()
            run.told(vehicle)
    if not run.lines and not run.broken:
        raise BadInput("commands-stream-empty", pair_bytes=2 * rows)
    for sentence in left_out(rig, run.found):
        _say(sentence)
    if run.broken:
        sys.exit(1)


def said_of(live_vehicle: LiveVehicle, line_rate_hz: float) -> dict[str, Any]:
    """A vehicle as it is printed: as `linescan` has it, then where its lines are and when it came.

    Lines are those of its segment's files; `front_s` and `rear_s` count from the beginning of the stream.
    """
    begun_s = live_vehicle.begin / line_rate_hz
    rear_s = None if live_vehicle.vehicle.rear_s is None else live_vehicle.vehicle.rear_s + begun_s
    vehicle = replace(live_vehicle.vehicle, front_s=live_vehicle.vehicle.front_s + begun_s, rear_s=rear_s)
    return {**object_of(vehicle), "segment": live_vehicle.segment, "front_at": live_vehicle.at.isoformat()}


@contextmanager
def until_told() -> Iterator[Ending]:
    """Ctrl+C and a service's stop end the input, never what is being measured."""
    ending = Ending()
    pipe_before = signal.set_wakeup_fd(ending.tell_fd)
    before = {one: signal.signal(one, lambda *_: None) for one in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield ending
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
        signal.set_wakeup_fd(pipe_before)
        ending.close()


def _source(
    ending: Ending,
    rows: int,
    line_rate: float,
    begin: int,
    follow: Path | None,
    until_idle: float | None,
    cameras: tuple[str, ...],
    frame_lines: int,
) -> LineSource:
    if cameras:
        from sightline.media.lines.gige import GigeLines

        return GigeLines(cameras[0], cameras[1], rows, line_rate, ending, frame_lines)
    if follow:
        from sightline.media.lines.followed import FollowedLines

        return FollowedLines(follow, rows, ending, begin=begin, idle_s=until_idle)
    from sightline.media.lines.piped import PipedLines

    return PipedLines(sys.stdin.fileno(), rows, ending)


@contextmanager
def _in_database(
    survey: str | None, data_dir: Path | None, rig: Rig, method: ScanMethod, spool: Path | None
) -> Iterator[tuple[Keeper, Path | None]]:
    """Where vehicles go besides standard output, and the folder for the lines, made for this stream alone."""
    if survey is None:
        with _taken(spool):
            yield Keeper(), spool
        return
    from sightline.export.export_job import find_survey
    from sightline.scans.live.keeping import DatabaseSink, SurveyKeeper

    with opened_services(data_dir) as services:
        with services.reading() as session:
            survey_id = find_survey(session, survey).id
        spool = spool or services.settings.data_dir / "live" / f"survey-{survey_id}"
        sink = DatabaseSink(services, survey_id, rig, method)
        with _taken(spool), closing(SurveyKeeper(sink, _say)) as keeper:
            yield keeper, spool


@contextmanager
def _on_server(
    survey: str | None, server: str, token: str | None, rig: Rig, method: ScanMethod, spool: Path | None
) -> Iterator[tuple[Keeper, Path | None]]:
    """The same where the survey is another machine's: asked for it before any line is read."""
    from sightline.commands.remote import Remote
    from sightline.commands.remote_sink import RemoteSink
    from sightline.scans.live.keeping import SurveyKeeper

    refuse_ignored(("data_dir",), "--server")
    if survey is None or spool is None:
        raise BadInput("commands-stream-server-needs")
    if not token:
        raise BadInput("commands-stream-no-token")
    with Remote(server, token) as remote:
        sink = RemoteSink(remote, remote.survey_id(survey), rig, method)
        with _taken(spool), closing(SurveyKeeper(sink, _say)) as keeper:
            yield keeper, spool


@contextmanager
def _taken(spool: Path | None) -> Iterator[None]:
    """The folder is there, and no other stream writes into it."""
    if spool is None:
        yield
        return
    try:
        lock = take_lock(spool / ".lock")
    except OSError as error:
        raise BadInput("commands-not-writable", path=spool, strerror=error.strerror) from None
    if lock is None:
        raise BadInput("commands-stream-spool-taken", path=spool)
    with lock:
        yield


def _say(one: Said | str) -> None:
    click.echo(str(one), err=True)
