"""What somebody kept elsewhere of an installation's audit chains, and whether those here go on from it."""

from collections.abc import Mapping, Sequence
from typing import Any

from sightline.enums import JsonObject
from sightline.errors import BadInput, Damaged
from sightline.infra.audit.checkpoints import FORMAT, is_signed
from sightline.infra.audit.merkle import root_by_path, root_of
from sightline.infra.audit.records import AuditHead

LEAST_SIGNS = 16


class Anchors:
    """`key`: (the beginning of) a signing key; `heads`: of hashes with which chains ended once;
    `checkpoints`: documents of `sightline checkpoint` or of packages. `unheld` is what held nowhere yet.

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
        self._heads = [head.lower() for head in heads]
        self._ends = {str(one.get("at")): _signed_ends(one) for one in checkpoints}
        self._keys = {str(one.get("at")): str(one.get("key")) for one in checkpoints}
        self.unheld = {*self._heads, *self._ends}

    def __bool__(self) -> bool:
        return self.key is not None or bool(self._heads or self._ends)

    def hold(self, chains: Mapping[str, Sequence[str]], keys: Sequence[str], *, whole: bool) -> list[int]:
        """The events with the heads given, but for the last ones. `chains`: the hashes by name, that of none
        first; `keys`: those that signed; `whole`: all chains of the installation are here. Raises Damaged.
        """
        if self.key is not None and not any(one.startswith(self.key) for one in keys):
            raise Damaged("export-checkpoint-other-key", key="".join(keys[-1:])[:LEAST_SIGNS])
        continued = list[int]()
        found = {head: _events_with(head, chains) for head in self._heads}
        if found and not any(found.values()):
            raise Damaged("export-head-differs", head=self._heads[0][:LEAST_SIGNS])
        for head, numbers in found.items():
            self.unheld -= {head} if numbers else set()
            continued += [number for number, last in numbers if not last]
        told = {at: ends for at, ends in self._ends.items() if whole or set(ends) & set(chains)}
        if self._ends and not told:
            raise Damaged("audit-checkpoint-elsewhere")
        for at, ends in told.items():
            here = ends if whole else {name: ends[name] for name in ends if name in chains}
            if self._keys[at] not in keys or not all(
                chains.get(name, ())[end.count : end.count + 1] == [end.hash] for name, end in here.items()
            ):
                raise Damaged("audit-chains-not-signed", at=at)
            self.unheld.discard(at)
        return continued


def _events_with(head: str, chains: Mapping[str, Sequence[str]]) -> list[tuple[int, bool]]:
    """The number of each event with that hash, and whether it is the last of its chain."""
    return [
        (number, number == len(hashes) - 1)
        for hashes in chains.values()
        for number, hash_ in enumerate(hashes)
        if number and hash_.startswith(head)
    ]


def _signed_ends(document: JsonObject) -> dict[str, AuditHead]:
    """The ends that a checkpoint signed: all, or that of its package. Raises BadInput."""
    try:
        if document["format"] == FORMAT and is_signed(document):
            leaf: dict[str, Any] | None = document.get("leaf")
            if leaf is None:
                ends = {name: AuditHead(count, hash_) for name, count, hash_ in document["ends"]}
                root = root_of(ends)
            else:
                ends = {leaf["chain"]: AuditHead(leaf["count"], leaf["hash"])}
                ((chain, end),) = ends.items()
                root = root_by_path(chain, end, document["place"], document["chains"], document["path"]) or ""
            if root == document["root"]:
                return ends
    except (KeyError, TypeError, ValueError, AttributeError):
        pass
    raise BadInput("audit-no-checkpoint")
