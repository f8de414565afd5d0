"""MTL, the materials of an OBJ file: names with the colour Kd and the picture map_Kd. All else is passed over.

A material with a picture is that picture, whatever its Kd; one with a colour alone is a picture of one pixel; one that
says neither is white. So a mesh has one picture a material.

Source: Wavefront, "MTL material format" (1995).
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ..pictures.texture_files import find_beside, picture_names, read_textures, warn_left_behind, why_missing
from ..source import open_source

# How many words follow each option of a map, at most; those of _MOVING shift or scale it.
_OPTIONS = {
    "-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-texres": 1, "-imfchan": 1, "-bm": 1, "-boost": 1,
    "-type": 1, "-mm": 2, "-o": 3, "-s": 3, "-t": 3,
}  # fmt: skip
_MOVING = {"-mm": (0.0, 1.0), "-o": (0.0,) * 3, "-s": (1.0,) * 3, "-t": (0.0,) * 3}

WHITE = (1.0, 1.0, 1.0)


@dataclass
class Material:
    """A material: its name, the name of its picture and its colour, None where it says none."""

    name: str
    picture: str | None = None
    color: tuple[float, ...] | None = None


def read_mtl(path: str | os.PathLike[str]) -> list[Material]:
    """The materials of an MTL file, in its order.

    Raises:
        FileError: Unreadable, a material that is named twice, a colour that is not three numbers in 0..1, or a picture
            that is shifted or scaled; says the line.
    """
    text = bytes(open_source(path)[:]).decode("utf-8", "surrogateescape")
    found: list[Material] = []
    for number, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.strip().replace("\t", " ").partition(" ")
        where = f"line {number}"
        if kind == "newmtl":
            if any(material.name == rest.strip() for material in found):
                raise FileError(path, f"the material {rest.strip()[:60]!r} is there twice", where=where)
            found.append(Material(rest.strip()))
        elif kind in ("Kd", "map_Kd"):
            if not found:
                raise FileError(path, f"{kind} stands before any newmtl", where=where)
            if kind == "Kd":
                found[-1].color = _parse_color(path, rest.split(), where)
            else:
                found[-1].picture = _parse_map(path, rest.strip(), where)
    return found


def _parse_color(path: Any, words: list[str], where: str) -> tuple[float, ...]:
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        values = ()
    if len(values) not in (1, 3) or not all(0 <= value <= 1 for value in values):
        raise FileError(path, f"Kd: expected three numbers in 0..1, found {' '.join(words)[:60]!r}", where=where)
    return values * (3 // len(values))  # one number is grey


def _parse_map(path: Any, text: str, where: str) -> str:
    """The picture's name behind the options of a map."""
    while text.startswith("-"):
        option, _, rest = text.partition(" ")
        if option not in _OPTIONS:
            raise FileError(path, f"map_Kd has the unknown option {option[:40]!r}", where=where)
        values: list[str] = []
        while len(values) < _OPTIONS[option]:
            word, _, after = rest.lstrip().partition(" ")
            if values and option in _MOVING and not _is_number(word):
                break
            values.append(word)
            rest = after
        if option in _MOVING and any(
            not _is_number(word) or float(word) != neutral
            for word, neutral in zip(values, _MOVING[option], strict=False)
        ):
            reason = f"map_Kd {option} {' '.join(values)[:40]}: pictures that are shifted or scaled are not read"
            raise FileError(path, reason, where=where)
        text = rest.lstrip()
    if not text:
        raise FileError(path, "map_Kd names no picture", where=where)
    return text


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def materials_of(path: Path, libraries: Sequence[str], *, outside_files: bool = False) -> list[Material] | None:
    """The materials of the MTL files that an OBJ names; None, with a warning, where a file is missing.

    Raises:
        FileError: An MTL file that is damaged.
    """
    found: list[Material] = []
    for library in libraries:
        place = find_beside(path, library, outside_files=outside_files)
        if place is None:
            reason = why_missing(library, outside_files=outside_files)
            warn_left_behind(path, f"the file {library!r} of its materials {reason}")
            return None
        known = {material.name for material in found}
        found += [material for material in read_mtl(place) if material.name not in known]
    return found


def pictures_of(
    path: Path, materials: list[Material], ids: NDArray[np.int64], *, outside_files: bool = False
) -> tuple[tuple[NDArray[np.uint8], ...], NDArray[np.int64]]:
    """One picture for each material that triangles have, in their order, and which of them each triangle has.

    There are none at all where no such material has a picture or a colour, or a picture is missing. Materials with one
    picture share it.

    Args:
        path: The OBJ file.
        materials: Its materials.
        ids: The material of each triangle.
        outside_files: Whether names that lead out of the folder are followed.

    Raises:
        FileError: A picture is damaged, or they are too large together.
    """
    used, numbers = np.unique(ids, return_inverse=True)
    materials = [materials[number] for number in used]
    if all(material.picture is None and material.color is None for material in materials):
        return (), numbers
    named = [material.picture for material in materials if material.picture is not None]
    pictures = iter(read_textures(path, named, outside_files=outside_files))
    found = []
    for material in materials:
        if material.picture is None:
            color = np.array(material.color or WHITE)
            found.append(np.rint(color * 255).astype(np.uint8).reshape(1, 1, 3))
        elif (picture := next(pictures, None)) is None:
            return (), numbers
        else:
            found.append(picture)
    return tuple(found), numbers


def material_name(number: int) -> str:
    """The name under which a material is written."""
    return f"material_{number}"


def mtl_of(
    path: str | os.PathLike[str], textures: Sequence[NDArray[np.uint8]]
) -> tuple[bytes, dict[str, NDArray[np.uint8]]]:
    """The text of the MTL file for these pictures, and the pictures that it names; one of a pixel is a colour.

    A picture that stands at several places is named once.
    """
    lines, named, first = [], {}, {}
    for number, (name, picture) in enumerate(zip(picture_names(path, len(textures)), textures, strict=True)):
        lines.append(f"newmtl {material_name(number)}")
        if picture.shape == (1, 1, 3):
            lines.append("Kd {:.9g} {:.9g} {:.9g}".format(*(picture[0, 0] / 255)))
        else:
            name = first.setdefault(id(picture), name)
            lines += ["Kd 1 1 1", f"map_Kd {name}"]
            named[name] = picture
    return "\n".join([*lines, ""]).encode("ascii"), named
