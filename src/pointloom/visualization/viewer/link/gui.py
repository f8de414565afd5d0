"""The panel of all pages or of one: `Gui`."""

from __future__ import annotations

import threading
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....core.checks import check_number
from .arrays import color, immutable_rows
from .controls import Button, Check, Command, Folder, Handle, Input, Shown, Tree, Upload, next_order
from .delivery import Channel


class Gui:
    """Controls of the panel. All `add_*` methods also take `order`, `visible`, `disabled` and `hint`.

    Values in the shared panel are synchronized between pages. The panel of one page is its own.
    """

    def __init__(self, channel: Channel):
        self.channel = channel
        self._handles: dict[int, Handle | Command] = {}
        self._within = threading.local()

    def add_folder(
        self, label: str | None, *, order: float | None = None, open: bool = True, visible: bool = True
    ) -> Folder:
        """Add a folder, used as a context manager. Without a label only its content is visible."""
        return self._add(Folder(self, "folder", _fields(label, {"open": open, "visible": visible}, order=order)))

    def add_button(self, label: str, *, color: str | None = None, **common: Any) -> Button:
        """Add a button; `color` is a CSS color."""
        checks: dict[str, Check] = {"color": _text_or_none}
        return self._add(Button(self, "button", _fields(label, {"color": color}, **common), checks))

    def add_checkbox(self, label: str, value: bool, **common: Any) -> Input:
        return self._input("checkbox", label, {"value": value}, {"value": bool}, common)

    def add_slider(self, label: str, min: float, max: float, step: float, value: float, **common: Any) -> Input:
        return self._input("slider", label, {"min": min, "max": max, "step": step, "value": value}, _SCALE, common)

    def add_range(
        self, label: str, min: float, max: float, step: float, value: tuple[float, float], **common: Any
    ) -> Input:
        fields = {"min": min, "max": max, "step": step, "value": value}
        return self._input("range", label, fields, {**_SCALE, "value": _pair}, common)

    def add_number(
        self,
        label: str,
        value: float,
        *,
        step: float | None = None,
        precision: int | None = None,
        min: float | None = None,
        max: float | None = None,
        **common: Any,
    ) -> Input:
        """Add a number field. Integers stay integers."""
        fields = {"step": step, "precision": precision, "min": min, "max": max, "value": value}
        checks = {**dict.fromkeys(fields, _number_or_none), "value": _number_as_it_is}
        return self._input("number", label, fields, checks, common)

    def add_text(self, label: str, value: str, **common: Any) -> Input:
        return self._input("text", label, {"value": value}, {"value": str}, common)

    def add_dropdown(self, label: str, options: Sequence[str], value: str | None = None, **common: Any) -> Input:
        """Add a dropdown list. The default is the first option."""
        words = _words(options)
        fields = {"options": words, "value": words[0] if value is None else value}
        return self._input("dropdown", label, fields, {"options": _words, "value": str}, common)

    def add_rgb(self, label: str, value: ArrayLike, **common: Any) -> Input:
        """Add a color field, 0 to 255."""
        return self._input("rgb", label, {"value": value}, {"value": _rgb}, common)

    def add_words(self, text: str, **common: Any) -> Shown:
        """Add plain text with line breaks. Its `value` is assignable."""
        return self._shown("words", None, {"value": text}, {"value": str}, common)

    def add_table(self, rows: Mapping[str, str] | Iterable[tuple[str, str]], **common: Any) -> Shown:
        """Add rows of label and text, as a mapping or pairs."""
        return self._shown("table", None, {"value": rows}, {"value": _rows}, common)

    def add_upload_button(self, label: str, accept: str = "application/json", **common: Any) -> Upload:
        """Add a button for uploading a text file of up to 1 MiB; `accept` as in HTML."""
        return self._add(Upload(self, "upload", _fields(label, {"accept": accept}, **common), {"accept": str}))

    def add_colorbar(self, title: str, ticks: Iterable[tuple[float, str]], colors: ArrayLike, **common: Any) -> Shown:
        """Add a color bar beside the image: ticks are pairs of a fraction and a text, colors uint8 (256, 3)."""
        fields = {"title": title, "ticks": ticks, "colors": colors}
        return self._shown("colorbar", None, fields, {"title": str, "ticks": _ticks, "colors": _ramp}, common)

    def add_legend(self, entries: Iterable[tuple[str, ArrayLike, str]], **common: Any) -> Shown:
        """Add a legend: rows of label, color (0 to 255) and text."""
        return self._shown("legend", None, {"entries": entries}, {"entries": _entries}, common)

    def add_tree(self, **common: Any) -> Tree:
        """Add a tree of names with visibility."""
        return self._add(Tree(self, _fields(None, {}, **common)))

    def add_timeline(self, min: float, max: float, step: float, value: float, **common: Any) -> Input:
        """Add a timeline with playback at the bottom; `playing` is assignable."""
        fields = {"min": min, "max": max, "step": step, "value": value, "playing": False}
        return self._input("timeline", None, fields, {**_SCALE, "playing": bool}, common)

    def add_command(self, label: str, hotkey: str | None = None, *, group: str = "") -> Command:
        """Add an action for a key and the palette: `hotkey` is a letter or a name such as "escape"."""
        command = Command(self, str(label), hotkey, str(group))
        with self.channel.delivery.lock:
            self._handles[command.id] = command
            op = {"op": "command", "id": command.id, "label": command.label, "hotkey": hotkey, "group": command.group}
            self.channel.send(op)
        return command

    def enter(self, folder: Folder) -> None:
        """Make a folder the parent of this thread's new controls."""
        self._folders().append(folder)

    def leave(self) -> None:
        self._folders().pop()

    def forget(self, handle: Handle) -> None:
        """Remove a control and its children."""
        with self.channel.delivery.lock:
            for number in self.channel.drop("dropcontrol", handle.id):
                gone: Any = self._handles.pop(number, None)
                if gone is not None:
                    gone.mark_removed()

    def forget_command(self, command: Command) -> None:
        with self.channel.delivery.lock:
            command.mark_removed()
            self._handles.pop(command.id, None)
            self.channel.drop("dropcommand", command.id)

    def find(self, number: int) -> Any:
        return self._handles.get(number)

    def _folders(self) -> list[Folder]:
        if not hasattr(self._within, "folders"):
            self._within.folders = []
        return self._within.folders

    def _add(self, handle: Any) -> Any:
        folders = self._folders()
        parent = folders[-1].id if folders else 0
        with self.channel.delivery.lock:
            self._handles[handle.id] = handle
            op = {"op": "control", "id": handle.id, "parent": parent, "kind": handle.kind}
            self.channel.create({**op, **handle.first_op()})
        return handle

    def _input(
        self, kind: str, label: str | None, fields: dict[str, Any], checks: dict[str, Check], common: Any
    ) -> Input:
        return self._add(Input(self, kind, _fields(label, fields, **common), checks))

    def _shown(
        self, kind: str, label: str | None, fields: dict[str, Any], checks: dict[str, Check], common: Any
    ) -> Shown:
        return self._add(Shown(self, kind, _fields(label, fields, **common), checks))


def _fields(
    label: str | None,
    own: dict[str, Any],
    *,
    order: float | None = None,
    visible: bool = True,
    disabled: bool = False,
    hint: str = "",
) -> dict[str, Any]:
    order = next_order() if order is None else order
    return {"label": label, "order": order, "visible": visible, "disabled": disabled, "hint": hint, **own}


def _text_or_none(value: object) -> str | None:
    return None if value is None else str(value)


def _words(options: Sequence[str]) -> tuple[str, ...]:
    words = tuple(str(one) for one in options)
    if not words:
        raise ValueError("options: expected at least one")
    return words


def _number(value: object) -> float:
    return check_number("number", value)


def _number_or_none(value: object) -> Any:
    return None if value is None else _number_as_it_is(value)


def _number_as_it_is(value: object) -> Any:
    return int(value) if isinstance(value, int | np.integer) and not isinstance(value, bool) else _number(value)


def _pair(value: Any) -> tuple[float, float]:
    low, high = map(_number, value)
    if low > high:
        raise ValueError(f"expected (low, high), got {value!r}")
    return low, high


def _rgb(value: ArrayLike) -> tuple[int, ...]:
    return tuple(color("color", value))


def _rows(rows: Any) -> tuple[tuple[str, str], ...]:
    return tuple((str(label), str(text)) for label, text in (rows.items() if isinstance(rows, Mapping) else rows))


def _ticks(ticks: Any) -> tuple[tuple[float, str], ...]:
    return tuple((_number(fraction), str(text)) for fraction, text in ticks)


def _entries(entries: Any) -> tuple[tuple[str, tuple[int, ...], str], ...]:
    return tuple((str(label), _rgb(rgb), str(text)) for label, rgb, text in entries)


def _ramp(colors: ArrayLike | None) -> Any:
    return None if colors is None else immutable_rows(colors, [np.uint8], 3)


_SCALE: dict[str, Check] = {"min": _number, "max": _number, "step": _number, "value": _number}
