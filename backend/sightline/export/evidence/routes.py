"""Evidence of one line-scanned vehicle as one file, made for a person who may export."""

from fastapi import APIRouter
from pydantic import Field

from sightline.enums import Conformity, JudgedQuantity
from sightline.export.evidence.records import Evidence, Rule
from sightline.export.evidence.service import make_evidence
from sightline.infra.web.bodies import In, Out
from sightline.infra.web.deps import AskedIn, Exporter, PathId, Wired
from sightline.statistics.conformity import LEAST_RISK, MOST_RISK

router = APIRouter()


class RuleIn(In):
    """A limit that somebody set, and the risk of a false decision that is taken."""

    quantity: JudgedQuantity
    limit: float = Field(gt=0, le=1e4, description="m/s for a speed, s or m for a gap.")
    risk: float = Field(0.05, ge=LEAST_RISK, le=MOST_RISK)
    source: str = Field("", max_length=300, description="Who set the limit, and where it stands.")


class EvidenceWanted(In):
    rule: RuleIn | None = Field(None, description="null: no rule, and so no decision.")


class EvidenceBody(Out):
    filename: str = Field(description="What the file is to be called.")
    html: str = Field(description="The file itself: one page with everything in it.")
    sha256: str = Field(description="Of what it says, as the audit trail names it.")
    signing_key: str
    answer: Conformity | None
    decision: str = Field(description="The decision, or why there is none, in words.")


@router.post("/scan-vehicles/{vehicle_id}/evidence", status_code=201)
def make_evidence_of_vehicle(
    vehicle_id: PathId, body: EvidenceWanted, who: Exporter, services: Wired, asked_in: AskedIn
) -> EvidenceBody:
    """One file with both pictures, numbers, budget, decision and signature; noted in the audit trail; its
    page opens in the language of the request.
    """
    rule = None if body.rule is None else Rule(**body.rule.model_dump())
    return _body(make_evidence(services, vehicle_id, rule, language=asked_in, actor=who.id), asked_in)


def _body(evidence: Evidence, language: str) -> EvidenceBody:
    words = evidence.document["decision"]["words"]
    return EvidenceBody(
        filename=evidence.filename,
        html=evidence.content.decode("utf-8"),
        sha256=evidence.sha256,
        signing_key=evidence.document["key"],
        answer=evidence.document["decision"]["answer"],
        decision=evidence.document["said"].get(language, {}).get(words, words),
    )
