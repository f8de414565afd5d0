"""Processes of this machine that do many small tasks with one large state, their results in the order of the tasks.

They are given a call once, then the arguments of task after task by a pipe, so that scripts need no guard for a main
module, as those of multiprocessing do. A task is pure: where a process dies, another one does it again.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from multiprocessing.connection import Connection, Pipe
from queue import SimpleQueue
from typing import Any, TypeVar

from ..core.errors import FileError
from .gpus import environment_of

MOST_DEATHS = 3  # at one task
_WORKER = "from pointloom.scale.crew import main; main()"
Result = TypeVar("Result")


class Crew:
    """So many processes, which are started when they are needed; 0 works in this one.

    Args:
        count: Processes.
        path: What is made, for errors.
    """

    def __init__(self, count: int, path: Any):
        self.count, self._path = count, path
        self._free: SimpleQueue[_Worker] = SimpleQueue()
        self._workers = [_Worker(count) for _ in range(count)]
        for worker in self._workers:
            self._free.put(worker)
        self._threads = ThreadPoolExecutor(max(count, 1), "crew")

    def __enter__(self) -> Crew:
        return self

    def __exit__(self, *_: object) -> None:
        for worker in self._workers:
            worker.end()
        self._threads.shutdown(cancel_futures=True)

    def map(self, call: Callable[..., Result], tasks: Iterable[tuple[Any, ...]]) -> Iterator[Result]:
        """The results of `call(*task)`, in the order of the tasks; about one a process waits to be taken.

        Raises:
            FileError: Processes died at one task again and again.
        """
        if not self.count:
            yield from (call(*task) for task in tasks)
            return
        state = pickle.dumps(call, pickle.HIGHEST_PROTOCOL)
        waiting: deque[Future[Any]] = deque()
        for task in tasks:
            waiting.append(self._threads.submit(self._ask, state, task))
            if len(waiting) > self.count:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()

    def _ask(self, state: bytes, task: tuple[Any, ...]) -> Any:
        worker = self._free.get()
        try:
            for _ in range(MOST_DEATHS):
                try:
                    is_result, found = worker.ask(state, task)
                except (EOFError, OSError):
                    if worker.is_over:
                        raise
                    worker.stop()
                    continue
                if not is_result:
                    raise found
                return found
        finally:
            self._free.put(worker)
        reason = f"{MOST_DEATHS} processes died at one part of it, of memory or a fault"
        raise FileError(self._path, reason, remedy="Take fewer workers")


class _Worker:
    """A process, which is started when it is asked; another one where it has died."""

    def __init__(self, count: int):
        self._count, self.is_over = count, False
        self._process: subprocess.Popen[bytes] | None = None
        self._line: Connection[Any, Any] | None = None
        self._state: bytes | None = None

    def ask(self, state: bytes, task: tuple[Any, ...]) -> tuple[bool, Any]:
        """(True, the result) or (False, the error) of a task."""
        line = self._line or self._start()
        if self._state is not state:
            line.send_bytes(state)
            self._state = state
        line.send_bytes(pickle.dumps(task, pickle.HIGHEST_PROTOCOL))
        answer: tuple[bool, Any] = pickle.loads(line.recv_bytes())
        return answer

    def _start(self) -> Connection[Any, Any]:
        if self.is_over:
            raise EOFError
        here, there = Pipe()
        threads = str(max(1, (os.cpu_count() or 1) // self._count))
        environment = {"RAYON_NUM_THREADS": threads} | environment_of(self._count)
        # In a group of its own: Ctrl-C in a terminal is for the process that asks, which ends it.
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-c", _WORKER, str(there.fileno())],
            env=environment,
            stdin=subprocess.DEVNULL,
            process_group=0,
            pass_fds=[there.fileno()],
        )
        there.close()
        self._line = here
        return here

    def stop(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
        if self._line is not None:
            self._line.close()
        self._process = self._line = self._state = None

    def end(self) -> None:
        """End the process, and start none any more."""
        self.is_over = True
        if self._process is not None:
            self._process.kill()  # who waits for an answer gets none
            self._process.wait()


def main() -> None:
    """A process: `main DESCRIPTOR`; it ends when nobody asks any more."""
    line: Connection[Any, Any] = Connection(int(sys.argv[1]))
    call: Any = None
    try:
        while True:
            message = pickle.loads(line.recv_bytes())
            if callable(message):
                call = message
                continue
            try:
                answer = (True, call(*message))
            except Exception as error:
                answer = (False, error)
            try:
                packed = pickle.dumps(answer, pickle.HIGHEST_PROTOCOL)
            except Exception:  # of an error that holds what no other process can have
                packed = pickle.dumps((False, RuntimeError(f"{type(answer[1]).__name__}: {answer[1]}")))
            line.send_bytes(packed)
    except (EOFError, OSError):
        return
