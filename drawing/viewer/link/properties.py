"""What nodes are made of, as it is sent: `checked`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_positive, check_share
from ....files.pictures.image_files import encode_png
from .arrays import color, kept, normals_kept

SHAPES = ("box", "ball", "frustum")
ANCHORS = ("bottom-left", "bottom-center", "center")


def checked(kind: str, properties: dict[str, Any]) -> dict[str, Any]:
    """Properties of a node of a kind, as they are sent; None takes colours or normals away.

    Raises:
        ValueError: one of another shape, or beyond its bounds.
        TypeError: one that the kind does not have.
    """
    sent: dict[str, Any] = {}
    checks = _CHECKS[kind]
    for name, value in properties.items():
        if name not in checks:
            raise TypeError(f"{name}: {kind} have no such property; there are {', '.join(checks) or 'none'}")
        field = "positions" if name == "ends" else name
        try:
            sent[field] = None if value is None and name in _OPTIONAL else checks[name](value)
        except ValueError as error:
            raise ValueError(str(error) if str(error).startswith(name) else f"{name}: {error}") from error
    return sent


def _positions(values: Any) -> NDArray[Any]:
    return kept(values, [np.float32, np.float16], 3)


def _singles(values: Any) -> NDArray[Any]:
    return kept(values, [np.float32], 3)


def _ends(values: Any) -> NDArray[Any]:
    return kept(values, [np.float32], 2, 3).reshape(-1, 3)


def _colors(values: Any) -> NDArray[np.uint8]:
    return kept(values, [np.uint8], 3)


def _end_colors(values: Any) -> NDArray[np.uint8]:
    given = np.asarray(values)
    if given.ndim == 3:
        return kept(given, [np.uint8], 2, 3).reshape(-1, 3)
    return np.repeat(_colors(given), 2, axis=0)


def _indices(values: Any) -> NDArray[Any]:
    given = np.asarray(values)
    return kept(given, [np.uint32], 3) if given.dtype != np.int32 else kept(given.view(np.uint32), [np.uint32], 3)


def _uvs(values: Any) -> NDArray[Any]:
    return kept(values, [np.float32], 2)


def _poses(values: Any) -> NDArray[Any]:
    return kept(values, [np.float32], 3, 4).reshape(-1, 12)


def _texture(values: Any) -> NDArray[np.uint8]:
    return np.frombuffer(encode_png(np.ascontiguousarray(values, np.uint8)), np.uint8)[:, None]


def _one_of(options: tuple[str, ...]) -> Callable[[Any], str]:
    def check(value: Any) -> str:
        if value not in options:
            raise ValueError(f"expected one of {', '.join(options)}, got {value!r}")
        return value

    return check


def _plain(value: Any) -> list[int]:
    return color("plain", value)


def _size(value: Any) -> float:
    return check_positive("size", value)


def _width(value: Any) -> float:
    return check_positive("width", value)


def _opacity(value: Any) -> float:
    return check_share("opacity", value)


_OPTIONAL = {"colors", "plain", "normals", "uvs", "texture"}
_CHECKS: dict[str, dict[str, Callable[[Any], Any]]] = {
    "group": {},
    "points": {
        **{"positions": _positions, "colors": _colors, "plain": _plain, "normals": normals_kept, "size": _size},
        **{"metric": bool, "relief": bool, "opacity": _opacity},
    },
    "triangles": {
        **{"positions": _singles, "indices": _indices, "normals": normals_kept, "colors": _colors, "plain": _plain},
        **{"uvs": _uvs, "texture": _texture, "lit": bool, "cull": bool, "wireframe": bool, "opacity": _opacity},
    },
    "lines": {"ends": _ends, "colors": _end_colors, "plain": _plain, "width": _width},
    "label": {"text": str, "anchor": _one_of(ANCHORS)},
    "instances": {
        **{"shape": _one_of(SHAPES), "poses": _poses, "colors": _colors, "plain": _plain},
        **{"solid": bool, "width": _width},
    },
}
