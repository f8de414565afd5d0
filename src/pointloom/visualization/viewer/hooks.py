"""Callbacks and controls that a program adds to the viewer's pages."""

from __future__ import annotations

import dataclasses
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ...core.checks import check_callback, check_list, check_name, check_number, check_positive, shown
from .callback_queue import Calls, HookPages
from .items import Item
from .keys import check_hotkey
from .live_timeline import HISTORY_BYTES, LiveTimeline
from .tools.picking import Pick

if TYPE_CHECKING:
    from .link import ClickEvent
    from .viewer import Viewer


FOLDER, ORDER = "Program", 0.7  # below the point count and the active tool, above all other folders
STEPS = 100  # default number of slider steps
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
        step = check_positive("step", numbers.get("step", 1 if is_integer else (last - first) / STEPS))
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
                self._folders[folder] = self._gui.add_folder(folder, order=ORDER), []
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


FASTEST = 240.0  # [Hz] maximum rate of frame callbacks


class Hooks:
    """Callbacks and controls of a viewer.

    Callbacks run one after the other in a thread of the viewer and may call every method of it, including `close`. An
    exception of a callback is displayed in the page that caused the call and logged to `pointloom.viewer`.
    """

    timeline: LiveTimeline | None = None  # set by `set_time`
    history_bytes = HISTORY_BYTES
    _calls_made: Calls | None = None
    _controls_made: Controls | None = None
    _picks_made: Picks | None = None

    @property
    def items(self) -> Mapping[str, Item]:
        """Geometries of the scene by name. Always the newest state, also if the pages show an earlier time."""
        timeline = self.timeline
        if timeline is None or timeline.is_live:
            return self.shown
        with self.lock:
            return timeline.newest()

    def add_button(
        self,
        label: str,
        callback: Callable[[int], Any],
        *,
        hotkey: str | None = None,
        folder: str = FOLDER,
        hint: str = "",
    ) -> Control:
        """Add a button to the panel of all pages and to the command palette (Ctrl+K).

        Args:
            label: Label of the button.
            callback: Called with the number of the page in which the button was pressed.
            hotkey: Key with the same effect, see `on_key`.
            folder: Folder of the panel; created if missing.
            hint: Tooltip.

        Returns:
            The control. Its `remove()` removes the button.

        Raises:
            TypeError, ValueError: An argument of another type, an unknown key, or an empty label.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_button("Next scan", lambda page: print("pressed in page", page), hotkey="G")
            Control('Next scan')
        """
        return self._controls().add_button(label, callback, hotkey, folder, hint)

    def add_slider(
        self,
        label: str,
        low: float,
        high: float,
        value: float,
        callback: Callable[[Any], Any] | None = None,
        *,
        step: float | None = None,
        folder: str = FOLDER,
    ) -> Control:
        """Add a slider to the panel of all pages. It is integer if all given numbers are integers.

        Args:
            label: Label of the slider.
            low, high: Range.
            value: Initial value.
            callback: Called with the value after a page has changed it. Only with the newest if several wait. If None,
                the program reads `value`.
            step: Step size. If None, 1 or a hundredth of the range.
            folder: See `add_button`.

        Raises:
            TypeError, ValueError: Not a number, not callable, or `value` or `step` out of range.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_slider("neighbors", 4, 64, 20).value, viewer.add_slider("radius", 0.0, 1, 0.5).value
            (20, 0.5)
        """
        return self._controls().add_slider(label, low, high, value, callback, step, folder)

    def add_checkbox(
        self, label: str, value: bool = False, callback: Callable[[bool], Any] | None = None, *, folder: str = FOLDER
    ) -> Control:
        """Add a checkbox to the panel of all pages. Arguments and errors as in `add_slider`.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_checkbox("ground", True).value
            True
        """
        return self._controls().add_checkbox(label, value, callback, folder)

    def add_dropdown(
        self,
        label: str,
        options: Sequence[str],
        callback: Callable[[str], Any] | None = None,
        value: str | None = None,
        *,
        folder: str = FOLDER,
    ) -> Control:
        """Add a dropdown list to the panel of all pages. If `value` is None, the first option is selected.

        Raises:
            TypeError, ValueError: Options that are not strings, empty or duplicate, or `value` is not an option.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_dropdown("method", ["icp", "gicp"], value="gicp").value
            'gicp'
        """
        return self._controls().add_dropdown(label, options, callback, value, folder)

    def add_text(
        self, label: str, value: str = "", callback: Callable[[str], Any] | None = None, *, folder: str = FOLDER
    ) -> Control:
        """Add a text field (at most 16,384 characters) to the panel of all pages.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_text("name", "scan 7").value
            'scan 7'
        """
        return self._controls().add_text(label, value, callback, folder)

    def on_key(self, key: str, callback: Callable[[int], None], label: str = "") -> None:
        """Call a function when a key is pressed in a page. Replaces the default action of the key.

        Args:
            key: "A" to "Z", "0" to "9", "space", "enter", "escape", "tab", "backspace", "delete", "insert", "home",
                "end", "pageup", "pagedown", "arrowup", "arrowdown", "arrowleft" or "arrowright".
            callback: Called with the number of the page.
            label: Description in the command palette (Ctrl+K). If "", the name of the key.

        Raises:
            ValueError, TypeError: Unknown key, or `callback` is not callable.
        """
        _check_function(callback)
        with self.lock:
            self._check_open()
            self.panel.bind_key(check_hotkey(key), check_name("label", label or key), self._queued(callback))

    def on_pick(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        """Call a function with the point or triangle at each click, while no tool is active.

        Args:
            callback: Called with a `Pick`: name, index of the point (or triangle), world position and attributes. All
                points are searched, also those that are not drawn. Clicks on the background are ignored. Raises
                `TypeError` if not callable.

        Returns:
            A function that removes the callback.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     stop = viewer.on_pick(lambda pick: print(pick.name, pick.index, pick.point, pick.attributes))
            ...     stop()
        """
        _check_function(callback)
        with self.lock:
            calls = self._calls()
            if self._picks_made is None:
                self._picks_made = Picks(self._viewer(), calls)
        return self._picks_made.add(callback)

    def on_frame(self, callback: Callable[[float], Any], rate: float = 30.0) -> Callable[[], None]:
        """Call a function repeatedly while a page is open, for animations.

        Args:
            callback: Called with the seconds since the last call. 0 for the first call and for the first one after no
                page was open. An exception ends the calls and is displayed in all pages.
            rate: Maximum number of calls per second, in (0, 240]; limited by the drawing speed of the fastest page.

        Returns:
            A function that ends the calls.

        Raises:
            TypeError, ValueError: `callback` is not callable, or `rate` is not a number or out of range.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     stop = viewer.on_frame(lambda seconds: None, rate=10)
            ...     stop()
        """
        _check_function(callback)
        return self._calls().every(1.0 / check_positive("rate", rate, maximum=FASTEST), callback)

    def set_time(self, t: float) -> None:
        """Start a new time step. Later changes of the scene belong to it.

        From the second step on, all pages share a timeline of the history. At its end it follows the newest step.

        Args:
            t: Time [s] or frame number. Not before the newest step.

        Raises:
            TypeError, ValueError: `t` is not a number, not finite, or before the newest step.

        Notes:
            A step takes memory for its changes only. Beyond `history_bytes` of the viewer (1 GiB) the oldest steps are
            dropped, with one notice.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     for frame in range(3):
            ...         viewer.set_time(frame)
            ...         viewer.add("cloud", loom.PointCloud([[frame, 0, 0], [1, 1, 1]]))
            ...     viewer.show_time(1)
            ...     viewer.items["cloud"].cloud.points[0].tolist()
            [2.0, 0.0, 0.0]
        """
        with self.lock:
            self._check_open()
            timeline = self.timeline or LiveTimeline(self._viewer(), self.history_bytes)
            timeline.set_time(t)
            self.timeline = timeline

    def show_time(self, t: float | None = None) -> None:
        """Show the scene at a time in all pages. If None, follow the newest step.

        Raises `TypeError` for another type and `ValueError` if there is no history because `set_time` was never called.
        """
        with self.lock:
            self._check_open()
            time = None if t is None else check_number("t", t)
            if self.timeline is None:
                raise ValueError(
                    "t: no time step was recorded; call viewer.set_time(t) before the changes of each time step"
                )
            self.timeline.look(time)

    def save_recording(self, path: str | os.PathLike[str], **options: Any) -> None:
        """Write the history since `set_time` as a recording with one frame per time step.

        The view is that of a page or of `set_view`. Without either, all of the scene is visible at all times.

        Args:
            path: .html (one file that plays from disk), .gif or .mp4.
            **options: fps, size, max_points, max_frames, title, background, overwrite, see `loom.record`.

        Raises:
            ValueError: No history, or an option is out of range.
            TypeError: Unknown option.
            FileError: The file cannot be written.

        Example:
            >>> import os, tempfile, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer, tempfile.TemporaryDirectory() as folder:
            ...     for frame in range(3):
            ...         viewer.set_time(frame)
            ...         viewer.add("cloud", loom.PointCloud([[frame, 0, 0], [1, 1, 1]]))
            ...     viewer.save_recording(f"{folder}/run.html")
            ...     os.listdir(folder)
            ['run.html']
        """
        from .live_recording import write_history

        write_history(self._viewer(), path, **options)

    if TYPE_CHECKING:  # attributes of the scene, which inherits this class
        lock: Any
        server: Any
        sessions: dict[int, Any]
        panel: Any
        shown: dict[str, Item]  # displayed geometries by name

        def _check_open(self) -> None: ...

    def _calls(self) -> Calls:
        with self.lock:
            self._check_open()
            if self._calls_made is None:
                self._calls_made = Calls(HookPages(self._viewer()))
            return self._calls_made

    def _controls(self) -> Controls:
        with self.lock:
            calls = self._calls()
            if self._controls_made is None:
                self._controls_made = Controls(self.server.pages.gui, calls, self.panel.bind_key)
            return self._controls_made

    def _queued(self, callback: Callable[[int], Any]) -> Callable[[int], None]:
        calls = self._calls()
        return lambda client: calls.call(client, lambda: callback(client))

    def _viewer(self) -> Viewer:
        return self  # type: ignore[return-value]  # what inherits this

    def _end_hooks(self) -> list[Any]:
        """End all callbacks. Returns the objects to join without the lock."""
        calls, timeline, self.timeline = self._calls_made, self.timeline, None
        if timeline is not None:
            timeline.close()
        if calls is None:
            return []
        calls.close()
        return [calls]


def _check_function(callback: Any) -> None:
    if not callable(callback):
        raise TypeError(f"callback: expected a function, got {type(callback).__name__}")


class Picks:
    """Callbacks for clicks on the scene while no tool is active."""

    def __init__(self, viewer: Viewer, calls: Calls):
        self._viewer, self._calls = viewer, calls
        self._callbacks: tuple[Callable[[Pick], Any], ...] = ()
        viewer.server.pages.scene.on_click(self._on_click)

    def add(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        entry = lambda pick: callback(pick)  # noqa: E731  # unique, so that a function can be added twice
        with self._viewer.lock:
            self._callbacks = (*self._callbacks, entry)

        def stop() -> None:
            with self._viewer.lock:
                self._callbacks = tuple(other for other in self._callbacks if other is not entry)

        return stop

    def _on_click(self, event: ClickEvent) -> None:
        session = self._viewer.sessions.get(event.client_id)
        if not self._callbacks or session is None or not (0 <= event.x <= 1 and 0 <= event.y <= 1):
            return
        stage = session.idle_stage()
        if stage is None:  # otherwise the active tool handles the click
            return
        view = session.view_of(event.camera)
        x, y = event.x * view.intrinsic.width - 0.5, event.y * view.intrinsic.height - 0.5
        picked = stage.pick(view, x, y)
        if picked is None:
            return
        with self._viewer.lock:
            pick = with_attributes(picked, self._viewer.shown.get(picked.name))
        for callback in self._callbacks:
            self._calls.call(event.client_id, lambda call=callback: call(pick))


def with_attributes(pick: Pick, item: Item | None) -> Pick:
    if item is None or item.cloud is None or pick.index is None or pick.index >= len(item.cloud):
        return pick
    row = item.select([pick.index])
    known: dict[str, Any] = {name: values[0] for name, values in row.attributes.items()}
    if row.has_colors:
        known["color"] = row.colors[0]
    if row.has_normals:
        known["normal"] = row.normals[0]
    return dataclasses.replace(pick, attributes=known)
