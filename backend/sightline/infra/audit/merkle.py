"""The tree over the ends of all audit chains (RFC 9162, 2.1): one root for all, a short path for each.

A leaf is sha256(0x00 + the canonical JSON of {chain, count, hash}), a node sha256(0x01 + left + right);
leaves stand in the order of the chains' names.
"""

import hashlib
from collections.abc import Mapping, Sequence

from sightline.infra.audit.hashing import canonical_json
from sightline.infra.audit.records import AuditHead


def root_of(ends: Mapping[str, AuditHead]) -> str:
    """The root over the ends of chains by their names."""
    return _root(_leaves(ends)).hex()


def path_of(ends: Mapping[str, AuditHead], chain: str) -> tuple[int, list[str]]:
    """The place of a chain among the leaves, from 0, and the hashes beside its way up to the root."""
    place = sorted(ends).index(chain)
    return place, [one.hex() for one in _path(_leaves(ends), place)]


def root_by_path(chain: str, end: AuditHead, place: int, size: int, path: Sequence[str]) -> str | None:
    """The root that a leaf and its path give in a tree of `size` leaves (RFC 9162, 2.1.3.2).

    None where the path is not as long as this place asks for.
    """
    if not 0 <= place < size:
        return None
    node, at, last = _leaf(chain, end), place, size - 1
    for step in path:
        if last == 0:
            return None
        sibling = bytes.fromhex(step)
        if at % 2 or at == last:
            node = _node(sibling, node)
            while not at % 2 and at:
                at, last = at // 2, last // 2
        else:
            node = _node(node, sibling)
        at, last = at // 2, last // 2
    return node.hex() if last == 0 else None


def _leaves(ends: Mapping[str, AuditHead]) -> list[bytes]:
    return [_leaf(name, ends[name]) for name in sorted(ends)]


def _leaf(chain: str, end: AuditHead) -> bytes:
    text = canonical_json({"chain": chain, "count": end.count, "hash": end.hash})
    return hashlib.sha256(b"\0" + text.encode()).digest()


def _node(left: bytes, right: bytes) -> bytes:
    return hashlib.sha256(b"\1" + left + right).digest()


def _root(leaves: Sequence[bytes]) -> bytes:
    if len(leaves) < 2:
        return leaves[0] if leaves else hashlib.sha256(b"").digest()
    split = _split(len(leaves))
    return _node(_root(leaves[:split]), _root(leaves[split:]))


def _path(leaves: Sequence[bytes], place: int) -> list[bytes]:
    if len(leaves) < 2:
        return []
    split = _split(len(leaves))
    if place < split:
        return [*_path(leaves[:split], place), _root(leaves[split:])]
    return [*_path(leaves[split:], place - split), _root(leaves[:split])]


def _split(count: int) -> int:
    """The largest power of two below `count`."""
    return 1 << ((count - 1).bit_length() - 1)
