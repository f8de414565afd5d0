"""Attributes of files in the maps of tensors."""

from __future__ import annotations

from collections.abc import Iterable

from ....core.errors import FileError, FilePath, values_of_file
from ..geometry.tensor_map import RESERVED, TensorMap

REMEDY = "Rename it in the file, or read the file with pointloom instead of pointloom.open3d"


def check_attribute_names(filename: FilePath, of: str, names: Iterable[str], primary: str) -> None:
    """Raise FileError for a name that a map of tensors cannot contain."""
    for name in names:
        if name in RESERVED or name.startswith("__") or name == primary:
            reason = f"expected a name of an attribute, got {name!r}, which the map of tensors uses itself"
            raise FileError(filename, reason, where=of, remedy=REMEDY)


def set_attribute(filename: FilePath, attributes: TensorMap, name: str, values: object) -> None:
    """Add an attribute of a file. Raises FileError for reserved names and types that tensors do not have."""
    check_attribute_names(filename, f"attribute {name}", [name], attributes.primary_key)
    with values_of_file(filename, where=f"attribute {name}"):
        attributes[name] = values
