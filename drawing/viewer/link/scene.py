"""The scene of all pages or of one: `Scene`, and what stands in it, `Node`."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_positive, check_share
from ....files.pictures.image_files import encode_png
from .arrays import color, kept, normals_kept, placing
from .camera import CameraState
from .delivery import Channel

ANCHORS = ("bottom-left", "bottom-center", "center")


@dataclasses.dataclass(frozen=True, eq=False)
class ClickEvent:
    """A press on the picture without motion.

    Attributes:
        client_id: Of which page.
        x: Share of the picture's width, from its left.
        y: Share of its height, from its top.
        camera: As it was with the click.
    """

    client_id: int
    x: float
    y: float
    camera: CameraState


class Node:
    """Something in a scene; handles of scenes make it. What is removed, or whose page has gone, does nothing more.

    Attributes:
        id: Its number.
        kind: "group", "points", "triangles", "lines" or "label".
    """

    def __init__(self, channel: Channel, kind: str, number: int, R: Any, t: Any, scale: float, visible: bool):
        self._channel, self.kind, self.id = channel, kind, number
        self._R, self._t, self._scale, self._visible = R, t, scale, visible
        self._removed = False

    def place(self, R: Any, t: Any, scale: float | None = None) -> None:
        """Move it.

        Args:
            R: Rotation to its parent's frame, shape [3, 3]; None for none.
            t: Where its origin stands there, shape [3]; None for its parent's.
            scale: Of its own unit; None leaves it.
        """
        self._scale = self._scale if scale is None else scale
        self._send({"pose": placing(R, t, self._scale)})

    @property
    def visible(self) -> bool:
        """Whether it, and what hangs on it, is drawn."""
        return self._visible

    @visible.setter
    def visible(self, visible: bool) -> None:
        if bool(visible) != self._visible:
            self._visible = bool(visible)
            self._send({"visible": self._visible})

    def set(self, **properties: Any) -> None:
        """Change some of what it was added with, by the same names: positions, colors, size, wireframe, ..."""
        self._send(checked(self.kind, properties))

    def remove(self) -> None:
        """Take it out, with all that hangs on it; twice is no error."""
        if not self._removed:
            self._removed = True
            self._channel.drop("drop", self.id)

    def _send(self, properties: dict[str, Any]) -> None:
        if not self._removed and properties:
            self._channel.send({"op": "set", "id": self.id, **properties})


class Placement(TypedDict, total=False):
    """Where a node stands.

    Attributes:
        parent: What it hangs on; None for the scene.
        R: Rotation to the parent's frame [3, 3]; None for none.
        t: Where its origin stands there [3]; None for the parent's.
        scale: Of its unit, 1 if not given.
        visible: Whether it is drawn, as it is if not given.
    """

    parent: Node | None
    R: Any
    t: Any
    scale: float
    visible: bool


class Scene:
    """What pages draw. All lengths are in the unit of the parent's frame; with no parent, of the page.

    Arrays that are read-only are kept as they are and must not change; others are copied.

    Args:
        channel: The way to the pages.
        shared: The scene of all pages, for that of one.
    """

    def __init__(self, channel: Channel, shared: Scene | None = None):
        self._channel, self._shared = channel, shared
        self._on_click: list[Callable[[ClickEvent], Any]] = []

    def add_group(self, **placed: Unpack[Placement]) -> Node:
        """A frame that others hang on."""
        return self._add("group", {}, **placed)

    def add_points(
        self,
        positions: Any,
        colors: Any = None,
        *,
        plain: Any = None,
        normals: Any = None,
        size: float = 3.0,
        metric: bool = False,
        relief: bool = True,
        opacity: float = 1.0,
        **placed: Unpack[Placement],
    ) -> Node:
        """Points.

        Args:
            positions: float32 or float16 [n, 3].
            colors: uint8 [n, 3].
            plain: One colour for all, 0 to 255 [3], where there are no `colors`.
            normals: Unit [n, 3], or int16 with 32767 for 1.
            size: Diameter [px], or with `metric` in the node's unit.
            metric: See `size`.
            relief: Whether eye-dome light falls on them.
            opacity: 0 to 1.
            placed: Where they stand, as `Placement` has it.
        """
        properties = {"positions": positions, "colors": colors, "plain": plain, "normals": normals, "size": size}
        properties |= {"metric": metric, "relief": relief, "opacity": opacity}
        return self._add("points", properties, **placed)

    def add_surface(
        self,
        positions: Any,
        indices: Any,
        *,
        normals: Any = None,
        colors: Any = None,
        plain: Any = None,
        uvs: Any = None,
        texture: Any = None,
        lit: bool = True,
        cull: bool = False,
        wireframe: bool = False,
        opacity: float = 1.0,
        **placed: Unpack[Placement],
    ) -> Node:
        """Triangles.

        Args:
            positions: float32 [n, 3].
            indices: Whole numbers of positions [m, 3].
            normals: Unit [n, 3], or int16 with 32767 for 1.
            colors: uint8 [n, 3].
            plain: One colour for all, 0 to 255 [3].
            uvs: Places in the texture [n, 2]; v = 0 is its top row.
            texture: uint8 [h, w, 3].
            lit: Whether light falls on them.
            cull: Whether back faces are left out.
            wireframe: Whether their edges are drawn over them.
            opacity: 0 to 1.
            placed: Where they stand, as `Placement` has it.
        """
        properties = {"positions": positions, "indices": indices, "normals": normals, "colors": colors, "plain": plain}
        properties |= {"uvs": uvs, "texture": texture, "lit": lit, "cull": cull, "wireframe": wireframe}
        return self._add("triangles", {**properties, "opacity": opacity}, **placed)

    def add_lines(
        self, ends: Any, colors: Any = None, *, plain: Any = None, width: float = 1.0, **placed: Unpack[Placement]
    ) -> Node:
        """Lines.

        Args:
            ends: Both ends of each [m, 2, 3].
            colors: uint8, of each end [m, 2, 3] or of each line [m, 3].
            plain: One colour for all, 0 to 255 [3].
            width: [px].
            placed: Where they stand, as `Placement` has it.
        """
        properties = {"ends": ends, "colors": colors, "plain": plain, "width": width}
        return self._add("lines", properties, **placed)

    def add_label(
        self, text: str, position: Any, *, anchor: str = "center", parent: Node | None = None, visible: bool = True
    ) -> Node:
        """Words at a place of the parent's frame [3]; `anchor` says which of their corners stands there."""
        return self._add("label", {"text": text, "anchor": anchor}, parent=parent, t=position, visible=visible)

    def show_shared(self, node: Node, visible: bool) -> None:
        """Show or hide in this page alone what the scene of all pages holds, until that says otherwise."""
        self._channel.send({"op": "set", "id": node.id, "visible": bool(visible)})

    def on_click(self, callback: Callable[[ClickEvent], Any]) -> Callable[[ClickEvent], Any]:
        """Call back with each click on the picture; pages tell of them from now on."""
        self._on_click.append(callback)
        self._channel.send({"op": "clicks", "on": True})
        return callback

    def remove_click_callback(self, callback: Callable[[ClickEvent], Any]) -> None:
        """Call this one back no more."""
        if callback in self._on_click:
            self._on_click.remove(callback)
        if not self._on_click and (self._shared is None or not self._shared.click_callbacks()):
            self._channel.send({"op": "clicks", "on": False})

    def click_callbacks(self) -> tuple[Callable[[ClickEvent], Any], ...]:
        """Who is called."""
        return tuple(self._on_click)

    def _add(
        self,
        kind: str,
        properties: dict[str, Any],
        *,
        parent: Node | None = None,
        R: Any = None,
        t: Any = None,
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
}
