"""Imports that a signal handler cannot interrupt: afterwards a module is complete, or was never started.

An interrupted import leaves the native parts of packages such as Warp, SciPy or lazrs half initialized, and no later
import in the same process succeeds. Handlers of signals, such as Ctrl-C, run after the outermost import instead.
"""

from __future__ import annotations

import sys
from types import ModuleType

TYPE_CHECKING = False  # importing `typing` takes as long as all the rest
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from importlib.machinery import ModuleSpec
    from typing import Any

# This package and those that it imports when they are needed.
PACKAGES = frozenset(
    (
        *(__name__.partition(".")[0], "numpy", "scipy", "warp", "taichi", "PIL", "websockets", "manifold3d", "xatlas"),
        *("laspy", "lazrs", "pye57", "DracoPy", "meshoptimizer", "pycolmap", "cv2", "pi_heif", "rawpy", "onnxruntime"),
        *(
            "onnx",
            "pyrealsense2",
            "pyk4a",
            "pooch",
            "pyproj",
            "rasterio",
            "pyogrio",
            "distributed",
            "dask",
            "rosbags",
            "lz4",
        ),
        *("backports", "zstandard", "matplotlib", "open3d", "torch", "cupy", "jax", "rich", "click"),
    )
)
# [s] from the end of an import to the handlers: the import system discards a module if one of them raises within it.
_PAUSE = 0.01

_depth = 0  # of imports in the main thread


class _Finder:
    """First import finder: replaces the loader of a package in the list by one that defers signal handlers."""

    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        if name.partition(".")[0] not in PACKAGES or not _is_main_thread():
            return None
        finders = sys.meta_path[sys.meta_path.index(_Finder) + 1 :]
        found = (finder.find_spec(name, path, target) for finder in finders if hasattr(finder, "find_spec"))
        spec = next((spec for spec in found if spec is not None), None)
        if spec is not None and hasattr(spec.loader, "exec_module"):
            spec.loader = _Loader(spec.loader)  # type: ignore[assignment]
        return spec


class _Loader:
    """A loader that defers signal handlers. It puts the original loader back into the module."""

    def __init__(self, loader: Any):
        self._loader = loader

    def __getattr__(self, name: str) -> Any:
        return getattr(self._loader, name)

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return _deferring(lambda: self._loader.create_module(spec))

    def exec_module(self, module: ModuleType) -> None:
        if module.__spec__ is not None:
            module.__spec__.loader = self._loader
        module.__loader__ = self._loader
        _deferring(lambda: self._loader.exec_module(module))


def install() -> None:
    """Put the finder first, once."""
    if _Finder not in sys.meta_path:
        sys.meta_path.insert(0, _Finder)  # type: ignore[arg-type]


def _is_main_thread() -> bool:
    import threading

    return threading.current_thread() is threading.main_thread()


def _deferring(work: Callable[[], Any]) -> Any:
    """Run `work` in the main thread. Signal handlers run a moment later."""
    global _depth
    if _depth:
        return work()
    from contextlib import ExitStack

    received: dict[int, None] = {}
    with ExitStack() as stack:
        _depth += 1
        stack.callback(_end)
        stack.callback(lambda: received and _raise_soon([*received]))
        _take_handlers(stack, received)
        return work()


def _end() -> None:
    global _depth
    _depth -= 1


def _take_handlers(stack: Any, received: dict[int, None]) -> None:
    """Replace the handlers of all signals by one that only records them, until the stack is closed."""
    import signal

    def record(number: int, _: Any) -> None:
        received[number] = None

    def restore(number: int, handler: Any) -> None:
        if signal.getsignal(number) is record:  # otherwise the import has set another one
            signal.signal(number, handler)

    for number in signal.valid_signals():
        handler = signal.getsignal(number)
        if callable(handler) and not getattr(handler, "ends_process", False):
            stack.callback(restore, number, handler)
            try:
                signal.signal(number, record)
            except ValueError:  # not the main interpreter, where no handler runs
                return


def _raise_soon(numbers: list[int]) -> None:
    """Send signals to the main thread when the import system has finished with the module."""
    import signal
    import threading

    def send() -> None:
        for number in numbers:
            if hasattr(signal, "pthread_kill"):
                signal.pthread_kill(threading.main_thread().ident or 0, number)
            else:
                signal.raise_signal(number)

    timer = threading.Timer(_PAUSE, send)
    timer.daemon = True
    timer.start()
