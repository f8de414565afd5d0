"""Exceptions of signal handlers leave operations on files unchanged."""

import functools
import signal

import pytest

import pointloom as loom
from pointloom.io.frames.depth_cameras import driver_errors
from pointloom.io.optional_imports import foreign_errors, ignored_errors
from pointloom.io.source import content_errors


class Late(ValueError):  # noqa: N818
    """A time limit of the program."""


class Panic(BaseException):
    """An error of a package in Rust."""


Panic.__name__, Panic.__module__ = "PanicException", "pyo3_runtime"


def late(*_):
    raise Late("time is up")


class Limit:
    def __call__(self, number, frame):
        late()

    def end(self, number, frame):
        late()


@pytest.fixture(
    params=[late, functools.partial(late, 1), Limit(), Limit().end], ids=["def", "partial", "call", "bound"]
)
def handler(request):
    old = signal.signal(signal.SIGUSR1, request.param)
    yield
    signal.signal(signal.SIGUSR1, old)


@pytest.mark.parametrize(
    ("error", "expected"),
    [
        (ValueError("bad"), loom.FileError),
        (OSError(5, "bad"), loom.FileError),
        (Panic("bad"), loom.FileError),
        (MemoryError(), MemoryError),
        (KeyboardInterrupt(), KeyboardInterrupt),
        (SystemExit(3), SystemExit),
        (BaseException("time is up"), BaseException),
    ],
    ids=repr,
)
def test_errors_of_packages_become_file_errors_and_nothing_else_does(error, expected):
    with pytest.raises(expected) as caught, foreign_errors("cloud.laz", "damaged"):
        raise error
    assert type(caught.value) is expected


GUARDS = {
    "foreign": lambda: foreign_errors("cloud.laz", "damaged"),
    "ignored": ignored_errors,
    "driver": lambda: driver_errors("camera", "Plug it in"),
    "content": lambda: content_errors("cloud.ply"),
}


@pytest.mark.parametrize("guard", GUARDS)
@pytest.mark.parametrize("wraps", [False, True])
def test_exceptions_of_signal_handlers_pass_through_packages(handler, wraps, guard):
    with pytest.raises(Late), GUARDS[guard]():
        try:
            signal.raise_signal(signal.SIGUSR1)
        except Late as error:
            if wraps:
                raise ArithmeticError("cannot decode") from error
            raise


def test_a_damaged_file_that_is_read_while_a_time_limit_is_handled_is_called_damaged(handler):
    try:
        signal.raise_signal(signal.SIGUSR1)
    except Late:
        with pytest.raises(loom.FileError, match=r"cloud\.laz"), foreign_errors("cloud.laz", "damaged"):
            raise ValueError("bad")  # noqa: B904
