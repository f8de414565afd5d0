"""Handles of panel controls: `Handle` and its subclasses."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable
from typing import Any, ClassVar, Protocol

import numpy as np

from ..guard import control_value
from .delivery import Channel

Check = Callable[[Any], Any]


@dataclasses.dataclass(frozen=True, eq=False)
class PanelEvent:
    """A change of a control by page `client_id`; `value` is the new value or `UploadedFile`, None for a button."""

    client_id: int
    value: Any = None


@dataclasses.dataclass(frozen=True)
class UploadedFile:
    """A text file from a page; `name` is untrusted and must not be used as a path."""

    name: str
    text: str

    @property
    def content(self) -> bytes:
        return self.text.encode()


class Owner(Protocol):
    """The panel of handles."""

    channel: Channel

    def enter(self, folder: Folder) -> None: ...

    def leave(self) -> None: ...

    def forget(self, handle: Handle) -> None: ...

    def forget_command(self, command: Command) -> None: ...


def equal(a: object, b: object) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and a.dtype == b.dtype and np.array_equal(a, b)
    return type(a) is type(b) and a == b


class Handle:
    """A panel element. Its fields are set by assignment. Unchanged values are not sent.

    Calls after removal, or after its page was closed, have no effect.
    """

    # Fields besides `label`, `visible`, `disabled`, `hint`, `order`, with their checks.
    FIELDS: ClassVar[dict[str, Check]] = {}
    _COMMON: ClassVar[dict[str, Check]] = {
        **{"label": lambda label: None if label is None else str(label), "visible": bool, "disabled": bool},
        **{"hint": str, "order": float},
    }

    def __init__(self, gui: Owner, kind: str, fields: dict[str, Any]):
        checks = {**self._COMMON, **self.FIELDS}
        state = {name: checks[name](value) for name, value in fields.items()}
        self.__dict__.update(_gui=gui, kind=kind, id=gui.channel.delivery.number(), _state=state, _removed=False)

    @property
    def channel(self) -> Channel:
        return self._gui.channel

    def __getattr__(self, name: str) -> Any:
        state = self.__dict__.get("_state", {})
        if name in state:
            return state[name]
        raise AttributeError(f"a {self.__dict__.get('kind', 'control')} has no {name}")

    def __setattr__(self, name: str, value: object) -> None:
        check = self.FIELDS.get(name) or self._COMMON.get(name)
        if check is None:
            if name.startswith("_"):
                self.__dict__[name] = value
                return
            raise AttributeError(f"a {self.kind} has no {name}")
        self._change(name, check(value))

    def remove(self) -> None:
        """Remove the element and its children. A second call has no effect."""
        if not self._removed:
            self._gui.forget(self)

    def mark_removed(self) -> None:
        self._removed = True

    def first_op(self) -> dict[str, Any]:
        return {name: sent(value) for name, value in self._state.items()}

    def pressed(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Callbacks for a press, each with its event."""
        return []

    def apply_value(self, page: Channel, client_id: int, value: object) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Apply a value from a page. Raises ValueError if invalid. Returns the callbacks."""
        raise ValueError(f"a {self.kind} has no value that a page sets")

    def _change(self, name: str, value: object, *, but: Channel | None = None) -> None:
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


def sent(value: object) -> Any:
    """A field as sent: tuples become lists."""
    return [sent(one) for one in value] if isinstance(value, tuple) else value


class Folder(Handle):
    """A folder of the panel. As context manager, it becomes the parent of new elements."""

    FIELDS: ClassVar[dict[str, Check]] = {"open": bool}

    def __enter__(self) -> Folder:
        self._gui.enter(self)
        return self

    def __exit__(self, *_: Any) -> None:
        self._gui.leave()


class Shown(Handle):
    """A read-only control; `check` validates its value."""

    def __init__(self, gui: Owner, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        self.__dict__["FIELDS"] = checks
        super().__init__(gui, kind, fields)


class Input(Shown):
    """A control whose `value` is set by pages or the program."""

    def __init__(self, gui: Owner, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        super().__init__(gui, kind, fields, checks)
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_update(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Add a callback for changes by pages, not by the program."""
        self._callbacks.append(callback)
        return callback

    def apply_value(self, page: Channel, client_id: int, value: object) -> list[tuple[Callable[..., Any], PanelEvent]]:
        """Apply a value from a page and send it to the other pages."""
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
    def __init__(self, gui: Owner, kind: str, fields: dict[str, Any], checks: dict[str, Check]):
        self.__dict__["FIELDS"] = checks
        super().__init__(gui, kind, fields)
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_click(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        self._callbacks.append(callback)
        return callback

    def pressed(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        if self._state.get("disabled") or self.kind == "upload":
            return []
        return [(callback, PanelEvent(client_id)) for callback in self._callbacks]


class Upload(Button):
    """A button for uploading text files of up to 1 MiB."""

    on_click: Any = None

    def on_upload(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        """Add a callback for files: `event.value` is an `UploadedFile`."""
        self._callbacks.append(callback)
        return callback

    def brought(self, client_id: int, name: str, text: str) -> list[tuple[Callable[..., Any], PanelEvent]]:
        if self._state.get("disabled"):
            return []
        file = UploadedFile(name, text)
        return [(callback, PanelEvent(client_id, file)) for callback in self._callbacks]


class Tree(Handle):
    """A list of names with visibility, grouped by slashes."""

    def __init__(self, gui: Owner, fields: dict[str, Any]):
        super().__init__(gui, "tree", fields)
        self._rows: dict[str, list[Any]] = {}
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def on_update(self, callback: Callable[[PanelEvent], Any]) -> None:
        """Add a callback for changes by pages: `event.value` is the changed keys and their visibility."""
        self._callbacks.append(callback)

    @property
    def value(self) -> dict[str, bool]:
        with self.channel.delivery.lock:
            return {key: row[1] for key, row in self._rows.items()}

    def put(self, key: str, label: str, visible: bool, color: Any = None) -> None:
        row = [str(label), bool(visible), None if color is None else [int(part) for part in color]]
        with self.channel.delivery.lock:
            if self._rows.get(key) != row and not self._removed:
                self._rows[key] = row
                self._send({key: row}, {})

    def drop(self, key: str) -> None:
        with self.channel.delivery.lock:
            if self._rows.pop(key, None) is not None and not self._removed:
                self._send({}, {key: None})

    def apply_value(self, page: Channel, client_id: int, value: object) -> list[tuple[Callable[..., Any], Any]]:
        """Apply `[[key, ...], visible]` from a page. Unknown keys are ignored."""
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
        event = PanelEvent(client_id, (changed, visible))
        return [(callback, event) for callback in self._callbacks] if changed else []

    def _send(self, put: dict[str, Any], drop: dict[str, None]) -> None:
        self.channel.send({"op": "rows", "id": self.id, "put": put, "drop": drop})


class Command:
    """An action for a key or the palette, created by `Gui.add_command`."""

    kind = "command"

    def __init__(self, gui: Owner, label: str, hotkey: str | None, group: str):
        self._gui, self._removed = gui, False
        self.label, self.hotkey, self.group = label, hotkey, group
        self.id = gui.channel.delivery.number()
        self._callbacks: list[Callable[[PanelEvent], Any]] = []

    def mark_removed(self) -> None:
        self._removed = True

    def on_trigger(self, callback: Callable[[PanelEvent], Any]) -> Callable[[PanelEvent], Any]:
        self._callbacks.append(callback)
        return callback

    def triggered(self, client_id: int) -> list[tuple[Callable[..., Any], PanelEvent]]:
        return [(callback, PanelEvent(client_id)) for callback in self._callbacks]

    def remove(self) -> None:
        """Remove the key and the palette entry. A second call has no effect."""
        if not self._removed:
            self._gui.forget_command(self)


_orders = itertools.count(1)


def next_order() -> float:
    """Order of a new element: below all earlier ones."""
    return float(next(_orders)) * 1e-3 + 1000
