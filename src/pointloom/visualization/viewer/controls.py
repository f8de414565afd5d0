"""Controls that a program adds to the panel of a viewer's pages: `Control`."""

from __future__ import annotations

import dataclasses
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ...core.checks import check_callback, check_list, check_name, check_number, check_positive, shown
from .callback_queue import Calls
from .keys import check_hotkey

if TYPE_CHECKING:
    from .link import Gui, PanelEvent

DEFAULT_FOLDER, FOLDER_ORDER = "Program", 0.7  # below the point count and the active tool, above all other folders
SLIDER_STEPS = 100  # default number of slider steps
MAX_TEXT = 16_384  # characters

Check = Callable[[Any], Any]


@dataclasses.dataclass(eq=False)
class ControlState:
    """Value of a control and its handles in the pages. The first is the control itself; none after its removal."""

    value: Any
    check: Check | None
    handles: list[Any] = dataclasses.field(default_factory=list)


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

    def __init__(self, label: str, folder: str, state: ControlState, controls: Controls):
        self.label, self.folder = label, folder
        self._state, self._controls = state, controls

    def __repr__(self) -> str:
        value = "" if self._state.check is None else f", {self._state.value!r}"
        return f"Control({self.label!r}{value})"

    @property
    def value(self) -> Any:
        """Current value, assignable. None for a button.

        Raises `TypeError` for a button or a value of another type, `ValueError` for a value out of range.
        """
        return self._state.value

    @value.setter
    def value(self, value: object) -> None:
        state = self._state
        if state.check is None:
            raise TypeError(f"value: the button {self.label!r} has no value")
        state.value = state.check(value)
        if state.handles:
            state.handles[0].value = state.value

    def remove(self) -> None:
        """Remove the control from the panel. A second call has no effect."""
        self._controls.remove(self, self._state)


class Controls:
    def __init__(self, gui: Gui, calls: Calls, bind: Callable[[str, str, Callable[[int | None], None]], Any]):
        self._gui, self._calls, self._bind = gui, calls, bind
        self._lock = threading.RLock()
        self._folders: dict[str, tuple[Any, list[Control]]] = {}

    def add_button(self, label: str, callback: Any, hotkey: str | None, folder: str, hint: str) -> Control:
        if not callable(callback):
            raise TypeError(f"callback: expected a function, got {type(callback).__name__}")
        key, calls, hint = None if hotkey is None else check_hotkey(hotkey), self._calls, check_name("hint", hint)

        def make(name: str) -> Any:
            return self._gui.add_button(name if key is None else f"{name} ({key})", hint=hint)

        state = ControlState(None, None)
        control = self._add(label, folder, state, make)

        def press(client: int | None) -> None:
            if state.handles:
                calls.call(client, lambda: callback(client))

        state.handles[0].on_click(lambda event: press(event.client_id))
        if key is not None:
            state.handles.append(self._bind(key, control.label, press))
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

        def check(new: object) -> Any:
            number = check_number("value", new)
            if not first <= number <= last:
                raise ValueError(f"value: expected {first:g} to {last:g}, got {number:g}")
            return kind(round(number)) if is_integer else number

        start = check(value)
        ends = kind(first), kind(last), kind(step)
        return self._add(
            label, folder, ControlState(start, check), lambda name: self._gui.add_slider(name, *ends, start), callback
        )

    def add_checkbox(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        start = _check_flag(value)
        return self._add(
            label, folder, ControlState(start, _check_flag), lambda name: self._gui.add_checkbox(name, start), callback
        )

    def add_dropdown(self, label: str, options: Any, callback: Any, value: Any, folder: str) -> Control:
        known = tuple(check_name("options", option) for option in check_list("options", options, "strings"))
        if not known or len({*known}) != len(known):
            raise ValueError(f"options: expected at least one string, all different, got {shown(options)}")

        def check(new: Any) -> str:
            if check_name("value", new) not in known:
                raise ValueError(f"value: expected one of {', '.join(map(repr, known))}, got {new!r}")
            return new

        start = known[0] if value is None else check(value)
        return self._add(
            label, folder, ControlState(start, check), lambda name: self._gui.add_dropdown(name, known, start), callback
        )

    def add_text(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        start = _check_text(value)
        return self._add(
            label, folder, ControlState(start, _check_text), lambda name: self._gui.add_text(name, start), callback
        )

    def remove(self, control: Control, state: ControlState) -> None:
        with self._lock:
            handles, state.handles = state.handles, []
            for handle in handles:
                handle.remove()
            folder, within = self._folders.get(control.folder, (None, []))
            if control in within:
                within.remove(control)
            if folder is not None and not within:
                del self._folders[control.folder]
                folder.remove()

    def _add(
        self, label: str, folder: str, state: ControlState, make: Callable[[str], Any], callback: Any = None
    ) -> Control:
        check_callback("callback", callback)
        control = Control(_check_label("label", label), _check_label("folder", folder), state, self)
        with self._lock:
            if folder not in self._folders:
                self._folders[folder] = self._gui.add_folder(folder, order=FOLDER_ORDER), []
            folder_handle, within = self._folders[folder]
            with folder_handle:
                state.handles.append(make(label))
            within.append(control)
        if state.check is not None:
            state.handles[0].on_update(lambda event: self._apply(control, state, event, callback))
        return control

    def _apply(self, control: Control, state: ControlState, event: PanelEvent, callback: Any) -> None:
        """Store a value set by a page (validated by the link) and call the callback."""
        assert state.check is not None
        if not state.handles:  # removed
            return
        try:
            new = state.value = state.check(event.value)
        except (TypeError, ValueError):
            return
        if callback is not None:
            self._calls.call(event.client_id, lambda: callback(new), control)


def _check_flag(value: object) -> bool:
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
