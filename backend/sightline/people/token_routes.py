"""Tokens of one's own, for programs; only a person who signed in can make, see and revoke them."""

from fastapi import APIRouter, Request

from sightline.infra.web.bearer import ApiTokenFacts
from sightline.infra.web.deps import InPerson, PathId, Reading, Wired
from sightline.infra.web.idempotency import TOLD_ONCE
from sightline.people import token_store
from sightline.people.bodies import MadeToken, NewToken
from sightline.people.store import get_person_still

router = APIRouter()


@router.get("/session/tokens")
def list_tokens(who: InPerson, session: Reading) -> list[ApiTokenFacts]:
    """One's own tokens that were not revoked, newest first; their text is told once, when made."""
    return list(token_store.list_api_tokens(session, who.id))


@router.post("/session/tokens", status_code=201, dependencies=[TOLD_ONCE])
def make_token(body: NewToken, who: InPerson, services: Wired) -> MadeToken:
    """A token that may do what its scopes say, as far as one may oneself, until it ends or is revoked."""
    with services.writing() as session:
        get_person_still(session, who)
        token, text = token_store.create_api_token(
            session, who.id, name=body.name, scopes=body.scopes, days=body.days
        )
    return MadeToken(token=token, text=text)


@router.delete("/session/tokens/{token_id}", status_code=204)
def revoke_token(token_id: PathId, who: InPerson, request: Request, services: Wired) -> None:
    """End a token at once; other processes of the app follow within two seconds."""
    with services.writing() as session:
        token_store.revoke_api_token(session, who.id, token_id, actor=who.id)
    request.app.state.bearers.forget()
