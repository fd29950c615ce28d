"""Two kinds of import contract that import-linter has not: both hold for files that nobody thought of."""

from collections.abc import Iterable
from fnmatch import fnmatchcase
from typing import Any

from grimp import ImportGraph
from importlinter import Contract, ContractCheck, fields, output


class _ByModule(Contract):
    """Checks each module by itself; `unwanted` says which of its imports are not allowed."""

    def check(self, graph: ImportGraph, verbose: bool) -> ContractCheck:
        found = [
            f"{module} -> {imported}"
            for module in sorted(graph.modules)
            if not graph.is_module_squashed(module)
            for imported in sorted(self.unwanted(module, graph.find_modules_directly_imported_by(module)))
        ]
        return ContractCheck(kept=not found, metadata={"found": found})

    def unwanted(self, module: str, imported: Iterable[str]) -> Iterable[str]:
        raise NotImplementedError

    def render_broken_contract(self, check: ContractCheck) -> None:
        for line in check.metadata["found"]:
            output.print_error(line)
        output.new_line()


class OnlyIn(_ByModule):
    """`packages` are imported by no module but those that a pattern in `allowed` names (`*` spans dots)."""

    type_name = "only_in"
    packages = fields.ListField(subfield=fields.StringField())
    allowed = fields.ListField(subfield=fields.StringField())

    def unwanted(self, module: str, imported: Iterable[str]) -> Iterable[str]:
        if any(fnmatchcase(module, str(pattern)) for pattern in _listed(self.allowed)):
            return []
        return [name for name in imported if name in _listed(self.packages)]


class ImportsOnly(_ByModule):
    """Each of `rooms` imports nothing but itself and `allowed`."""

    type_name = "imports_only"
    rooms = fields.ListField(subfield=fields.StringField())
    allowed = fields.ListField(subfield=fields.StringField())

    def unwanted(self, module: str, imported: Iterable[str]) -> Iterable[str]:
        room = next((str(room) for room in _listed(self.rooms) if _inside(module, str(room))), None)
        if room is None:
            return []
        return [name for name in imported if not _inside(name, room) and name not in _listed(self.allowed)]


def _listed(field: Any) -> list[Any]:
    return list(field)


def _inside(module: str, package: str) -> bool:
    return module == package or module.startswith(f"{package}.")
