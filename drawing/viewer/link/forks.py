"""Sockets that a child of this process must not keep: `own_port`, `disown_port`.

A forked child (a worker of a data loader, of `multiprocessing`) has every open socket too. While it lived, the port
of a viewer that was closed stayed taken, and browsers waited for an answer that nobody would give.
"""

from __future__ import annotations

import contextlib
import os
import socket
import stat
import weakref
from pathlib import Path
from typing import Protocol


class Owner(Protocol):
    """A server of this process."""

    port: int

    def forget(self) -> None:
        """Be closed, in a child: nothing serves there, and the sockets are closed already."""


_owners: weakref.WeakSet[Owner] = weakref.WeakSet()


def own_port(server: Owner) -> None:
    """Have children let go of all sockets at the server's port, those of its pages too, and of the server."""
    _owners.add(server)


def disown_port(server: Owner) -> None:
    """The port is closed."""
    _owners.discard(server)


def _after_fork_in_child() -> None:
    owners = list(_owners)
    _owners.clear()
    if not owners:
        return
    ports = {server.port for server in owners}
    nothing = os.open(os.devnull, os.O_RDWR | os.O_CLOEXEC)
    for entry in Path("/dev/fd").iterdir():
        number = int(entry.name)
        with contextlib.suppress(OSError):
            if stat.S_ISSOCK(os.fstat(number).st_mode) and _port_of(number) in ports:
                os.dup2(nothing, number, inheritable=False)  # the number stays, for objects that close it once more
    os.close(nothing)
    for server in owners:
        server.forget()


def _port_of(number: int) -> int | None:
    with socket.socket(fileno=os.dup(number)) as one:
        is_internet = one.family in (socket.AF_INET, socket.AF_INET6)
        return int(one.getsockname()[1]) if is_internet else None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork_in_child)
