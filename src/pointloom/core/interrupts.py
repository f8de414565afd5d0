"""Find exceptions of signal handlers that other code caught or replaced."""

from __future__ import annotations

import functools
import signal
from types import CodeType


def signal_exception(error: BaseException, handled: BaseException | None = None) -> BaseException | None:
    """The exception of a signal handler, KeyboardInterrupt or SystemExit among an error and its causes, or None.
    A handler may run inside code that reads or writes a file. Its exception must not be reported as a damaged file.
    `handled` was already being handled and is not searched."""
    handlers = _handler_codes()
    visited: set[int] = set()
    link: BaseException | None = error
    while link is not None and link is not handled and id(link) not in visited:
        visited.add(id(link))
        if isinstance(link, KeyboardInterrupt | SystemExit):
            return link
        trace = link.__traceback__
        while trace is not None:
            if trace.tb_frame.f_code in handlers:
                return link
            trace = trace.tb_next
        link = link.__cause__ or link.__context__
    return None


def _handler_codes() -> set[CodeType]:
    codes = (_code_of(signal.getsignal(number)) for number in signal.valid_signals())
    return {code for code in codes if code is not None}


def _code_of(handler: object) -> CodeType | None:
    while isinstance(handler, functools.partial):
        handler = handler.func
    for function in (handler, getattr(handler, "__func__", None), vars(type(handler)).get("__call__")):
        code = getattr(function, "__code__", None)
        if isinstance(code, CodeType):
            return code
    return None
