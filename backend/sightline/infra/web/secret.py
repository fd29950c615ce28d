"""The secret that signs session cookies: from the settings, else made once and kept in the data folder."""

from sightline.errors import BadInput
from sightline.infra.audit.signing import signing_key
from sightline.infra.private import made_once
from sightline.settings import Settings

FILE = "secret.key"
BYTES = 32
#: what was printed where everybody can read it
_PRINTED = ("at-least-32-random-characters-go-here",)


def require_secrets(settings: Settings) -> None:
    """What a start asks of the secrets that several machines share.

    Raises BadInput for a secret that can be guessed or was printed, for a signing key that is none, and where
    PostgreSQL is used without one: each machine would sign with another.
    """
    if settings.secret is not None:
        given = settings.secret.get_secret_value()
        if len(given) < BYTES or given in _PRINTED:
            raise BadInput("web-secret-weak", characters=BYTES)
    if settings.signing_key is not None:
        signing_key(settings)
    elif settings.database_url.startswith("postgres"):
        raise BadInput("web-signing-key-missing")


def signing_secret(settings: Settings) -> bytes:
    """SIGHTLINE_SECRET where it is set (several machines share it), else the data folder's own file."""
    if settings.secret is not None:
        return settings.secret.get_secret_value().encode()
    return made_once(settings.data_dir / FILE)
