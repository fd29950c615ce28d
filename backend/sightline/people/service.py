"""Accounts at work: signing in with a password or a one-time link, passwords (Argon2), the first admin."""

from contextlib import suppress
from functools import cache

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerifyMismatchError
from cachetools import TTLCache

from sightline.errors import BadInput, NoRoom, NotAllowed, NotSignedIn, TooMany
from sightline.infra.database import Session
from sightline.infra.database.engine import SIGN_IN
from sightline.infra.limits import store as limits
from sightline.infra.limits.store import Limit
from sightline.infra.services import Services
from sightline.infra.web.bearer import PER_TOKEN, ApiToken
from sightline.infra.web.person import Person
from sightline.people.store import (
    create_person,
    create_sign_in_link,
    get_person,
    get_person_still,
    list_people,
    note_person_seen,
    password_hash_of,
    person_by_email,
    rehash_password,
    set_password,
    update_person,
    use_sign_in_link,
)
from sightline.people.token_store import api_token_by_text, note_api_token_used

MIN_PASSWORD = 10
MAX_PASSWORD = 1000
#: signs that differ and are no spaces: ten times one sign is long, and the first that anybody tries
LEAST_DIFFERENT = 3
FIRST_ADMIN = ("Admin", "admin@sightline.local")
PER_ACCOUNT = Limit("sign-ins to an account from an address", 5, 300)
# Not enough to try a list on everybody.
PER_ADDRESS = Limit("sign-ins, links and wrong tokens from an address", 50, 300)
#: beyond that one try in so many seconds: an address may be that of a whole office, and is not shut out
PACE_S = 5.0

_hasher = PasswordHasher()


@cache
def _nobodys_hash() -> str:
    """Verified against when the address is unknown: the time taken must not tell who has an account."""
    return _hasher.hash("nobody has this password")


class Attempts:
    """Counts failed sign-ins per account and address, and per address alone, over all processes.

    What was right counts no more: one address may be that of a whole office. An account from one address is
    shut out for a while, an address slowed down. With a full disk the count is this process's own.
    """

    def __init__(self, services: Services) -> None:
        self._services = services
        self._without_disk: TTLCache[str, int] = TTLCache(4096, PER_ACCOUNT.seconds)

    def begin(self, email: str, address: str) -> None:
        """Count an attempt before it is tried, so that many at once do not slip through. Raises TooMany."""
        self._count(address, _account(email, address))

    def begin_secret(self, address: str) -> None:
        """The same for a link or a token, which name no account. Raises TooMany."""
        self._count(address, None)

    def succeeded(self, email: str, address: str) -> None:
        """Forget the failures of this account from this address, and that this one was tried."""
        self._without_disk.pop(_account(email, address), None)
        with suppress(NoRoom), self._services.writing(SIGN_IN) as session:
            limits.forget_counted(session, PER_ACCOUNT, _account(email, address))
            limits.uncount(session, PER_ADDRESS, address)

    def _count(self, address: str, account: str | None) -> None:
        # Looked at first: who is refused makes nobody wait for the turn to write.
        with self._services.reading() as session:
            _require_room(session, address, account)
        try:
            with self._services.writing(SIGN_IN) as session:
                _require_room(session, address, account)
                limits.count_tried(session, PER_ADDRESS, address)
                if account is not None:
                    limits.count_tried(session, PER_ACCOUNT, account)
        except NoRoom:
            self._count_without_disk(account or address)

    def _count_without_disk(self, of: str) -> None:
        tried = self._without_disk.get(of, 0)
        if tried >= PER_ACCOUNT.most:
            raise TooMany("people-sign-ins-blocked", retry_after_s=PER_ACCOUNT.seconds)
        self._without_disk[of] = tried + 1


def _require_room(session: Session, address: str, account: str | None) -> None:
    if account is not None and (seconds := limits.wait_s(session, PER_ACCOUNT, account)):
        raise TooMany("people-sign-ins-blocked", retry_after_s=seconds)
    if seconds := limits.wait_s(session, PER_ADDRESS, address, pace_s=PACE_S):
        raise TooMany("people-sign-ins-slowed", seconds=seconds, retry_after_s=seconds)


def _account(email: str, address: str) -> str:
    return f"{email.strip().lower()}\n{address}"


class Tokens:
    """What the app asks of tokens."""

    def __init__(self, services: Services, attempts: Attempts) -> None:
        self._services = services
        self._attempts = attempts

    def token_by_text(self, text: str) -> ApiToken | None:
        """The token that holds."""
        with self._services.reading() as session:
            return api_token_by_text(session, text)

    def spend(self, token: ApiToken, requests: int) -> bool:
        """Count requests of a token; False where there are too many. With a full disk none is counted."""
        with suppress(NoRoom), self._services.writing(SIGN_IN) as session:
            note_api_token_used(session, token.id)
            return limits.count_against(session, PER_TOKEN, str(token.id), requests)
        return True

    def count_wrong(self, address: str) -> None:
        """Count a wrong token. Raises TooMany."""
        self._attempts.begin_secret(address)


def sign_in(services: Services, attempts: Attempts, email: str, password: str, address: str) -> Person:
    """Whose email and password these are.

    Raises:
        NotSignedIn: they do not fit, or the account is switched off (which of the two is not said).
        TooMany: five failures within five minutes, or fifty from the address and one just now.
    """
    attempts.begin(email, address)
    with services.reading() as session:
        person = person_by_email(session, email)
        stored = password_hash_of(session, person.id) if person and person.active else None
    if not matches(stored, password) or person is None:
        raise NotSignedIn("people-sign-in-wrong")
    attempts.succeeded(email, address)
    # With a full disk these wait for another time: who makes room has to get in.
    with suppress(NoRoom), services.writing(SIGN_IN) as session:
        if stored is not None and _hasher.check_needs_rehash(stored):
            rehash_password(session, person.id, stored, _hasher.hash(password))
        note_person_seen(session, person.id)
    # As read with the password that fits: a session begun beside a change of it is over with the others.
    return person


def sign_in_by_link(services: Services, attempts: Attempts, token: str, address: str) -> Person:
    """Whose one-time link this is; it works once. Raises NotSignedIn for one that is not good, TooMany."""
    attempts.begin_secret(address)
    with services.writing() as session:
        person = use_sign_in_link(session, token)
        limits.uncount(session, PER_ADDRESS, address)
        note_person_seen(session, person.id)
        return get_person(session, person.id)


def matches(stored: str | None, password: str) -> bool:
    """Whether the password is the one behind the stored hash; takes as long when there is none."""
    try:
        return _hasher.verify(stored or _nobodys_hash(), password) and stored is not None
    except (VerifyMismatchError, InvalidHashError):
        return False


def change_password(
    services: Services,
    attempts: Attempts,
    person: Person,
    current: str | None,
    new: str,
    by_link: bool,
    address: str,
) -> Person:
    """Set a password and end all other sessions. Whoever came by a one-time link need not know the old one.

    Raises:
        BadInput: the new one is too short or too long, or spaces or one sign alone.
        NotAllowed: the current one is missing or wrong.
        NotSignedIn: the session ended meanwhile.
        TooMany: it was wrong as often as may be at signing in.
    """
    if not MIN_PASSWORD <= len(new) <= MAX_PASSWORD:
        raise BadInput("people-password-length", min_password=MIN_PASSWORD, max_password=MAX_PASSWORD)
    if len(set("".join(new.split()).casefold())) < LEAST_DIFFERENT:
        raise BadInput("people-password-one-sign", least=LEAST_DIFFERENT)
    with services.reading() as session:
        stored = password_hash_of(session, person.id)
    if stored is not None and not by_link:
        attempts.begin(person.email, address)
        if not matches(stored, current or ""):
            raise NotAllowed("people-password-wrong")
        attempts.succeeded(person.email, address)
    hashed = _hasher.hash(new)
    with services.writing() as session:
        get_person_still(session, person)
        return set_password(session, person.id, hashed, actor=person.id)


def change_name(services: Services, person: Person, name: str) -> Person:
    """Another name of one's own. Raises NotSignedIn where the session ended meanwhile."""
    with services.writing() as session:
        now = get_person_still(session, person)
        return update_person(session, now.id, name=name, role=now.role, active=now.active, actor=now.id)


def link_path(token: str) -> str:
    """The page that a one-time token opens."""
    return f"/sign-in?token={token}"


def first_sign_in_link(services: Services) -> str | None:
    """The path of a fresh one-time link for an admin who never signed in; None otherwise.

    Makes that admin where there is no account at all. Links made before stay good until one of them is used:
    another process may have printed it, or this one before it was started again.
    """
    with services.writing() as session:
        everybody = list_people(session)
        if not everybody:
            name, email = FIRST_ADMIN
            first = create_person(session, name=name, email=email, role="admin", actor=None)
        else:
            admins = [one for one in everybody if one.role == "admin" and one.active]
            if len(admins) != 1 or admins[0].has_password or admins[0].last_seen_at is not None:
                return None
            first = admins[0]
        return link_path(create_sign_in_link(session, first.id, actor=None, beside_others=True))


def new_sign_in_link(services: Services, email: str) -> str:
    """The path of a fresh one-time link for the account with this address, for whoever has lost their way in.

    Raises:
        BadInput: no active account has this address.
    """
    with services.writing() as session:
        person = person_by_email(session, email)
        if person is None or not person.active:
            raise BadInput("people-no-account", email=email)
        return link_path(create_sign_in_link(session, person.id, actor=None))
