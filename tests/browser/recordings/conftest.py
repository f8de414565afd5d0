"""Fixtures of recordings."""

from __future__ import annotations

import pytest

from pointloom.visualization.page import sources
from pointloom.visualization.recording.page import write_page

from ..pixels import ready


@pytest.fixture
def open_recording(open_page, tmp_path):
    """Write a page, open it from disk without a network, and wait for its first image."""

    def open_one(timeline, *, width=640, height=480, faults=True, **options):
        path = tmp_path / "recording.html"
        write_page(path, timeline, **options)
        page = open_page(path.as_uri(), width=width, height=height, offline=True, faults=faults)
        ready(page)
        return page

    return open_one


@pytest.fixture
def changed_player(monkeypatch):
    """Change the text of the player before the page is written."""
    plain = sources.read_source

    def change(old: str, new: str) -> None:
        assert any(old in plain(f"{name}.js") for name in sources.PLAYER)
        monkeypatch.setattr(sources, "read_source", lambda name: plain(name).replace(old, new))

    return change
