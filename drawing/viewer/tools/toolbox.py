"""The tools of one page: their buttons, the keys and clicks that drive the one at work, and their end."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy as np

from ....core.errors import PointloomError
from ...render.view import View
from ..logged import asked_by_page
from .clip_controls import ClipControls
from .pairs_tool import PairsTool
from .point_tools import MeasureTool, PointTool
from .polygon_tool import PolygonTool
from .stage import Stage, Tool

if TYPE_CHECKING:
    from ..link import ClickEvent
    from ..sessions import Session

MOST_WAITING = 64  # jobs that a page may ask for ahead of those that are done
ACTIVE = "orange"
KEYS = (
    ("escape", "End the tool", "stop"),
    ("backspace", "Take back the last click", "undo"),
    ("enter", "Finish", "finish"),
)
TOOLS: tuple[type[Tool], ...] = (PointTool, MeasureTool, PolygonTool, PairsTool)

log = logging.getLogger("pointloom.viewer")


class Toolbox:
    """The tools of a page, made when it connects and closed when it goes.

    What is asked for is done one after the other in a thread of the page's own, in the order of the clicks.

    Args:
        session: The page.
        folder: Of the page's panel, in which the tools are.
    """

    def __init__(self, session: Session, folder: Any):
        self.tool: Tool | None = None
        self._session, self._client = session, session.client
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="pointloom-tools")
        self._lock, self._waiting, self._closed = threading.Lock(), 0, False
        self._is_stale = False
        self._controls: Any = None
        self.stage = Stage(session, self.run)
        gui = self._client.gui
        with folder:
            self._buttons = {kind: gui.add_button(f"{kind.label} ({kind.key})") for kind in TOOLS}
        # at the top of the panel while a tool is at work, where it is seen without scrolling
        self._top = gui.add_folder("Tool", order=0.5, visible=False)
        with self._top:
            self.stage.status = gui.add_words("")
            self.stage.rows = gui.add_table((), visible=False)
        self._commands: list[Any] = []
        for kind, button in self._buttons.items():
            toggle = self._asks(lambda kind=kind: self.toggle(kind))
            button.on_click(toggle)
            self._commands.append(gui.add_command(kind.label, kind.key, group="Tools"))
            self._commands[-1].on_trigger(toggle)
        self.clip = ClipControls(self.stage, folder)
        for key, label, action in KEYS:
            command = gui.add_command(label, key, group="Tools")
            command.on_trigger(self._asks(lambda action=action: self._key(action)))

    # -- what drives it -----------------------------------------------------------------------------------------------

    def run(self, job: Callable[[], None]) -> bool:
        """Do something after all that was asked for before, if it is not too much; says whether it will be done."""
        with self._lock:
            if self._closed or self._waiting >= MOST_WAITING:
                return False
            self._waiting += 1
            self._worker.submit(self._do, job)
            return True

    def refresh(self) -> None:
        """The scene has changed: cut what is new, offer the clouds that there are."""
        with self._lock:
            if self._is_stale:  # asked for, and not done yet
                return
            self._is_stale = True
        if not self.run(self._sync):
            self._is_stale = False

    def start(self, kind: type[Tool]) -> None:
        """Begin with a tool; the one before ends."""
        self.stop()
        tool = kind(self.stage)
        gui = self._client.gui
        with self._top:
            self._controls = gui.add_folder(None)
        self._top.visible = True
        self._client.scene.on_click(self._on_click)  # before the hint, which says that one may click
        try:
            self.stage.say(kind.hint)
            with self._controls:
                tool.start()
        except BaseException:
            self._client.scene.remove_click_callback(self._on_click)
            self._controls.remove()
            self._controls = None
            raise
        self.tool = tool
        self._buttons[kind].color = ACTIVE

    def stop(self) -> None:
        """End the tool, and take all of it out of the page."""
        tool, self.tool = self.tool, None
        if tool is None:
            return
        self._client.scene.remove_click_callback(self._on_click)
        self._buttons[type(tool)].color = None
        try:
            tool.stop()
        finally:
            self.stage.clear()
            self._controls.remove()
            self._controls = None
            self.stage.show([])
            self._top.visible = False

    def give_up_key(self, key: str) -> None:
        """A key calls the program from now on: the tool that it began is begun by its button."""
        for command in [command for command in self._commands if command.hotkey == key]:
            self._commands.remove(command)
            command.remove()

    def toggle(self, kind: type[Tool]) -> None:
        """Begin with a tool, or end it where it is at work."""
        if isinstance(self.tool, kind):
            self.stop()
        else:
            self.start(kind)

    def close(self) -> None:
        """The page has gone: its scene and panel with it; what waits is left."""
        with self._lock:
            self._closed = True
        self._worker.shutdown(wait=False, cancel_futures=True)
        self.clip.close()
        self.tool = None

    # -- within -------------------------------------------------------------------------------------------------------

    def _asks(self, job: Callable[[], None]) -> Callable[[Any], Any]:
        """A callback of the panel that has a job done in its turn."""
        return lambda _: self.run(job)

    def _on_click(self, event: ClickEvent) -> None:
        view = self._session.view_of(event.camera)  # as it was with the click, not when its turn comes
        camera = view.intrinsic
        self.run(lambda: self._click(view, event.x * camera.width - 0.5, event.y * camera.height - 0.5))

    def _click(self, view: View, x: float, y: float) -> None:
        if self.tool is not None:
            self.tool.click(view, x, y)

    def _key(self, action: str) -> None:
        if action == "stop":
            self.stop()
            self._top.visible = False  # what could not begin has left its reason there
        elif self.tool is not None:
            getattr(self.tool, action)()

    def _sync(self) -> None:
        self._is_stale = False
        self.clip.sync()
        if self.tool is not None:
            self.tool.refresh()

    def _do(self, job: Callable[[], None]) -> None:
        try:
            if not self._closed:
                with asked_by_page(), np.errstate(all="ignore"):  # a camera may be anywhere
                    job()
        except (PointloomError, ValueError, TypeError, LookupError, OSError, MemoryError) as error:
            self._tell(str(error.args[0]) if isinstance(error, KeyError) and error.args else str(error))
        except Exception:  # a page that goes meanwhile, or a fault of ours: the viewer goes on
            log.debug("a tool", exc_info=True)
            self._tell("That went wrong; the log of pointloom.viewer says why.")
        finally:
            with self._lock:
                self._waiting -= 1

    def _tell(self, text: str) -> None:
        if not self._closed:
            self.stage.say(text)
            self._top.visible = True  # of what could not begin as well
