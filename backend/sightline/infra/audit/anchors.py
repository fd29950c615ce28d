"""What somebody kept elsewhere of an installation's audit chains, and whether those here go on from it."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sightline.enums import JsonObject
from sightline.errors import BadInput, Damaged
from sightline.infra.audit.checkpoints import FORMAT, is_signed
from sightline.infra.audit.merkle import root_by_path, root_of
from sightline.infra.audit.records import AuditHead

LEAST_SIGNS = 16

#: The hashes of chains by name, that of none first.
Hashes = Mapping[str, Sequence[str]]


@dataclass(frozen=True)
class _Kept:
    """A checkpoint: when it was signed, and the end of each chain that it vouches for."""

    at: str
    ends: Mapping[str, AuditHead]


class Anchors:
    """`key`: (the beginning of) a signing key; `heads`: of hashes with which chains ended once;
    `checkpoints`: documents of `sightline checkpoint` or of packages.

    Raises BadInput for what is too short to tell anything, and for what is no checkpoint.
    """

    def __init__(
        self, key: str | None = None, heads: Sequence[str] = (), checkpoints: Sequence[JsonObject] = ()
    ) -> None:
        if key is not None and len(key) < LEAST_SIGNS:
            raise BadInput("export-key-too-short", least=LEAST_SIGNS)
        for head in heads:
            if len(head) < LEAST_SIGNS:
                raise BadInput("export-head-too-short", count=len(head), least_of_head=LEAST_SIGNS)
        self.key = key and key.lower()
        self.heads = [head.lower() for head in heads]
        self.checkpoints = [_kept(one) for one in checkpoints]

    def __bool__(self) -> bool:
        return self.key is not None or bool(self.heads or self.checkpoints)

    def hold_in_package(self, chain: str, hashes: Sequence[str], keys: Sequence[str]) -> int:
        """How many events of a package's chain this vouches for; `keys`: those that led to the signature of
        its end, which vouches for all. Raises Damaged where one of the anchors does not hold.
        """
        for checkpoint in self.checkpoints:
            if chain not in checkpoint.ends:
                raise Damaged("audit-checkpoint-elsewhere", at=checkpoint.at)
        vouched = self._hold({chain: hashes})
        if self.key is None:
            return vouched
        if not any(one.startswith(self.key) for one in keys):
            raise Damaged("export-checkpoint-other-key", key=keys[-1][:LEAST_SIGNS])
        return len(hashes) - 1

    def hold_in_database(self, chains: Hashes, root: str) -> int:
        """The same of all chains of an installation, which no key vouches for: with it, who wrote them could
        write it among their events. `root`: the head of all together, which is told of a database.
        """
        return self._hold(chains, root)

    def _hold(self, chains: Hashes, root: str = "") -> int:
        passed = [end for head in self.heads for end in _ends_at(head, chains, root)]
        for checkpoint in self.checkpoints:
            passed += _passed(checkpoint, chains, whole=bool(root))
        vouched: dict[str, int] = {}
        for name, number in passed:
            vouched[name] = max(number, vouched.get(name, 0))
        return sum(vouched.values())


def _ends_at(head: str, chains: Hashes, root: str) -> list[tuple[str, int]]:
    """The chain and number of the event with that hash, or every chain's last. Raises Damaged."""
    if root.startswith(head):
        return [(name, len(hashes) - 1) for name, hashes in chains.items()]
    found = [
        (name, number)
        for name, hashes in chains.items()
        for number, hash_ in enumerate(hashes)
        if number and hash_.startswith(head)
    ]
    if not found:
        raise Damaged("export-head-differs", head=head[:LEAST_SIGNS])
    return found


def _passed(checkpoint: _Kept, chains: Hashes, *, whole: bool) -> Iterator[tuple[str, int]]:
    """The ends that a checkpoint signed, of the chains here or of all. Raises Damaged."""
    for name, end in checkpoint.ends.items():
        if not whole and name not in chains:
            continue
        hashes = chains.get(name, [""])
        at, last = checkpoint.at, len(hashes) - 1
        if end.count > last:
            raise Damaged("audit-chain-ends-before", chain=name, at=at, event=end.count, last=last)
        if hashes[end.count] != end.hash:
            raise Damaged("audit-chain-differs", chain=name, at=at, event=end.count)
        yield name, end.count


def _kept(document: JsonObject) -> _Kept:
    """A checkpoint of all ends, or of that of its package. Raises BadInput."""
    try:
        if document["format"] == FORMAT and is_signed(document):
            leaf = document.get("leaf")
            if leaf is None:
                ends = {name: AuditHead(count, hash_) for name, count, hash_ in document["ends"]}
                root = root_of(ends)
            else:
                chain, end = leaf["chain"], AuditHead(leaf["count"], leaf["hash"])
                ends = {chain: end}
                root = root_by_path(chain, end, document["place"], document["chains"], document["path"]) or ""
            whole_numbers = all(type(end.count) is int and end.count >= 0 for end in ends.values())
            if root == document["root"] and whole_numbers:
                return _Kept(str(document["at"]), ends)
    except (KeyError, TypeError, ValueError, AttributeError):
        pass
    raise BadInput("audit-no-checkpoint")
