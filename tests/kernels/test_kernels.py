"""What holds for every kernel: it is in the language, has few parameters, and a name that says that it is one."""

import importlib
import pkgutil
from functools import cache

import pytest

from pointloom import kernels
from pointloom.kernels.lang import Func, Kernel, Loop, Reduction

MOST_PARAMETERS = 14  # several that are one thing are a structure; more than these want a reason here


@cache
def modules():
    names = [found.name for found in pkgutil.walk_packages(kernels.__path__, "pointloom.kernels.")]
    return {name: importlib.import_module(name) for name in names}


def device_code(kind):
    for module, content in modules().items():
        yield from ((f"{module}.{name}", value) for name, value in vars(content).items() if isinstance(value, kind))


# Each kernel and function is checked at its first use, too, and by `make check-cuda`.
@pytest.mark.parametrize(
    "kind", [*(pytest.param(kind, marks=pytest.mark.slow) for kind in (Kernel, Func)), Reduction, Loop]
)
def test_everything_is_in_the_language(kind):
    for _, value in device_code(kind):
        value.settle()


@pytest.mark.parametrize("kind", [Kernel, Reduction, Func])
def test_nothing_takes_more_parameters_than_one_can_follow(kind):
    assert {name for name, value in device_code(kind) if value.written.__code__.co_argcount > MOST_PARAMETERS} == set()


def test_kernels_are_called_so():
    assert {name for name, _ in device_code(Kernel) if not name.endswith("_kernel")} == set()
