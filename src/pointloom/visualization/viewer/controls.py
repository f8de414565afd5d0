"""Controls that a program adds to the panel of a viewer's pages: `Control`."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from ...core.checks import check_callback, check_list, check_name, check_number, check_positive, shown
from .callback_queue import Calls
from .keys import check_hotkey

DEFAULT_FOLDER, FOLDER_ORDER = "Program", 0.7  # below the point count and the active tool, above all other folders
SLIDER_STEPS = 100  # default number of slider steps
MAX_TEXT = 16_384  # characters

Check = Callable[[Any], Any]


class Control:
    """A control in the panel, created by `viewer.add_button`, `viewer.add_slider` or another `add_...` method.

    Attributes:
        label: Label of the control.
        folder: Folder of the panel.

    Example:
        >>> import pointloom as loom
        >>> with loom.Viewer(port=0) as viewer:
        ...     size = viewer.add_slider("voxel size", 0.01, 1.0, 0.05)
        ...     size.value = 0.1
        ...     size.value, size.label
        (0.1, 'voxel size')
    """

    def __init__(self, label: str, folder: str, value: Any, check: Check | None, controls: Controls):
        self.label, self.folder = label, folder
        self._value, self._check, self._controls = value, check, controls
        self._handles: list[Any] = []  # of the link. The first is the control itself

    def __repr__(self) -> str:
        value = "" if self._check is None else f", {self._value!r}"
        return f"Control({self.label!r}{value})"

    @property
    def value(self) -> Any:
        """Current value, assignable. None for a button.

        Raises `TypeError` for a button or a value of another type, `ValueError` for a value out of range.
        """
        return self._value

    @value.setter
    def value(self, value: Any) -> None:
        if self._check is None:
            raise TypeError(f"value: the button {self.label!r} has no value")
        self._value = self._check(value)
        if self._handles:
            self._handles[0].value = self._value

    def remove(self) -> None:
        """Remove the control from the panel. A second call has no effect."""
        self._controls.remove(self)


class Controls:
    def __init__(self, gui: Any, calls: Calls, bind: Callable[[str, str, Callable[[int | None], None]], Any]):
        self._gui, self._calls, self._bind = gui, calls, bind
        self._lock = threading.RLock()
        self._folders: dict[str, tuple[Any, list[Control]]] = {}

    def add_button(self, label: str, callback: Any, hotkey: str | None, folder: str, hint: str) -> Control:
        if not callable(callback):
            raise TypeError(f"callback: expected a function, got {type(callback).__name__}")
        key, calls, hint = None if hotkey is None else check_hotkey(hotkey), self._calls, check_name("hint", hint)

        def make(name: str) -> Any:
            return self._gui.add_button(name if key is None else f"{name} ({key})", hint=hint)

        control = self._add(label, folder, None, None, make)

        def press(client: int | None) -> None:
            if control._handles:
                calls.call(client, lambda: callback(client))

        control._handles[0].on_click(lambda event: press(event.client_id))
        if key is not None:
            control._handles.append(self._bind(key, control.label, press))
        return control

    def add_slider(self, label: str, low: Any, high: Any, value: Any, callback: Any, step: Any, folder: str) -> Control:
        """Add a slider. It is integer if all given numbers are integers."""
        given = {"low": low, "high": high, "value": value} | ({} if step is None else {"step": step})
        numbers = {name: check_number(name, number) for name, number in given.items()}
        is_integer = all(isinstance(number, int) or hasattr(number, "__index__") for number in given.values())
        kind = int if is_integer else float
        first, last = numbers["low"], numbers["high"]
        if not first < last:
            raise ValueError(f"low: expected less than high, {last:g}, got {first:g}")
        step = check_positive("step", numbers.get("step", 1 if is_integer else (last - first) / SLIDER_STEPS))
        if step > last - first:
            raise ValueError(f"step: expected at most high - low, {last - first:g}, got {step:g}")

        def check(new: Any) -> Any:
            number = check_number("value", new)
            if not first <= number <= last:
                raise ValueError(f"value: expected {first:g} to {last:g}, got {number:g}")
            return kind(round(number)) if is_integer else number

        start = check(value)
        ends = kind(first), kind(last), kind(step)
        return self._add(label, folder, start, check, lambda name: self._gui.add_slider(name, *ends, start), callback)

    def add_checkbox(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        start = _check_flag(value)
        return self._add(label, folder, start, _check_flag, lambda name: self._gui.add_checkbox(name, start), callback)

    def add_dropdown(self, label: str, options: Any, callback: Any, value: Any, folder: str) -> Control:
        known = tuple(check_name("options", option) for option in check_list("options", options, "strings"))
        if not known or len({*known}) != len(known):
            raise ValueError(f"options: expected at least one string, all different, got {shown(options)}")

        def check(new: Any) -> str:
            if check_name("value", new) not in known:
                raise ValueError(f"value: expected one of {', '.join(map(repr, known))}, got {new!r}")
            return new

        start = known[0] if value is None else check(value)
        return self._add(label, folder, start, check, lambda name: self._gui.add_dropdown(name, known, start), callback)

    def add_text(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        start = _check_text(value)
        return self._add(label, folder, start, _check_text, lambda name: self._gui.add_text(name, start), callback)

    def remove(self, control: Control) -> None:
        with self._lock:
            handles, control._handles = control._handles, []
            for handle in handles:
                handle.remove()
            folder, within = self._folders.get(control.folder, (None, []))
            if control in within:
                within.remove(control)
            if folder is not None and not within:
                del self._folders[control.folder]
                folder.remove()

    def _add(
        self, label: str, folder: str, value: Any, check: Check | None, make: Callable[[str], Any], callback: Any = None
    ) -> Control:
        check_callback("callback", callback)
        control = Control(_check_label("label", label), _check_label("folder", folder), value, check, self)
        with self._lock:
            if folder not in self._folders:
                self._folders[folder] = self._gui.add_folder(folder, order=FOLDER_ORDER), []
            folder_handle, within = self._folders[folder]
            with folder_handle:
                control._handles.append(make(label))
            within.append(control)
        if check is not None:
            control._handles[0].on_update(lambda event: self._take(control, event.client_id, event.value, callback))
        return control

    def _take(self, control: Control, client: int | None, value: Any, callback: Any) -> None:
        """Store a value set by a page (validated by the link) and call the callback."""
        assert control._check is not None
        if client is None or not control._handles:  # set by the program, or removed
            return
        try:
            new = control._value = control._check(value)
        except (TypeError, ValueError):
            return
        if callback is not None:
            self._calls.call(client, lambda: callback(new), control)


def _check_flag(value: Any) -> bool:
    if not isinstance(value, bool) and type(value).__name__ not in ("bool", "bool_"):
        raise TypeError(f"value: expected True or False, got {shown(value)}")
    return bool(value)


def _check_text(value: Any) -> str:
    if len(check_name("value", value)) > MAX_TEXT:
        raise ValueError(f"value: expected at most {MAX_TEXT:,} characters, got {len(value):,}")
    return value


def _check_label(name: str, label: Any) -> str:
    if not check_name(name, label).strip():
        raise ValueError(f"{name}: expected a text that is not empty, got {label!r}")
    return label
