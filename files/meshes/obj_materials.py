"""MTL, the materials of an OBJ file: names with the color Kd and the image map_Kd, in any case. All else is skipped.

A material with an image is that image, whatever its Kd; one with a color alone is an image of one pixel; one without
both is white. So a mesh has one image a material. The alpha of an image is kept if the material has a map_d or a d
below 1, and dropped otherwise; another image of map_d is left behind. The options -s and -o of map_Kd scale and shift
the texture coordinates.

A fault of a material never refuses the mesh. One warning lists the faults: colors that are no numbers (left behind) or
outside 0..1 (clamped), options that are not read, lines before any newmtl and names that are defined twice (the first
counts).

Source: Wavefront, "MTL material format" (1995).
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.escaped_text import escaped
from ..pictures.texture_files import (
    alpha_mode,
    drop_alpha,
    find_beside,
    picture_names,
    read_textures,
    warn_left_behind,
    why_missing,
)
from ..source import open_source

# How many words follow each option of a map, at most; those of _MOVING are fewer if a word is no number.
_OPTIONS = {
    "-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-texres": 1, "-imfchan": 1, "-bm": 1, "-boost": 1,
    "-type": 1, "-mm": 2, "-o": 3, "-s": 3, "-t": 3,
}  # fmt: skip
_MOVING = {"-mm": (0.0, 1.0), "-o": (0.0,) * 3, "-s": (1.0,) * 3, "-t": (0.0,) * 3}
_MAX_NOTES = 5

WHITE = (1.0, 1.0, 1.0)


@dataclass
class Material:
    """A material of an MTL file.

    Attributes:
        name: As in the file.
        picture: The name of its image, or None.
        color: Red, green and blue in 0..1, or None.
        opacity: The name of the image of its map_d, with options, or None.
        is_opaque: True if it has no map_d and no d below 1.
        scale, offset: What its texture coordinates u and v are multiplied by, and what is added then.
    """

    name: str
    picture: str | None = None
    color: tuple[float, ...] | None = None
    opacity: str | None = None
    is_opaque: bool = True
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


def read_mtl(path: str | os.PathLike[str]) -> list[Material]:
    """Read the materials of an MTL file, in its order.

    Raises:
        FileError: The file cannot be read.

    Warns:
        UserWarning: Faults of materials, which are left behind or clamped.
    """
    text = bytes(open_source(path)[:]).decode("utf-8", "surrogateescape").removeprefix("\ufeff")
    found: dict[str, Material] = {}
    notes: list[str] = []
    current: Material | None = None
    for number, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.strip().replace("\t", " ").partition(" ")
        kind, rest, note = kind.lower(), rest.strip(), ""
        if kind == "newmtl":
            current = Material(rest)
            if rest in found:
                note = f"the material {rest[:60]!r} is defined twice"
            found.setdefault(rest, current)
        elif kind in ("kd", "map_kd", "d", "map_d"):
            note = f"{kind} comes before any newmtl" if current is None else _take(current, kind, rest)
        if note:
            notes.append(f"line {number}: {note}")
    for material in found.values():
        if material.opacity is not None and not material.opacity.endswith(material.picture or "\0"):
            notes.append(f"the opacity map {material.opacity[:60]!r} of {material.name[:60]!r} is left behind")
    if notes:
        more = f"; and {len(notes) - _MAX_NOTES} more" if len(notes) > _MAX_NOTES else ""
        warnings.warn(escaped(f"{path}: {'; '.join(notes[:_MAX_NOTES])}{more}"), UserWarning, stacklevel=5)
    return [*found.values()]


def _take(material: Material, kind: str, rest: str) -> str:
    """Give a material the value of a statement; what of it is left behind, empty if nothing is."""
    if kind == "map_kd":
        return _take_map(material, rest)
    if kind == "map_d":
        material.opacity, material.is_opaque = rest, False
        return ""
    words = rest.partition("#")[0].split()
    values = [float(word) for word in words if _is_number(word)]
    if kind == "d":
        material.is_opaque = material.is_opaque and not (values and values[-1] < 1)
        return ""
    if len(values) != len(words) or len(values) not in (1, 3) or not np.isfinite(values).all():
        return f"Kd: expected three numbers in 0..1, got {rest[:60]!r}; it is left behind"
    material.color = tuple(min(max(value, 0.0), 1.0) for value in values) * (3 // len(values))  # one number is gray
    return "" if all(0 <= value <= 1 for value in values) else f"Kd {rest[:60]} is clamped to 0..1"


def _take_map(material: Material, text: str) -> str:
    """Take the name of an image and the options before it; what of them is left behind, empty if nothing is."""
    lost = []
    while text.startswith("-"):
        option, _, rest = text.partition(" ")
        if option not in _OPTIONS:
            lost.append(f"the unknown option {option[:40]!r} of map_Kd")
            text = rest.rpartition(" ")[2]  # how many values it has is not known; names with blanks are rare
            break
        values: list[str] = []
        while len(values) < _OPTIONS[option]:
            word, _, after = rest.lstrip().partition(" ")
            if option in _MOVING and not _is_number(word):
                break
            values.append(word)
            rest = after
        if option in _MOVING:
            numbers = [*map(float, values), *_MOVING[option][len(values) :]]
            if option in ("-s", "-o") and np.isfinite(numbers).all():
                setattr(material, "scale" if option == "-s" else "offset", (numbers[0], numbers[1]))
            elif tuple(numbers) != _MOVING[option]:
                lost.append(f"the option {option} of map_Kd")
        text = rest.lstrip()
    material.picture = text or None
    if not text:
        lost.append("map_Kd, which names no image")
    return f"{', '.join(lost)} is left behind" if lost else ""


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def materials_of(path: Path, libraries: Sequence[str], *, outside_files: bool = False) -> list[Material] | None:
    """The materials of the MTL files that an OBJ names; None, with a warning, where a file is missing.

    Raises:
        FileError: An MTL file that cannot be read.
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

    There are none at all where no such material has a picture or a color, or, with a warning, where a picture is
    missing or damaged. Materials with one picture share it.

    Args:
        path: The OBJ file.
        materials: Its materials.
        ids: The material of each triangle.
        outside_files: Whether names that lead out of the folder are followed.

    """
    used, numbers = np.unique(ids, return_inverse=True)
    materials = [materials[number] for number in used]
    if all(material.picture is None and material.color is None for material in materials):
        return (), numbers
    named = [material.picture for material in materials if material.picture is not None]
    opaque: dict[int, NDArray[np.uint8]] = {}
    pictures = iter(read_textures(path, named, outside_files=outside_files))
    found = []
    for material in materials:
        if material.picture is None:
            color = np.array(material.color or WHITE)
            found.append(np.rint(color * 255).astype(np.uint8).reshape(1, 1, 3))
            continue
        picture = next(pictures, None)
        if picture is None:
            return (), numbers
        if material.is_opaque and picture.shape[2] == 4:
            if id(picture) not in opaque:
                opaque[id(picture)] = drop_alpha(picture)
            picture = opaque[id(picture)]
        found.append(picture)
    return tuple(found), numbers


def move_uvs(uvs: NDArray[np.float32], materials: list[Material], ids: NDArray[np.int64]) -> NDArray[np.float32]:
    """Texture coordinates of corners, float32 [3 t, 2], scaled and shifted by the material of each triangle."""
    scale = np.array([material.scale for material in materials])
    offset = np.array([material.offset for material in materials])
    if (scale == 1).all() and (offset == 0).all():
        return uvs
    corners = np.repeat(ids, 3)
    with quiet():
        return (uvs * scale[corners] + offset[corners]).astype(np.float32)


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
            if alpha_mode(picture) != "OPAQUE":
                lines.append(f"map_d {name}")
            named[name] = picture
    return "\n".join([*lines, ""]).encode("ascii"), named
