"""Facts that are recorded without Warp: the machine, and the seconds and clocks of each step."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

NAMES = ("machine", "steps")


def record(state: Path, name: str, content: dict[str, Any]) -> None:
    """Add entries to a record of a run, replacing those of the same name."""
    path = state / f"{name}.json"
    path.write_text(json.dumps({**recorded(state, name), **content}, indent=1))


def recorded(state: Path, name: str) -> dict[str, Any]:
    """A record of a run; empty if nothing was recorded."""
    path = state / f"{name}.json"
    return json.loads(path.read_text()) if path.exists() else {}
