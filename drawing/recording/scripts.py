"""What a recording shows of each algorithm: from the events that they report to frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .label_scripts import Clusters, Fragments, Planes
from .registration_script import Registration
from .script import Look, Script, Stage
from .travel_scripts import Drive, Fusion

if TYPE_CHECKING:
    from .recorder import Recorder


class Scripts:
    """Turns events into steps of a recorder.

    Args:
        recorder: The Recorder.

    """

    def __init__(self, recorder: Recorder):
        self._stage = ""
        scripts = [kind(Stage(recorder)) for kind in (Registration, Fusion, Drive, Clusters, Planes, Fragments)]
        self._shown_by = {event: (script, show) for script in scripts for event, show in script.events().items()}
        self._first: Script | None = None
        self._active: Script | None = None

    def take(self, event: str, data: dict[str, Any]) -> None:
        """Show an event; one that nothing is known of is nothing."""
        if event == "stage":
            self._stage = data["name"]
            return
        if event not in self._shown_by:
            return
        script, show = self._shown_by[event]
        if script is not self._active:
            self.finish()
            self._active = script
            script.begin()
        script.stage.prefix = self._stage
        show(**data)
        self._first = self._first or script

    @property
    def look(self) -> Look | None:
        """A direction to look along, and what is up, by the first algorithm that was seen; None before."""
        return None if self._first is None else self._first.look

    def finish(self) -> None:
        """Let the algorithm that was shown last come to its end."""
        if self._active is not None:
            self._active.finish()
