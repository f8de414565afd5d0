"""The scene of all pages or of one page: `Scene` and its `Node`s."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_fraction, check_positive
from ....io.images.image_files import encode_png
from .arrays import color, immutable_rows, packed_normals, placing
from .camera import CameraState
from .delivery import Channel

ANCHORS = ("bottom-left", "bottom-center", "center")


@dataclasses.dataclass(frozen=True, eq=False)
class ClickEvent:
    """A click on page `client_id` without motion, at fractions x and y of width and height from the upper left."""

    client_id: int
    x: float
    y: float
    camera: CameraState


class Node:
    """Handle of an object in a scene: `id` and `kind` ("group", "points", "triangles", "lines" or "label").

    Calls on a removed node, or after its page was closed, have no effect.
    """

    def __init__(
        self,
        channel: Channel,
        kind: str,
        number: int,
        R: ArrayLike | None,
        t: ArrayLike | None,
        scale: float,
        visible: bool,
    ):
        self._channel, self.kind, self.id = channel, kind, number
        self._R, self._t, self._scale, self._visible = R, t, scale, visible
        self._removed = False

    def set_transform(self, R: ArrayLike | None, t: ArrayLike | None, scale: float | None = None) -> None:
        """Set rotation (3, 3), translation (3,) and scale in the parent's frame; None: identity, zero, unchanged."""
        self._scale = self._scale if scale is None else scale
        self._send({"pose": placing(R, t, self._scale)})

    @property
    def visible(self) -> bool:
        """True if the node and its children are drawn."""
        return self._visible

    @visible.setter
    def visible(self, visible: bool) -> None:
        if bool(visible) != self._visible:
            self._visible = bool(visible)
            self._send({"visible": self._visible})

    def set(self, **properties: Any) -> None:
        """Change properties with the names of the `add_...` arguments: positions, colors, size, wireframe, ..."""
        self._send(checked(self.kind, properties))

    def remove(self) -> None:
        """Remove the node and its children. A second call has no effect."""
        if not self._removed:
            self._removed = True
            self._channel.drop("drop", self.id)

    def _send(self, properties: dict[str, Any]) -> None:
        if not self._removed and properties:
            self._channel.send({"op": "set", "id": self.id, **properties})


class Placement(TypedDict, total=False):
    """Pose of a node in its parent (None: the scene): `R` (3, 3), `t` (3,), `scale`, `visible`."""

    parent: Node | None
    R: Any
    t: Any
    scale: float
    visible: bool


class Scene:
    """Objects that pages draw. Lengths are in the unit of the parent's frame.

    Read-only arrays are shared and must not change. Others are copied.
    """

    def __init__(self, channel: Channel, shared: Scene | None = None):
        self._channel, self._shared = channel, shared
        self._on_click: list[Callable[[ClickEvent], Any]] = []

    def add_group(self, **placement: Unpack[Placement]) -> Node:
        return self._add("group", {}, **placement)

    def add_points(
        self,
        positions: ArrayLike,
        colors: ArrayLike | None = None,
        *,
        plain: ArrayLike | None = None,
        normals: ArrayLike | None = None,
        size: float = 3.0,
        metric: bool = False,
        relief: bool = True,
        opacity: float = 1.0,
        **placement: Unpack[Placement],
    ) -> Node:
        """Add points: float32 or float16 positions, uint8 colors or one `plain` color, normals (float or int16 *
        32767).

        `size` is the diameter [px], or in the node's unit if `metric`; `relief` applies eye-dome lighting.
        """
        properties = {"positions": positions, "colors": colors, "plain": plain, "normals": normals, "size": size}
        properties |= {"metric": metric, "relief": relief, "opacity": opacity}
        return self._add("points", properties, **placement)

    def add_surface(
        self,
        positions: ArrayLike,
        indices: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        plain: ArrayLike | None = None,
        uvs: ArrayLike | None = None,
        texture: ArrayLike | None = None,
        lit: bool = True,
        cull: bool = False,
        wireframe: bool = False,
        opacity: float = 1.0,
        **placement: Unpack[Placement],
    ) -> Node:
        """Add triangles with vertex indices (m, 3). Colors and normals as in `add_points`; `cull` hides back faces.

        Texture coordinates are (n, 2) with v = 0 at the top row, the texture is uint8 (h, w, 3).
        """
        properties = {"positions": positions, "indices": indices, "normals": normals, "colors": colors, "plain": plain}
        properties |= {"uvs": uvs, "texture": texture, "lit": lit, "cull": cull, "wireframe": wireframe}
        return self._add("triangles", {**properties, "opacity": opacity}, **placement)

    def add_lines(
        self,
        ends: ArrayLike,
        colors: ArrayLike | None = None,
        *,
        plain: ArrayLike | None = None,
        width: float = 1.0,
        **placement: Unpack[Placement],
    ) -> Node:
        """Add segments with ends (m, 2, 3), uint8 colors of ends (m, 2, 3) or segments (m, 3), and width [px]."""
        properties = {"ends": ends, "colors": colors, "plain": plain, "width": width}
        return self._add("lines", properties, **placement)

    def add_label(self, text: str, position: ArrayLike, *, anchor: str = "center") -> Node:
        """Add a text at a position (3,) of the parent's frame; `anchor` is the corner of the text at that position."""
        return self._add("label", {"text": text, "anchor": anchor}, t=position)

    def show_shared(self, node: Node, visible: bool) -> None:
        """Show or hide a shared node in this page only, until its shared visibility changes."""
        self._channel.send({"op": "set", "id": node.id, "visible": bool(visible)})

    def on_click(self, callback: Callable[[ClickEvent], Any]) -> Callable[[ClickEvent], Any]:
        self._on_click.append(callback)
        self._channel.send({"op": "clicks", "on": True})
        return callback

    def remove_click_callback(self, callback: Callable[[ClickEvent], Any]) -> None:
        if callback in self._on_click:
            self._on_click.remove(callback)
        if not self._on_click and (self._shared is None or not self._shared.click_callbacks()):
            self._channel.send({"op": "clicks", "on": False})

    def click_callbacks(self) -> tuple[Callable[[ClickEvent], Any], ...]:
        return tuple(self._on_click)

    def _add(
        self,
        kind: str,
        properties: dict[str, Any],
        *,
        parent: Node | None = None,
        R: ArrayLike | None = None,
        t: ArrayLike | None = None,
        scale: float = 1.0,
        visible: bool = True,
    ) -> Node:
        fields = checked(kind, {name: value for name, value in properties.items() if value is not None})
        node = Node(self._channel, kind, self._channel.delivery.number(), R, t, scale, bool(visible))
        above = 0 if parent is None else parent.id
        op = {"op": "node", "id": node.id, "parent": above, "kind": kind, "pose": placing(R, t, scale)}
        self._channel.create({**op, "visible": node.visible, **fields})
        return node


def checked(kind: str, properties: dict[str, Any]) -> dict[str, Any]:
    """Validate the properties of a node. None removes colors or normals."""
    sent: dict[str, Any] = {}
    checks = _CHECKS[kind]
    for name, value in properties.items():
        if name not in checks:
            raise TypeError(f"{name}: unknown property of {kind}; expected {', '.join(checks) or 'none'}")
        field = "positions" if name == "ends" else name
        try:
            sent[field] = None if value is None and name in _OPTIONAL else checks[name](value)
        except ValueError as error:
            raise ValueError(str(error) if str(error).startswith(name) else f"{name}: {error}") from error
    return sent


def _positions(values: ArrayLike) -> NDArray[Any]:
    return immutable_rows(values, [np.float32, np.float16], 3)


def _singles(values: ArrayLike) -> NDArray[Any]:
    return immutable_rows(values, [np.float32], 3)


def _ends(values: ArrayLike) -> NDArray[Any]:
    return immutable_rows(values, [np.float32], 2, 3).reshape(-1, 3)


def _colors(values: ArrayLike) -> NDArray[np.uint8]:
    return immutable_rows(values, [np.uint8], 3)


def _end_colors(values: ArrayLike) -> NDArray[np.uint8]:
    given = np.asarray(values)
    if given.ndim == 3:
        return immutable_rows(given, [np.uint8], 2, 3).reshape(-1, 3)
    return np.repeat(_colors(given), 2, axis=0)


def _indices(values: ArrayLike) -> NDArray[Any]:
    given = np.asarray(values)
    return (
        immutable_rows(given, [np.uint32], 3)
        if given.dtype != np.int32
        else immutable_rows(given.view(np.uint32), [np.uint32], 3)
    )


def _uvs(values: ArrayLike) -> NDArray[Any]:
    return immutable_rows(values, [np.float32], 2)


def _texture(values: ArrayLike) -> NDArray[np.uint8]:
    return np.frombuffer(encode_png(np.ascontiguousarray(values, np.uint8)), np.uint8)[:, None]


def _one_of(options: tuple[str, ...]) -> Callable[[Any], str]:
    def check(value: Any) -> str:
        if value not in options:
            raise ValueError(f"expected one of {', '.join(options)}, got {value!r}")
        return value

    return check


def _plain(value: ArrayLike) -> list[int]:
    return color("plain", value)


def _size(value: object) -> float:
    return check_positive("size", value)


def _width(value: object) -> float:
    return check_positive("width", value)


def _opacity(value: object) -> float:
    return check_fraction("opacity", value)


_OPTIONAL = {"colors", "plain", "normals", "uvs", "texture"}
_CHECKS: dict[str, dict[str, Callable[[Any], Any]]] = {
    "group": {},
    "points": {
        **{"positions": _positions, "colors": _colors, "plain": _plain, "normals": packed_normals, "size": _size},
        **{"metric": bool, "relief": bool, "opacity": _opacity},
    },
    "triangles": {
        **{"positions": _singles, "indices": _indices, "normals": packed_normals, "colors": _colors, "plain": _plain},
        **{"uvs": _uvs, "texture": _texture, "lit": bool, "cull": bool, "wireframe": bool, "opacity": _opacity},
    },
    "lines": {"ends": _ends, "colors": _end_colors, "plain": _plain, "width": _width},
    "label": {"text": str, "anchor": _one_of(ANCHORS)},
}
