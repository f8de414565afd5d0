"""What a program hangs on the viewer's pages: controls, clicks, calls with each frame, a time line; `Hooks`."""

from __future__ import annotations

import dataclasses
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ...core.checks import check_callback, check_list, check_name, check_number, check_positive, shown
from .calls import Calls, HookPages
from .items import Item
from .keys import check_hotkey
from .live_timeline import HISTORY_BYTES, LiveTimeline
from .tools.picking import Pick

if TYPE_CHECKING:
    from .link import ClickEvent
    from .viewer import Viewer


FOLDER, ORDER = "Program", 0.7  # above all that is ours but the line of the points and the tool at work
STEPS = 100  # of a slider between its ends, where no step is given
MOST_TEXT = 16_384  # characters of a text

Check = Callable[[Any], Any]


class Control:
    """A control of the panel that a program added; `viewer.add_button` and its kin make it.

    Attributes:
        label: What it is called.
        folder: The folder of the panel that it lies in.

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
        self._handles: list[Any] = []  # of the link; the first is the control itself

    def __repr__(self) -> str:
        value = "" if self._check is None else f", {self._value!r}"
        return f"Control({self.label!r}{value})"

    @property
    def value(self) -> Any:
        """What it is set to, by a page or by the program; assign another. None of a button.

        Raises:
            TypeError: Assigned to a button, or a value of another kind.
            ValueError: Assigned a value that the control does not take.
        """
        return self._value

    @value.setter
    def value(self, value: Any) -> None:
        if self._check is None:
            raise TypeError(f"value: {self.label!r} is a button, which has none")
        self._value = self._check(value)
        if self._handles:
            self._handles[0].value = self._value

    def remove(self) -> None:
        """Take it out of the panel; its function is called no more. Twice is no error."""
        self._controls.remove(self)


class Controls:
    """The folders of a program's controls, and the controls in them.

    Args:
        gui: Of all pages, as of the link.
        calls: Calls the program's functions.
        bind: Has a key of a label call a function with the number of the page; gives the handle.
    """

    def __init__(self, gui: Any, calls: Calls, bind: Callable[[str, str, Callable[[int | None], None]], Any]):
        self._gui, self._calls, self._bind = gui, calls, bind
        self._lock = threading.RLock()
        self._folders: dict[str, tuple[Any, list[Control]]] = {}

    def add_button(self, label: str, callback: Any, hotkey: str | None, folder: str, hint: str) -> Control:
        """A button."""
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
        """A slider, of whole numbers where all that is given is whole."""
        given = {"low": low, "high": high, "value": value} | ({} if step is None else {"step": step})
        numbers = {name: check_number(name, number) for name, number in given.items()}
        is_whole = all(isinstance(number, int) or hasattr(number, "__index__") for number in given.values())
        kind = int if is_whole else float
        first, last = numbers["low"], numbers["high"]
        if not first < last:
            raise ValueError(f"low: expected less than high, {last:g}, got {first:g}")
        step = check_positive("step", numbers.get("step", 1 if is_whole else (last - first) / STEPS))
        if step > last - first:
            raise ValueError(f"step: expected at most high - low, {last - first:g}, got {step:g}")

        def check(new: Any) -> Any:
            number = check_number("value", new)
            if not first <= number <= last:
                raise ValueError(f"value: expected {first:g} to {last:g}, got {number:g}")
            return kind(round(number)) if is_whole else number

        start = check(value)
        ends = kind(first), kind(last), kind(step)
        return self._add(label, folder, start, check, lambda name: self._gui.add_slider(name, *ends, start), callback)

    def add_checkbox(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        """A box to tick."""
        start = _check_flag(value)
        return self._add(label, folder, start, _check_flag, lambda name: self._gui.add_checkbox(name, start), callback)

    def add_dropdown(self, label: str, options: Any, callback: Any, value: Any, folder: str) -> Control:
        """A choice of one of several."""
        known = tuple(check_name("options", option) for option in check_list("options", options, "strings"))
        if not known or len({*known}) != len(known):
            raise ValueError(f"options: expected strings that differ, one at the least, got {shown(options)}")

        def check(new: Any) -> str:
            if check_name("value", new) not in known:
                raise ValueError(f"value: expected one of {', '.join(map(repr, known))}, got {new!r}")
            return new

        start = known[0] if value is None else check(value)
        return self._add(label, folder, start, check, lambda name: self._gui.add_dropdown(name, known, start), callback)

    def add_text(self, label: str, value: Any, callback: Any, folder: str) -> Control:
        """A field of text."""
        start = _check_text(value)
        return self._add(label, folder, start, _check_text, lambda name: self._gui.add_text(name, start), callback)

    def remove(self, control: Control) -> None:
        """Take a control out, and its folder where it was the last one."""
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
            place, within = self._folders[folder]
            with place:
                control._handles.append(make(label))
            within.append(control)
        if check is not None:
            control._handles[0].on_update(lambda event: self._take(control, event.client_id, event.value, callback))
        return control

    def _take(self, control: Control, client: int | None, value: Any, callback: Any) -> None:
        """A page has set a value, which the link has checked."""
        assert control._check is not None
        if client is None or not control._handles:  # the program itself has set it, or it has gone
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
    if len(check_name("value", value)) > MOST_TEXT:
        raise ValueError(f"value: expected at most {MOST_TEXT:,} characters, got {len(value):,}")
    return value


def _check_label(name: str, label: Any) -> str:
    if not check_name(name, label).strip():
        raise ValueError(f"{name}: expected words, got {label!r}")
    return label


FASTEST = 240.0  # [Hz] of calls with each frame


class Hooks:
    """The calls of a viewer by which its pages call the program.

    The program's functions are called one after the other in a thread of the pages, never in the program's own; each of
    them may call everything of the viewer, `close` too. What one raises is shown in the page that asked for it and goes
    to the logger `pointloom.viewer`; the next is called all the same.
    """

    timeline: LiveTimeline | None = None  # once `set_time` was called
    history_bytes = HISTORY_BYTES
    _calls_made: Calls | None = None
    _controls_made: Controls | None = None
    _picks_made: Picks | None = None

    @property
    def items(self) -> Mapping[str, Item]:
        """What is in the scene, by name; the newest, also while the pages look at an earlier moment."""
        timeline = self.timeline
        if timeline is None or timeline.is_live:
            return self.shown
        with self.lock:
            return timeline.newest()

    # -- controls -----------------------------------------------------------------------------------------------------

    def add_button(
        self,
        label: str,
        callback: Callable[[int], Any],
        *,
        hotkey: str | None = None,
        folder: str = FOLDER,
        hint: str = "",
    ) -> Control:
        """Add a button to the panel of all pages; the palette (Ctrl+K) lists it as well.

        Args:
            label: On the button.
            callback: Called with the number of the page in which it was pressed.
            hotkey: A key that does the same, as of `on_key`.
            folder: The folder of the panel that it lies in; one that is not there is made.
            hint: Shown where the mouse rests on it.

        Returns:
            The control, for `remove()`.

        Raises:
            TypeError: No string, or no function.
            ValueError: No such key, or a label without words.

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
        """Add a slider to the panel of all pages; of whole numbers alone where all that is given is whole.

        Args:
            label: Beside it.
            low, high: Its ends.
            value: Where it begins.
            callback: Called with the value when a page has set it, with the newest where several wait; None: the
                program reads `value`.
            step: Between two values; None for 1 or a hundredth of the way.
            folder: As of `add_button`.

        Raises:
            TypeError: No number, or no function.
            ValueError: A value or a step that does not lie between the ends.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_slider("neighbours", 4, 64, 20).value, viewer.add_slider("radius", 0.0, 1, 0.5).value
            (20, 0.5)
        """
        return self._controls().add_slider(label, low, high, value, callback, step, folder)

    def add_checkbox(
        self, label: str, value: bool = False, callback: Callable[[bool], Any] | None = None, *, folder: str = FOLDER
    ) -> Control:
        """Add a box to tick to the panel of all pages; arguments and errors as of `add_slider`.

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
        """Add a choice of one of several to the panel of all pages; `value` None begins with the first.

        Raises:
            TypeError: No strings, or no function.
            ValueError: No options, two that are the same, or a value that is none of them.

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
        """Add a field of text, of 16,384 characters at most, to the panel of all pages.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_text("name", "scan 7").value
            'scan 7'
        """
        return self._controls().add_text(label, value, callback, folder)

    # -- keys, clicks and frames --------------------------------------------------------------------------------------

    def on_key(self, key: str, callback: Callable[[int], None], label: str = "") -> None:
        """Call back when a key is pressed in a page, in place of what it did there.

        Args:
            key: "A" to "Z", "0" to "9", "space", "enter", "escape", "tab", "backspace", "delete", "insert", "home",
                "end", "pageup", "pagedown", "arrowup", "arrowdown", "arrowleft" or "arrowright".
            callback: Called with the number of the page.
            label: What the key does, for the list that Ctrl+K opens; "" for its name.

        Raises:
            ValueError: No such key.
            TypeError: No function.
        """
        _check_function(callback)
        with self.lock:
            self._check_open()
            self.panel.bind_key(check_hotkey(key), check_name("label", label or key), self._queued(callback))

    def on_pick(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        """Call back with what a click in a page means, where no tool is at work; a click beside all is none.

        Args:
            callback: Called with the `Pick`: the name, the index of the point (of a surface: the triangle), the place
                in the world, and the point's attributes. All points are looked at, not only those that are drawn.

        Returns:
            A function that ends it.

        Raises:
            TypeError: No function.

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
        """Call back again and again while a page is open, for animations.

        Args:
            callback: Called with the seconds since the last call; 0 for the first, and for the first after no page was
                open. What it raises ends it, and is shown in all pages.
            rate: At most so many times a second. A page that draws slowly is waited for; of several the fastest counts.

        Returns:
            A function that ends it.

        Raises:
            TypeError: No function, or no number.
            ValueError: A rate that is not above 0, or above 240.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     stop = viewer.on_frame(lambda seconds: None, rate=10)
            ...     stop()
        """
        _check_function(callback)
        return self._calls().every(1.0 / check_positive("rate", rate, maximum=FASTEST), callback)

    # -- the time line ------------------------------------------------------------------------------------------------

    def set_time(self, t: float) -> None:
        """Begin a moment: what is added, updated, moved, shown or removed from now on belongs to it.

        With the second moment the pages have a time line, which looks at what was: one for all pages. At its end it
        follows the newest moment. The program goes on meanwhile, and `items` is the newest.

        Args:
            t: In seconds, or the number of a frame; not before the newest moment.

        Raises:
            TypeError: No number.
            ValueError: Before the newest moment, or not finite.

        Notes:
            A moment takes the memory of what changed in it: geometries that stay are held once, poses as matrices.
            Beyond `history_bytes` of the viewer (1 GiB) the oldest moments go, which is said once.

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
        """Show what was at a time in all pages, as their time line does; None follows the newest moment.

        Raises:
            TypeError, ValueError: No number, or nothing was logged: `set_time` was not called.
        """
        with self.lock:
            self._check_open()
            time = None if t is None else check_number("t", t)
            if self.timeline is None:
                raise ValueError("t: nothing was logged; call viewer.set_time(t) before what belongs to a moment")
            self.timeline.look(time)

    def save_recording(self, path: str | os.PathLike[str], **options: Any) -> None:
        """Write what was logged since `set_time` as a recording, one frame a moment.

        It is seen from where a page looks, or `set_view` said; without either all of it is seen at all times.

        Args:
            path: .html (one file that plays from disk), .gif or .mp4.
            **options: fps, size, max_points, max_frames, title, background, overwrite, as of `loom.record`.

        Raises:
            ValueError: Nothing was logged, or an option out of range.
            TypeError: An option that there is none.
            FileError: The place cannot be written.

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

    # -- within -------------------------------------------------------------------------------------------------------

    if TYPE_CHECKING:  # of the scene that inherits this
        lock: Any
        server: Any
        sessions: dict[int, Any]
        panel: Any
        shown: dict[str, Item]  # what pages see, by name

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
        """A function of the program that is called in its turn, with the number of a page."""
        calls = self._calls()
        return lambda client: calls.call(client, lambda: callback(client))

    def _viewer(self) -> Viewer:
        return self  # type: ignore[return-value]  # what inherits this

    def _end_hooks(self) -> list[Any]:
        """Call nothing any more; what is to be joined without the lock."""
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
    """Functions of a program that are told what a click means, where no tool is at work.

    Args:
        viewer: The viewer, whose pages tell of clicks from now on.
        calls: Calls them.
    """

    def __init__(self, viewer: Viewer, calls: Calls):
        self._viewer, self._calls = viewer, calls
        self._callbacks: tuple[Callable[[Pick], Any], ...] = ()
        viewer.server.pages.scene.on_click(self._on_click)

    def add(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        """Tell one more, until what is returned is called."""
        entry = lambda pick: callback(pick)  # noqa: E731  # another one each time: a function may be told twice
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
        if stage is None:  # a tool is at work, and has the click
            return
        view = session.view_of(event.camera)
        x, y = event.x * view.intrinsic.width - 0.5, event.y * view.intrinsic.height - 0.5
        found = stage.pick(view, x, y)
        if found is None:
            return
        with self._viewer.lock:
            told = with_attributes(found, self._viewer.shown.get(found.name))
        for callback in self._callbacks:
            self._calls.call(event.client_id, lambda call=callback: call(told))


def with_attributes(pick: Pick, item: Item | None) -> Pick:
    """A pick with what the cloud knows of its point."""
    if item is None or item.cloud is None or pick.index is None or pick.index >= len(item.cloud):
        return pick
    row = item.select([pick.index])
    known: dict[str, Any] = {name: values[0] for name, values in row.attributes.items()}
    if row.has_colors:
        known["color"] = row.colors[0]
    if row.has_normals:
        known["normal"] = row.normals[0]
    return dataclasses.replace(pick, attributes=known)
