"""`sightline verify` of an evidence file: signature, hashes, what its chain says, and its numbers made again.

A motion comes from the registration of the two strips, which a file cannot hold whole; so what is made again
is what the stored boundary lines and the rig give. The length follows exactly, and so do the entries of the
budget that the rig brings. Of direct registration, speed and acceleration carry front and rear from camera 1
to camera 2 over the baseline, and what is left over is no more than the budget's front and rear let expect
(`linescan.budget`).
"""

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import hypot, isclose, isfinite
from typing import Any

from sightline.errors import BadInput, Damaged
from sightline.export.evidence.decision import decision_of, rule_of
from sightline.export.evidence.document import FORMAT, derived_parts, values_of_document
from sightline.export.evidence.page import ReadPage, program_of_page, read_page
from sightline.export.evidence.translated import translations_of
from sightline.infra.audit.checkpoints import KEY_PARTS, are_handed_on
from sightline.infra.audit.hashing import chain_hash, to_plain_json
from sightline.infra.audit.records import survey_chain
from sightline.infra.audit.signing import signature_holds
from sightline.infra.csv_package.schema import sha256_hex
from sightline.infra.version import code_version
from sightline.linescan.budget import DISAGREE_OVER_U, u_end_of
from sightline.linescan.either_way import exact_at_camera_1
from sightline.linescan.equations import ExactMotion, travelled_m
from sightline.linescan.parts import Entry
from sightline.linescan.rig import baseline_of, rig_from
from sightline.media.images import image_size
from sightline.messages import say
from sightline.scans.vehicles.motion import crossings_of

_LEAST_OF_KEY = 16
#: Of what is made again from the same numbers; lines of a long recording have eight digits behind the point.
_CLOSE = 1e-8
_MOTION = ("speed_mps", "acceleration_mps2", "length_m")
#: Entries that a rig brings: by which of its ratios speed, acceleration and length answer, and how often.
_BY_RIG = {"baseline": (1, 1, 1), "clock": (1, 2, 0)}

Document = Mapping[str, Any]
#: What a document raises whose parts are not of their kind.
_NOT_OF_KIND = (KeyError, TypeError, ValueError, AttributeError, IndexError, ArithmeticError, BadInput)


@dataclass(frozen=True)
class EvidenceCheck:
    """What was found: `problems`, a sentence each, none where all is well; `lines`: what four lines give."""

    ok: bool
    problem: str | None
    problems: tuple[str, ...]
    notes: tuple[str, ...]
    key: str
    made_at: str
    program: str
    decision: str
    lines: ExactMotion | None


def verify_evidence(content: bytes, key: str | None = None) -> EvidenceCheck:
    """Everything about a file; `key`: (the beginning of) a key of the installation, kept elsewhere.

    Raises BadInput for a key that is too short, Damaged for what is no evidence file at all.
    """
    if key is not None and len(key) < _LEAST_OF_KEY:
        raise BadInput("export-key-too-short", least=_LEAST_OF_KEY)
    page = read_page(content)
    if page.document.get("format") != FORMAT:
        raise Damaged("evidence-not-one")
    document, decided = page.document, _decide_again(page)
    problems = []
    for part, check in _CHECKS.items():
        problems += _guarded(part, check, page)
    problems += [*_guarded("decision", _decision, page, decided), *_guarded("said", _translations, page)]
    if key is not None and not _is_known(document, key):
        problems.append(say("evidence-other-key", {"key": str(document.get("key"))[:16]}))
    return EvidenceCheck(
        ok=not problems,
        problem=" ".join(problems) or None,
        problems=tuple(problems),
        notes=tuple(_notes(page, key, decided)),
        key=str(document.get("key")),
        made_at=str(document.get("made_at")),
        program=str(document.get("program")),
        decision=_words_of(document),
        lines=_by_lines(document),
    )


def _guarded(part: str, check: Callable[..., Iterator[str]], *given: object) -> list[str]:
    """What the check of a part finds; a document whose parts are not of their kind is a finding too."""
    try:
        return list(check(*given))
    except _NOT_OF_KIND as error:
        return [say("evidence-form", {"part": part, "words": str(error)})]


def _sealed(page: ReadPage) -> Iterator[str]:
    if page.program != page.document["page"]:
        yield say("evidence-another-page", {})
    if not page.is_canonical:
        yield say("evidence-not-canonical", {})


def _signature(page: ReadPage) -> Iterator[str]:
    document = page.document
    if not signature_holds(document, str(document["key"]), page.signature):
        yield say("evidence-signature", {})
    keys = [{name: one[name] for name in KEY_PARTS} for one in document["keys"]]
    if not are_handed_on(keys, document["key"]):
        yield say("evidence-keys", {})


def _is_known(document: Document, key: str) -> bool:
    keys = document.get("keys")
    known = [str(one.get("key")) for one in keys if isinstance(one, dict)] if isinstance(keys, list) else []
    return any(one.startswith(key.lower()) for one in known)


def _words_of(document: Document) -> str:
    decision = document.get("decision")
    return str(decision.get("words")) if isinstance(decision, dict) else ""


def _pictures(page: ReadPage) -> Iterator[str]:
    told = page.document["pictures"]
    if [picture["name"] for picture in told] != list(page.pictures) or [
        picture["camera"] for picture in told
    ] != [1, 2]:
        yield say("evidence-pictures", {})
        return
    for picture in told:
        content = page.pictures[picture["name"]]
        if sha256_hex(content) != picture["sha256"]:
            yield say("evidence-picture", {"name": picture["name"]})
        elif image_size(content, picture["name"]) != (picture["columns"], picture["rows_px"]):
            yield say("evidence-picture-size", {"name": picture["name"]})


def _events(page: ReadPage) -> Iterator[str]:
    """Each event is the one that was hashed, of this survey's chain, and says what the document says."""
    document = page.document
    audit = document["audit"]
    chain = survey_chain(document["survey"]["id"])
    for event in audit["events"]:
        inside = event["chain"] == chain == audit["chain"] and event["number"] <= audit["count"]
        last = event["number"] == audit["count"] and event["hash"] != audit["hash"]
        if not inside or last or event["hash"] != chain_hash(event):
            yield say("evidence-event", {"number": event["number"]})
    yield from _check_against_events(
        audit["events"], "measurement", document["measurement"], document["review"]
    )
    if document["before"] is not None:
        yield from _check_against_events(
            audit["events"], "before", document["before"], document["before"]["review"]
        )


def _check_against_events(
    events: list[Document], part: str, measured: Document, review: Document
) -> Iterator[str]:
    """A revision is what its event says; its verdict the last given on it, or the one that it puts back."""
    own = [
        event
        for event in events
        if (event["entity"], event["entity_id"]) == ("scan_measurement", measured["id"])
    ]
    if len(own) != 1:
        yield say("evidence-no-event", {"part": part})
        return
    stated = json.loads(own[0]["after"])
    other = sorted(name for name in stated if name in measured and stated[name] != measured[name])
    if other:
        yield say("evidence-not-as-event", {"part": part, "named": ", ".join(other)})
    given = [
        (event, after)
        for event in events
        if event["entity"] == "scan_review"
        for after in [json.loads(event["after"])]
        if after["measurement_id"] in (measured["id"], stated.get("verdict_of_id"))
    ]
    last, after = given[-1] if given else (None, {"verdict": "to_review", "reason": None})
    reviewer = None if review["reviewer"] is None else review["reviewer"]["id"]
    by = None if last is None else last["actor_id"]
    if (review["verdict"], review["reason"], reviewer) != (after["verdict"], after["reason"], by):
        yield say("evidence-not-as-event", {"part": part, "named": "review"})


def _derived(page: ReadPage) -> Iterator[str]:
    for name, value in derived_parts(page.document).items():
        told, found = page.document[name], to_plain_json(value)
        if name == "gap" and told and not _is_ours(page.document):
            told = {part: each for part, each in told.items() if part != "headway_s"}
            found = next(
                (told for one in (found, _gap_by_rig_now(page.document)) if _is_alike(told, one)), found
            )
        if found != told:
            yield say("evidence-made-again", {"named": name})


def _is_alike(told: Document, found: Document) -> bool:
    """Whether another version told the same but for the last digits of its numbers."""
    return told.keys() == found.keys() and all(
        isclose(told[name], value, rel_tol=_CLOSE)
        if isinstance(value, float) and isinstance(told[name], float | int)
        else told[name] == value
        for name, value in found.items()
    )


def _gap_by_rig_now(document: Document) -> Document:
    """As earlier versions computed it: by the line rate that the recording had when the file was made."""
    rig = {"rig": document["rig_now"]}
    pair = {part: document[part] | rig for part in ("measurement", "before")}
    gap: Document = to_plain_json(derived_parts({**document, **pair})["gap"])
    return gap


def _decide_again(page: ReadPage) -> Document | str:
    """What this version decides of the document; why it cannot, in a sentence."""
    try:
        return decision_of(page.document, rule_of(page.document["decision"]))
    except _NOT_OF_KIND as error:
        return say("evidence-form", {"part": "decision", "words": str(error)})


def _decision(page: ReadPage, recomputed: Document | str) -> Iterator[str]:
    """Value, limit and answer; the words, where this version made them: another one may word it otherwise."""
    if isinstance(recomputed, str):
        yield recomputed
        return
    told = page.document["decision"]
    names = {*told, *recomputed} - (set() if _is_ours(page.document) else {"words"})
    other = sorted(name for name in names if told.get(name) != recomputed.get(name))
    if other:
        yield say("evidence-made-again", {"named": ", ".join(f"decision: {name}" for name in other)})


def _translations(page: ReadPage) -> Iterator[str]:
    """What this version says in other languages; another one may word it otherwise."""
    document = page.document
    if _is_ours(document) and document["said"] != translations_of(document):
        yield say("evidence-made-again", {"named": "said"})


def _is_ours(document: Document) -> bool:
    """Whether this version made the file."""
    return bool(document["program"] == code_version())


def _numbers(page: ReadPage) -> Iterator[str]:
    """Length, budget and crossings of this vehicle and of the one before."""
    for part in ("measurement", "before"):
        told = page.document[part]
        if told is None:
            continue
        other = _other_numbers(told)
        if other:
            yield say("evidence-numbers", {"part": part, "named": ", ".join(other)})


def _other_numbers(motion: Document) -> list[str]:
    """The names of what does not follow from the lines, the rig and the budget of a motion."""
    numbers = [*_MOTION, *(f"u_{name}" for name in _MOTION)]
    if motion["status"] != "ok":
        return [name for name in numbers if motion[name] is not None]
    if not all(isinstance(motion[name], float | int) and isfinite(motion[name]) for name in numbers):
        return numbers
    return [*_budget(motion), *_lines(motion)]


def _budget(motion: Document) -> list[str]:
    other = []
    entries = {one["source"]: one for one in motion["budget"]}
    for name in _MOTION:
        u = hypot(*(one[f"u_{name}"] for one in motion["budget"]))
        if not isclose(u, motion[f"u_{name}"], rel_tol=_CLOSE):
            other.append(f"u_{name}")
    for source, times in _BY_RIG.items():
        ratio = _ratio(motion["rig"], source)
        for name, factor in zip(_MOTION, times, strict=True):
            due = factor * abs(motion[name]) * ratio
            if not isclose(entries[source][f"u_{name}"], due, rel_tol=_CLOSE, abs_tol=1e-15):
                other.append(f"{name} ({source})")
    return other


def _ratio(rig: Document, source: str) -> float:
    if source == "clock":
        return float(rig["u_line_rate_ratio"])
    baseline_m, u_baseline_m = baseline_of(rig_from(rig))
    return u_baseline_m / baseline_m


def _lines(motion: Document) -> list[str]:
    """The length as the method has it; front and rear carried over the baseline by the motion."""
    rate, start = motion["rig"]["line_rate_hz"], motion["front_line_1"]
    rear_1, front_2, rear_2 = (
        (motion[name] - start) / rate for name in ("rear_line_1", "front_line_2", "rear_line_2")
    )
    baseline_m, _ = baseline_of(rig_from(motion["rig"]))

    def gone(seconds: float) -> float:
        return float(travelled_m(motion["speed_mps"], motion["acceleration_mps2"], seconds))

    at_2 = gone(rear_2) - gone(front_2)
    length_m = gone(rear_1) if motion["method"] == "paper" else (gone(rear_1) + at_2) / 2
    other = [] if isclose(length_m, motion["length_m"], rel_tol=_CLOSE) else ["length_m"]
    if motion["method"] == "paper":  # its boundaries are not held against its regression
        return other
    budget = [Entry(**one) for one in motion["budget"]]
    if motion["direction"] == "camera_2_first":
        baseline_m = -baseline_m
    apart_m = ("front", gone(front_2) - baseline_m), ("rear", gone(rear_2) - gone(rear_1) - baseline_m)
    most = 2 * DISAGREE_OVER_U * (1 + _CLOSE)
    return other + [f"speed_mps ({end})" for end, by in apart_m if abs(by) > most * u_end_of(budget, end)]


def _by_lines(document: Document) -> ExactMotion | None:
    """What the four lines give alone, to look at beside the fit; None where they give no motion."""
    try:
        told = document["measurement"]
        crossings = crossings_of(values_of_document(told))
        baseline_m = document["at_vehicle"]["baseline_m"]
        return exact_at_camera_1(crossings, baseline_m, told["rig"]["line_rate_hz"])
    except (KeyError, TypeError, ValueError, ArithmeticError):
        return None


def _notes(page: ReadPage, key: str | None, decided: Document | str) -> Iterator[str]:
    try:
        if page.program != program_of_page():
            yield say("evidence-page-other-version", {})
    except BadInput as error:
        yield error.message
    if not isinstance(decided, str) and page.document.get("program") != code_version():
        yield say("evidence-words-other-version", {"words": decided["words"]})
    shown = str(page.document.get("key"))[:16]
    yield say("evidence-key-given" if key is not None else "evidence-key-not-given", {"key": shown})


#: By the parts of a document, as `evidence-form` names them.
_CHECKS: Mapping[str, Callable[[ReadPage], Iterator[str]]] = {
    "page": _sealed,
    "signature": _signature,
    "pictures": _pictures,
    "events": _events,
    "derived": _derived,
    "numbers": _numbers,
}
