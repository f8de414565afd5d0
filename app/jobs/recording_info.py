"""What a recording of a robot holds: `describe_recording`."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...core.reports import Fields
from ...files.bags.recording import read_recording
from .facts import Facts


@dataclass(frozen=True)
class RecordedTopics(Facts):
    """A recording of a robot: how many messages, its topics, and what is missing of it, or None."""

    KIND = "recording"
    SPARE = ("damage",)

    messages: int
    topics: list[dict[str, Any]]
    damage: str | None

    def fields(self) -> Fields:
        """A line a topic."""
        lines = []
        for topic in self.topics:
            frame = f", frame {topic['frame_id']}" if topic["frame_id"] else ""
            span = "" if topic["first"] is None else f", {topic['last'] - topic['first']:.3f} s"
            lines.append(f"{topic['name']}: {topic['type']}, {topic['count']}{span}{frame}")
        damage = [("damage", self.damage)] if self.damage else []
        return [("messages", f"{self.messages:,}"), ("topics", "\n".join(lines)), *damage]


def describe_recording(path: Path) -> RecordedTopics:
    """The topics; that it is damaged stands among the facts."""
    recording = read_recording(path)
    return RecordedTopics(len(recording), [dataclasses.asdict(topic) for topic in recording.topics], recording.damage)
