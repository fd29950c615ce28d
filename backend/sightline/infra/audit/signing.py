"""The installation's signing key (Ed25519, RFC 8032): made once, kept in the data folder, changed when asked.

What is signed is the canonical JSON (RFC 8785) of a statement. Keys and signatures are hexadecimal text.
"""

import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey

from sightline.errors import Damaged
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.private import made_beside, made_once
from sightline.settings import Settings

FILE = "signing.key"


class SigningKey:
    """A private key; `public` is what others check its signatures with."""

    def __init__(self, seed: bytes) -> None:
        self._key = Ed25519PrivateKey.from_private_bytes(seed)
        self.public = self._key.public_key().public_bytes_raw().hex()

    def sign(self, statement: Mapping[str, Any]) -> str:
        """The signature of a statement."""
        return self._key.sign(canonical_json(statement).encode()).hex()


def signature_holds(statement: Mapping[str, Any], key: str, signature: str) -> bool:
    """Whether a statement was signed with a key."""
    try:
        if signature != signature.lower() or key != key.lower():
            return False
        public = Ed25519PublicKey.from_public_bytes(bytes.fromhex(key))
        public.verify(bytes.fromhex(signature), canonical_json(statement).encode())
    except (InvalidSignature, ValueError):
        return False
    return True


def signing_key(settings: Settings) -> SigningKey:
    """SIGHTLINE_SIGNING_KEY where it is set (several machines share it), else the data folder's own, made
    where there is none; only its owner may read the file. Raises Damaged.
    """
    path = settings.data_dir / FILE
    if settings.signing_key is not None:
        return _key_of(settings.signing_key.get_secret_value(), "SIGHTLINE_SIGNING_KEY")
    made_once(path)
    return _read_key(path)


def replacing_key(data_dir: Path) -> tuple[SigningKey, Path]:
    """A new key and the file where it waits; `put_in_force` makes it the data folder's."""
    fresh = made_beside(data_dir / FILE)
    return _read_key(fresh), fresh


def key_file(data_dir: Path, public: str) -> Path | None:
    """The file with this key: in force, or where it waits if who made it did not come to `put_in_force`."""
    for path in (data_dir / FILE, *data_dir.glob(f"{FILE}.*")):
        with suppress(Damaged):
            if _read_key(path).public == public:
                return path
    return None


def put_in_force(data_dir: Path, fresh: Path) -> None:
    """The key in this file takes the place of the one in force, which nobody can sign with any more."""
    os.replace(fresh, data_dir / FILE)


def _read_key(path: Path) -> SigningKey:
    try:
        text = path.read_text()
    except (OSError, ValueError) as error:
        raise Damaged("audit-signing-key-unreadable", path=path) from error
    return _key_of(text, str(path))


def _key_of(text: str, place: str) -> SigningKey:
    try:
        return SigningKey(bytes.fromhex(text.strip()))
    except ValueError as error:
        raise Damaged("audit-signing-key-unreadable", path=place) from error
