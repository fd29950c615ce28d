"""The survey of a running Sightline, to which a stream is written over HTTP."""

from collections.abc import Collection, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from typing import Any
from urllib.parse import urlencode

from sightline.commands.remote import Remote
from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.linescan.parts import Motion, Rig
from sightline.messages.said import Said
from sightline.scans.live.keeping import SpooledStrip
from sightline.scans.live.records import LiveHealth, LiveSegment, SegmentFacts
from sightline.scans.vehicles.motion import measured_of

#: Asked for before a stream has begun: whether its answer may be known.
_NONE = SegmentFacts(0, "none", "none", datetime(2000, 1, 1, tzinfo=UTC))


class RemoteSink:
    """What `keeping.Sink` asks for, as one token may do it.

    Raises NotSignedIn, NotAllowed, NotFound where it may not.
    """

    def __init__(self, remote: Remote, survey_id: int, rig: Rig, method: ScanMethod) -> None:
        self._remote, self._survey_id, self._rig, self._method = remote, survey_id, asdict(rig), method
        self.segments(_NONE)
        remote.require_upload(survey_id)

    def segments(self, segment: SegmentFacts) -> Sequence[LiveSegment]:
        of = urlencode({"stream": segment.stream, "began_at": segment.began_at.isoformat()})
        asked = self._remote.ask(f"/surveys/{self._survey_id}/live/segments?{of}")
        return [LiveSegment(**one) for one in asked]

    def begin(self, segment: SegmentFacts, others: Collection[int]) -> int:
        facts = {"stream": segment.stream, "source": segment.source, "others": list(others)}
        body = {**facts, "number": segment.number, "began_at": segment.began_at.isoformat()}
        return int(self._remote.write(f"/surveys/{self._survey_id}/live", {**body, "rig": self._rig})["id"])

    def add(self, scan_id: int, motions: Sequence[Motion], health: LiveHealth | None) -> None:
        vehicles = [measured_of(one) for one in motions]
        body = {"rig": self._rig, "vehicles": vehicles, "health": None if health is None else asdict(health)}
        self._remote.write(f"/scans/{scan_id}/live", body)

    def end(self, scan_id: int, strips: Sequence[SpooledStrip], notes: Sequence[Said], told: int) -> None:
        if self._remote.ask(f"/scans/{scan_id}")["state"] != "live":
            return  # stored by one that was killed before it had said so
        body: dict[str, Any] = {"rig": self._rig, "method": self._method, "told": told, "notes": list(notes)}
        for word, one in zip(("first", "second"), strips, strict=False):
            body[f"{word}_upload"] = self._upload(one)
        self._remote.write(f"/scans/{scan_id}/live/end", body)

    def let_go(self, strips: Sequence[SpooledStrip]) -> None:
        for strip in strips:
            if (arrived := self._arrived(strip)) is not None:
                self._remote.give_up(f"/uploads/{arrived}")
            if (begun := self._remote.begun(self._survey_id, strip.path, "strip")) is not None:
                self._remote.give_up(begun)

    def _upload(self, strip: SpooledStrip) -> int:
        """The number of a strip's upload, sent unless it is there."""
        if (there := self._arrived(strip)) is None:
            self._remote.upload(self._survey_id, strip.path, purpose="strip")
            there = self._arrived(strip)
        if there is None:
            raise BadInput("stream-strip-changed", name=strip.path)
        return there

    def _arrived(self, strip: SpooledStrip) -> int | None:
        """The number of an upload of its content that waits for its recording."""
        waiting = self._remote.ask(f"/surveys/{self._survey_id}/strip-uploads")
        return next((int(one["id"]) for one in waiting if one["sha256"] == strip.sha256), None)
