"""`sightline import`: videos into a survey of a running Sightline, without a browser."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sightline.commands.options import (
    FILE,
    json_option,
    progress_told,
    settings_of,
    survey_option,
    tell,
    token_option,
)
from sightline.errors import Away, BadInput, Busy, TooMany
from sightline.media.store.local import sha256_of
from sightline.media.video.endings import VIDEO_ENDINGS

if TYPE_CHECKING:
    from sightline.commands.remote import Remote

_POLL_S = 0.5
Tell = Callable[[float, str], None]


@click.command("import")
@click.argument("videos", nargs=-1, type=FILE)
@survey_option
@click.option("--server", help="Address of the running Sightline (default: this machine).")
@token_option("read and upload")
@click.option(
    "--watch", "folder", type=FILE, help="Import the files in this folder and all new ones, until stopped."
)
@click.option(
    "--settle",
    "settle_s",
    type=click.FloatRange(0.1, 3600),
    default=10.0,
    show_default=True,
    help="Time for which a file must not grow before it is imported, seconds.",
)
@json_option
def import_command(
    videos: tuple[Path, ...],
    survey: str,
    server: str | None,
    token: str | None,
    folder: Path | None,
    settle_s: float,
    as_json: bool,
) -> None:
    """Upload VIDEOS into a survey, import them and find their passes.

    An interrupted upload is resumed; a video that is already there is not sent again.
    """
    from sightline.commands.remote import Remote

    if bool(videos) == bool(folder):
        raise BadInput("import-videos-or-folder")
    if not token:
        raise BadInput("import-no-token")
    with Remote(server or _own_address(), token) as remote:
        survey_id = remote.survey_id(survey)
        if folder is not None:
            _watch(remote, survey_id, folder, settle_s, progress_told())
        else:
            _import_all(remote, survey_id, videos, settle_s, as_json)


def _import_all(
    remote: Remote, survey_id: int, videos: tuple[Path, ...], settle_s: float, as_json: bool
) -> None:
    for video in videos:
        _require_video(video)
    found = [_import(remote, survey_id, video, settle_s, progress_told()) for video in videos]
    tell(as_json, {"recordings": found}, *map(_sentence, found))


def _own_address() -> str:
    settings = settings_of()
    return f"http://{settings.host}:{settings.port}"


def _require_video(video: Path) -> None:
    if not video.is_file():
        raise BadInput("import-no-such-file", name=str(video))
    if video.suffix.lower() not in VIDEO_ENDINGS:
        raise BadInput("import-not-a-video", name=video.name, suffixes=", ".join(sorted(VIDEO_ENDINGS)))
    if video.stat().st_size == 0:
        raise BadInput("import-empty-file", name=video.name)


def _import(remote: Remote, survey_id: int, video: Path, settle_s: float, tell: Tell) -> dict[str, Any]:
    """One video, up to its passes; what became of it."""
    _await_still(video, settle_s, tell)
    sha256 = sha256_of(video)
    recordings = remote.ask(f"/surveys/{survey_id}/recordings")
    there = next((one for one in recordings if one["sha256"] == sha256), None)
    if there is None:
        size = video.stat().st_size
        recording_id = remote.upload(
            survey_id, video, lambda sent: tell(0.5 * sent / size, f"{video.name}: uploading")
        )
        assert recording_id is not None  # a video becomes a recording
        if remote.ask(f"/recordings/{recording_id}")["sha256"] != sha256:
            raise BadInput("import-changed-meanwhile", name=video.name)
    else:
        recording_id = int(there["id"])
    recording = _await_read(remote, recording_id, video.name, tell)
    passes = _await_passes(remote, survey_id, recording_id, video.name, tell)
    tell(1.0, f"{video.name}: done")
    return {
        "file": str(video),
        "recording_id": recording_id,
        "sent": there is None,
        "frames": recording["frame_count"],
        "duration_s": recording["duration_s"],
        "vehicles": passes,
    }


def _sentence(recording: dict[str, Any]) -> str:
    what = "imported" if recording["sent"] else "there already"
    name = Path(recording["file"]).name
    counted = f"{recording['frames']} frames, {recording['vehicles']} vehicles"
    return f"{name}: {what} as recording {recording['recording_id']}, {counted}."


def _await_read(remote: Remote, recording_id: int, name: str, tell: Tell) -> dict[str, Any]:
    """Raises BadInput with the reader's reason where the file cannot be used."""
    while True:
        recording: dict[str, Any] = remote.ask(f"/recordings/{recording_id}")
        if recording["state"] == "ready":
            return recording
        if recording["state"] == "failed":
            raise BadInput("import-cannot-be-read", name=name, reason=_reason_of(recording, ""))
        job = recording["job"]
        tell(0.5 + 0.25 * (job["progress"] if job else 0.0), f"{name}: reading its frames")
        time.sleep(_POLL_S)


def _await_passes(remote: Remote, survey_id: int, recording_id: int, name: str, tell: Tell) -> int:
    """How many vehicles the recording has, once its passes were looked for (asked for, where nobody did)."""
    jobs = remote.ask(f"/jobs?survey_id={survey_id}")
    of_it = (one for one in jobs if (one["kind"], one["recording_id"]) == ("passes", recording_id))
    job = next(of_it, None)
    if job is None:
        job = remote.write(f"/recordings/{recording_id}/find-passes")
    while job["state"] in ("queued", "running"):
        tell(0.75 + 0.25 * job["progress"], f"{name}: finding passes")
        time.sleep(_POLL_S)
        job = remote.ask(f"/jobs/{job['id']}")
    if job["state"] != "done":
        raise BadInput("import-passes-not-found", name=name, reason=_reason_of(job, job["state"]))
    return len(remote.ask(f"/surveys/{survey_id}/vehicles?recording_id={recording_id}"))


def _reason_of(failed: dict[str, Any], otherwise: str) -> str:
    """Why a job or a recording failed, to stand within a sentence."""
    error = failed["error"]
    return str(error["message"] if error else otherwise).rstrip(".")


State = tuple[int, int]


def _state(video: Path) -> State:
    found = video.stat()
    return found.st_size, found.st_mtime_ns


def _await_still(video: Path, settle_s: float, tell: Tell) -> None:
    """Return when the file has not changed for so long: something may still be writing it."""
    while _grows(video, settle_s):
        tell(0.0, f"{video.name}: waits until it stops growing")
        before = _state(video)
        time.sleep(settle_s)
        # By what was seen, not by the clock alone: that of a network drive may be ahead.
        if _state(video) == before:
            return


def _watch(remote: Remote, survey_id: int, folder: Path, settle_s: float, tell: Tell) -> None:
    """Import what comes, one after the other; what was refused is tried again when it changes.

    Where the server is away the file waits; a token or survey that is no good ends it.
    """
    if not folder.is_dir():
        raise BadInput("import-no-such-folder", name=str(folder))
    click.echo(f"Watching {folder}; Ctrl+C stops.", err=True)
    previous: dict[Path, State] = {}
    done: dict[Path, State] = {}
    while True:
        now = dict(_videos_in(folder))
        for video in [one for one in sorted(now) if done.get(one) != now[one]]:
            if now[video] != previous.get(video) or _grows(video, settle_s):
                continue
            try:
                click.echo(_sentence(_import(remote, survey_id, video, settle_s, tell)))
            except (Away, Busy, TooMany, FileNotFoundError) as error:
                click.echo(f"{video.name}: {error}", err=True)
                continue
            except BadInput as error:
                click.echo(error.message, err=True)
            done[video] = now[video]
        previous = now
        time.sleep(min(settle_s, 2.0))


def _videos_in(folder: Path) -> Iterator[tuple[Path, State]]:
    for path in folder.iterdir():
        if path.suffix.lower() in VIDEO_ENDINGS and path.is_file() and path.stat().st_size > 0:
            yield path, _state(path)


def _grows(video: Path, settle_s: float) -> bool:
    """Whether it was written within the last seconds."""
    return time.time() - video.stat().st_mtime < settle_s
