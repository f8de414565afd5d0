"""These tests need the emulated device; without --emulated-cuda they are not there."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from .install import Device, installed
from .plugin import is_requested
from .ptx_programs import Programs
from .settings import settings as process_settings

if TYPE_CHECKING:
    from ..small_scenes import SmallScenes


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    return True if collection_path.name.startswith("test_") and not is_requested(config) else None


@pytest.fixture(scope="session")
def emulated() -> Device:
    import warp as wp

    wp.init()
    device = installed()
    assert device is not None
    return device


@pytest.fixture
def settings(monkeypatch):
    def change(**values) -> None:
        for name, value in values.items():
            monkeypatch.setattr(process_settings, name, value)

    return change


@pytest.fixture(scope="session")
def programs(emulated, tmp_path_factory) -> Programs:
    return Programs(emulated, tmp_path_factory.mktemp("ptx"))


@pytest.fixture
def chosen(emulated):
    """A stream of the caller's that does not wait for the legacy stream, nor that for it, as torch's but one."""
    import warp as wp

    from pointloom.kernels.language.streams import NonBlockingStream

    theirs = NonBlockingStream(wp.get_device("cuda:0"))
    chosen = wp.Stream("cuda:0", cuda_stream=theirs.cuda_stream)
    chosen.theirs = theirs  # type: ignore[attr-defined]  # which lives as long
    return chosen


@pytest.fixture(scope="module")
def small(emulated) -> SmallScenes:
    """Scenes on the device, small enough for each operation to run several times."""
    from ..small_scenes import SmallScenes

    return SmallScenes("cuda:0")
