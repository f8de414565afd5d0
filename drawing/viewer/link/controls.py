"""Handles of what stands in the panel: `Handle` and its kinds."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from ..guard import control_value
from .delivery import Channel

if TYPE_CHECKING:
    from .gui import Gui

Check = Callable[[Any], Any]


@dataclasses.dataclass(frozen=True, eq=False)
class PanelEvent:
    """What a page did to a control.

    Attributes:
        client_id: Of which page.
        value: What it was set to, or the `UploadedFile`; None of a button.
    """

    client_id: int
    value: Any = None


@dataclasses.dataclass(frozen=True)
class UploadedFile:
    """A file that a page brings.

    Attributes:
        name: As the page says it: nothing to open a path by.
        text: What is in it.
    """

    name: str
    text: str

    @property
    def content(self) -> bytes:
        """The text in UTF-8."""
        return self.text.encode()


def equal(a: Any, b: Any) -> bool:
    """Whether two values of a field are the same, arrays as well."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and a.dtype == b.dtype and np.array_equal(a, b)
    return type(a) is type(b) and a == b


class Handle:
    """Something in the panel. Its fields are set by assignment; what is equal already is not sent.

    One that was removed, or whose page has gone, does nothing more.

    Attributes:
        id: Its number.
        kind: As the page calls it.
    """

    # Fields beside `label`, `visible`, `disabled`, `hint`, `order`, each with what checks it.
    FIELDS: ClassVar[dict[str, Check]] = {}
    _COMMON: ClassVar[dict[str, Check]] = {
        **{"label": lambda label: None if label is None else str(label), "visible": bool, "disabled": bool},
        **{"hint": str, "order": float},
    }

    def __init__(self, gui: Gui, kind: str, fields: dict[str, Any]):
        checks = {**self._COMMON, **self.FIELDS}
        state = {name: checks[name](value) for name, value in fields.items()}
        self.__dict__.update(_gui=gui, kind=kind, id=gui.channel.delivery.number(), _state=state, _removed=False)

    @property
    def channel(self) -> Channel:
        """The way to the pages."""
        return self._gui.channel

    def __getattr__(self, name: str) -> Any:
        state = self.__dict__.get("_state", {})
        if name in state:
            return state[name]
        raise AttributeError(f"a {self.__dict__.get('kind', 'control')} has no {name}")

    def __setattr__(self, name: str, value: Any) -> None:
        check = self.FIELDS.get(name) or self._COMMON.get(name)
        if check is None:
            if name.startswith("_"):
                self.__dict__[name] = value
                return
            raise AttributeError(f"a {self.kind} has no {name}")
        self._change(name, check(value))

    def remove(self) -> None:
        """Take it out of the panel, with all that lies in it; twice is no error."""
        if not self._removed:
            self._gui.forget(self)

    def first_op(self) -> dict[str, Any]:
        """The fields by which the page makes it."""
        return {name: sent(value) for name, value in self._state.items()}

    def pressed(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """The callbacks of a press by a page, each with its event."""
        return []

    def said(self, page: Channel, client_id: int, value: Any) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """What a page set it to; `ValueError` for what is no value of it."""
        raise ValueError(f"a {self.kind} has no value that a page sets")

    def _change(self, name: str, value: Any, *, but: Channel | None = None) -> None:
        with self.channel.delivery.lock:
            if equal(self._state.get(name), value):
                return
            self._state[name] = value
            if self._removed:
                return
            op = {"op": "setcontrol", "id": self.id, name: sent(value)}
            if but is None:
                self.channel.send(op)
            else:
                self.channel.send_but_to(but, op)


def sent(value: Any) -> Any:
    """A field as it is sent: tuples are lists there."""
    return [sent(one) for one in value] if isinstance(value, tuple) else value


class Folder(Handle):
    """A part of the panel; a context manager: what is added within lies in it."""

    FIELDS: ClassVar[dict[str, Check]] = {"open": bool}

    def __enter__(self) -> Folder:
        self._gui.enter(self)
        return self

    def __exit__(self, *_: Any) -> None:
        self._gui.leave()


class Shown(Handle):
    """A control that shows something and is not set by pages; its value is of a kind that `check` knows."""

    def __init__(self, gui: Gui, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        self.__dict__["FIELDS"] = checks
        super().__init__(gui, kind, fields)


class Input(Shown):
    """A control whose value pages set.

    Attributes:
        value: As the program or a page set it last.
    """

    def __init__(self, gui: Gui, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        super().__init__(gui, kind, fields, checks)
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_update(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Call back when a page has set the value; not when the program does."""
        self._callbacks.append(callback)
        return callback

    def said(self, page: Channel, client_id: int, value: Any) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Take what a page says, show it to the others."""
        with self.channel.delivery.lock:
            low, high = self._limits()
            new = control_value(value, self._state["value"], low=low, high=high, options=self._state.get("options"))
            if self.kind == "range" and new[0] > new[1]:
                raise ValueError(f"expected [low, high], got {value!r:.80}")
            self._change("value", new, but=page if sent(new) == value else None)
        return [(callback, PanelEvent(client_id, new)) for callback in self._callbacks]

    def _limits(self) -> tuple[Any, Any]:
        if self.kind == "rgb":
            return 0, 255
        return self._state.get("min"), self._state.get("max")


class Button(Handle):
    """Something to press."""

    def __init__(self, gui: Gui, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        self.__dict__["FIELDS"] = checks
        super().__init__(gui, kind, fields)
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_click(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Call back when a page has pressed it."""
        self._callbacks.append(callback)
        return callback

    def pressed(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Take a press."""
        if self._state.get("disabled") or self.kind == "upload":
            return []
        return [(callback, PanelEvent(client_id)) for callback in self._callbacks]


class Upload(Button):
    """A button by which pages bring text files of up to 1 MiB."""

    on_click: Any = None

    def on_upload(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Call back with each file: `event.value` is an `UploadedFile`."""
        self._callbacks.append(callback)
        return callback

    def brought(self, client_id: int, name: str, text: str) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Take a file."""
        if self._state.get("disabled"):
            return []
        file = UploadedFile(name, text)
        return [(callback, PanelEvent(client_id, file)) for callback in self._callbacks]


class Tree(Handle):
    """A list of names that are shown or hidden, grouped by the slashes in them."""

    def __init__(self, gui: Gui, fields: dict[str, Any], on_change: Callable[[int, tuple[str, ...], bool], Any] | None):
        super().__init__(gui, "tree", fields)
        self._rows: dict[str, list[Any]] = {}
        self._on_change = on_change

    @property
    def value(self) -> dict[str, bool]:
        """Which keys are shown."""
        with self.channel.delivery.lock:
            return {key: row[1] for key, row in self._rows.items()}

    def put(self, key: str, label: str, visible: bool, color: Any = None) -> None:
        """Add a row, or change one."""
        row = [str(label), bool(visible), None if color is None else [int(part) for part in color]]
        with self.channel.delivery.lock:
            if self._rows.get(key) != row and not self._removed:
                self._rows[key] = row
                self._send({key: row}, {})

    def drop(self, key: str) -> None:
        """Take a row out; one that is not there is no error."""
        with self.channel.delivery.lock:
            if self._rows.pop(key, None) is not None and not self._removed:
                self._send({}, {key: None})

    def said(self, page: Channel, client_id: int, value: Any) -> list[tuple[Callable[..., Any], Any]]:
        """A page shows or hides rows: `[[key, ...], visible]`; keys that went meanwhile are passed over."""
        if not isinstance(value, list) or len(value) != 2 or not isinstance(value[1], bool):
            raise ValueError(f"expected [[key, ...], visible], got {value!r:.80}")
        keys, visible = value
        if not isinstance(keys, list) or not all(isinstance(key, str) for key in keys):
            raise ValueError(f"expected [[key, ...], visible], got {value!r:.80}")
        with self.channel.delivery.lock:
            changed = tuple(dict.fromkeys(key for key in keys if key in self._rows))
            for key in changed:
                self._rows[key] = [self._rows[key][0], visible, self._rows[key][2]]
            if changed:
                rows = {key: self._rows[key] for key in changed}
                self.channel.send_but_to(page, {"op": "rows", "id": self.id, "put": rows, "drop": {}})
        return [(self._tell, PanelEvent(client_id, (changed, visible)))] if changed else []

    def _tell(self, event: PanelEvent) -> None:
        if self._on_change is not None:
            self._on_change(event.client_id, *event.value)

    def _send(self, put: dict[str, Any], drop: dict[str, None]) -> None:
        self.channel.send({"op": "rows", "id": self.id, "put": put, "drop": drop})


class Command:
    """What a key or the palette starts; `Gui.add_command` makes it."""

    kind = "command"

    def __init__(self, gui: Gui, label: str, hotkey: str | None, group: str):
        self._gui, self._removed = gui, False
        self.label, self.hotkey, self.group = label, hotkey, group
        self.id = gui.channel.delivery.number()
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_trigger(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Call back when a page has started it."""
        self._callbacks.append(callback)
        return callback

    def triggered(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Take that a page started it."""
        return [(callback, PanelEvent(client_id)) for callback in self._callbacks]

    def remove(self) -> None:
        """Take it out of keys and palette; twice is no error."""
        if not self._removed:
            self._gui.forget_command(self)


_orders = itertools.count(1)


def next_order() -> float:
    """The place of what is added without one: below all that was added before."""
    return float(next(_orders)) * 1e-3 + 1000
