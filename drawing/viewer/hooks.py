"""What a program hangs on the viewer's pages: controls, clicks, calls with each frame, a time line; `Hooks`."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ...core.checks import check_name, check_number, check_positive
from .calls import Calls, HookPages
from .controls import FOLDER, Control, Controls
from .items import Item
from .keys import check_hotkey
from .live_timeline import HISTORY_BYTES, LiveTimeline
from .picks import Picks
from .tools.picking import Pick

if TYPE_CHECKING:
    from .viewer import Viewer

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
