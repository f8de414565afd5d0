"""These tests need the emulated device; without --emulated-cuda they are not there."""

from __future__ import annotations

from pathlib import Path

import pytest

from .plugin import is_asked_for


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    return True if collection_path.name.startswith("test_") and not is_asked_for(config) else None
