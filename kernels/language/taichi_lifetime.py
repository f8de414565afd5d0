"""How Taichi starts and ends in a process, beside others that share its folder of compiled kernels.

Taichi guards that folder by a file, ticache.lock, which it makes, removes, and waits for 0.2 s. It reads the list of
kernels when the first one is compiled and writes it with the new ones when its program ends: left to itself after the
interpreter, in a destructor. So without what is here

- a process that is killed in its turn leaves the file behind: all that come later compile everything, in silence;
- one that waits longer compiles everything too, or loses what it compiled;
- a kernel whose file is gone while the list names it is compiled in each process, and never kept again;
- a folder that is removed while Taichi writes ends the process by abort(), as does a thread that the system refuses.

Our processes take turns by flock(), which the system takes back from one that dies. Written for Taichi 1.7.
"""

from __future__ import annotations

import contextlib
import ctypes
import re
import threading
import time
import warnings
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Any

try:
    import fcntl
except ImportError:  # Windows: Taichi's own lock has to do
    fcntl = None

PATIENCE = 10.0  # [s] for a turn, which takes some ms; then it is done without
LEFT_BEHIND = 2.0  # [s] after which a ticache.lock is nobody's


class TaichiUnavailableError(RuntimeError):
    """Taichi cannot serve here; the message says why and how to mend it."""


def require_threads(count: int) -> None:
    """Start as many threads as Taichi will, and end them: it aborts where the system refuses it one.

    Raises:
        TaichiUnavailableError: The system refuses one.
    """
    end, threads = threading.Event(), list[threading.Thread]()
    try:
        for _ in range(count):
            thread = threading.Thread(target=end.wait, daemon=True)
            thread.start()
            threads.append(thread)
    except RuntimeError as error:
        raise TaichiUnavailableError(
            f"the system refuses this process {count} threads (a limit of the user's or the container's tasks); "
            "POINTLOOM_CPU_THREADS asks for fewer"
        ) from error
    finally:
        end.set()
        for thread in threads:
            thread.join()


class KernelFolder:
    """The folder of compiled kernels, or none where they are not kept."""

    def __init__(self, path: str | None) -> None:
        self.path = Path(path) if path else None

    @contextlib.contextmanager
    def turn(self) -> Iterator[None]:
        """Be the one process of ours that reads or writes the folder, and find it in order."""
        if self.path is None:
            yield
            return
        with contextlib.ExitStack() as held:
            with contextlib.suppress(OSError):  # a full disk, a file system without locks
                self.path.mkdir(parents=True, exist_ok=True)
                file = held.enter_context((self.path / "pointloom.lock").open("w"))
                _take_lock(file.fileno(), held)
                _remove_left_lock(self.path / "ticache.lock")
                _forget_lost_kernels(self.path)
            yield


def _take_lock(descriptor: int, held: contextlib.ExitStack) -> None:
    """Lock a file until the stack ends, or the process."""
    last = time.monotonic() + PATIENCE
    while fcntl is not None and time.monotonic() < last:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            time.sleep(0.005)
        else:
            held.callback(fcntl.flock, descriptor, fcntl.LOCK_UN)  # closing is not enough where another thread forked
            return


def _remove_left_lock(path: Path) -> None:
    """Remove Taichi's lock if its process is dead: it is none of ours, and no program holds it as long."""
    with contextlib.suppress(FileNotFoundError):
        while 0 <= time.time() - path.stat().st_mtime < LEFT_BEHIND:
            time.sleep(0.02)
        path.unlink()


def _forget_lost_kernels(folder: Path) -> None:
    """Remove the list of kernels if one of them is not there, for Taichi to write a new one."""
    listing = folder / "ticache.tcb"
    with contextlib.suppress(FileNotFoundError):
        named = set(re.findall(r"T[0-9a-f]{64}", listing.read_bytes().decode("latin-1")))
        there = {path.stem for path in folder.glob("*.tic")}
        if not named <= there:
            listing.unlink()


class OwnProgram:
    """Taichi's program that this process started by itself, and not its user."""

    def __init__(self, ti: Any, impl: Any) -> None:
        """Call it when Taichi has just started: has it read the list of kernels, which it does for the first kernel."""
        self._ti, self._impl = ti, impl
        self._program = weakref.ref(impl.get_runtime().prog)
        self._folder = KernelFolder(ti.cfg.offline_cache_file_path if ti.cfg.offline_cache else None)
        with self._folder.turn(), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Taichi's compiler uses what newer Pythons deprecate
            ti.kernel(_nothing)()

    def end(self) -> None:
        """End it while an error in that is an exception still; what it compiled is kept in the folder."""
        if self._impl.get_runtime().prog is not self._program():
            return
        with self._folder.turn():
            try:
                self._ti.reset()
            except Exception:
                self.keep_for_ever()  # its destructor would try again, and abort

    def keep_for_ever(self) -> None:
        """Never destroy it."""
        program = self._program()
        if program is not None:
            ctypes.pythonapi.Py_IncRef(ctypes.py_object(program))


def _nothing():
    pass


@contextlib.contextmanager
def same_arithmetic() -> Iterator[None]:
    """Give this thread its floating-point mode back: ti.init makes it flush subnormal numbers to zero, NumPy's too."""
    try:
        libc = ctypes.CDLL(None)
        read, write = libc.fegetenv, libc.fesetenv
    except (OSError, AttributeError, TypeError):  # a platform whose C library has no such function
        yield
        return
    mode = ctypes.create_string_buffer(64)  # fenv_t: 32 bytes on x86-64, 8 on ARM
    read(mode)
    try:
        yield
    finally:
        write(mode)
