"""What somebody kept elsewhere of an installation's audit chains, and whether those here go on from it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sightline.enums import JsonObject
from sightline.errors import BadInput, Damaged
from sightline.infra.audit.checkpoints import FORMAT, is_signed
from sightline.infra.audit.merkle import root_by_path, root_of
from sightline.infra.audit.records import AuditHead

LEAST_SIGNS = 16


@dataclass(frozen=True, eq=False)
class _Checkpoint:
    """When it was signed and with which key; the ends that it signed, by the names of their chains."""

    at: str
    key: str
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
        self._heads = [head.lower() for head in heads]
        self._checkpoints = [_read_checkpoint(one) for one in checkpoints]
        self._unheld: set[str | _Checkpoint] = {*self._heads, *self._checkpoints}

    def __bool__(self) -> bool:
        return self.key is not None or bool(self.of_chains)

    @property
    def of_chains(self) -> list[str]:
        """Names of those given that only a place with whole chains can hold."""
        given = {"head": self._heads, "checkpoint": self._checkpoints}
        return [name for name, those in given.items() if those]

    @property
    def unheld(self) -> list[str]:
        """Heads, and moments of checkpoints, that held nowhere yet."""
        return sorted(one if isinstance(one, str) else one.at for one in self._unheld)

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
            self._unheld -= {head} if numbers else set()
            continued += [number for number, last in numbers if not last]
        told = [
            one for one in self._checkpoints if one.key in keys and (whole or one.ends.keys() & chains.keys())
        ]
        if self._checkpoints and not told:
            raise Damaged("audit-checkpoint-elsewhere")
        for checkpoint in told:
            here = {name: end for name, end in checkpoint.ends.items() if whole or name in chains}
            if not all(
                chains.get(name, ())[end.count : end.count + 1] == [end.hash] for name, end in here.items()
            ):
                raise Damaged("audit-chains-not-signed", at=checkpoint.at)
            self._unheld.discard(checkpoint)
        return continued


def _events_with(head: str, chains: Mapping[str, Sequence[str]]) -> list[tuple[int, bool]]:
    """The number of each event with that hash, and whether it is the last of its chain."""
    return [
        (number, number == len(hashes) - 1)
        for hashes in chains.values()
        for number, hash_ in enumerate(hashes)
        if number and hash_.startswith(head)
    ]


def _read_checkpoint(document: JsonObject) -> _Checkpoint:
    """A checkpoint with the ends that it signed: all, or that of its package. Raises BadInput."""
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
                return _Checkpoint(str(document["at"]), str(document["key"]), ends)
    except (KeyError, TypeError, ValueError, AttributeError):
        pass
    raise BadInput("audit-no-checkpoint")
