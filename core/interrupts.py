"""Exceptions that a signal handler of the program raised, and that other code caught or replaced."""

from __future__ import annotations

import functools
import signal
from types import CodeType
from typing import Any


def signal_exception(error: BaseException, handled: BaseException | None = None) -> BaseException | None:
    """Find the exception that a signal handler raised among an error and its causes.

    A handler runs between any two operations, so its exception (a time limit, a request to stop) passes through code
    that reads or writes a file. It must not be reported as a damaged file.

    Args:
        error: The error that was caught.
        handled: An exception that was being handled before the operation began. It is not searched.

    Returns:
        The exception whose traceback contains a current signal handler, a KeyboardInterrupt or SystemExit, or None.
    """
    handlers = _handler_codes()
    seen: set[int] = set()
    link: BaseException | None = error
    while link is not None and link is not handled and id(link) not in seen:
        seen.add(id(link))
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


def _code_of(handler: Any) -> CodeType | None:
    while isinstance(handler, functools.partial):
        handler = handler.func
    for function in (handler, getattr(handler, "__func__", None), vars(type(handler)).get("__call__")):
        code = getattr(function, "__code__", None)
        if isinstance(code, CodeType):
            return code
    return None
