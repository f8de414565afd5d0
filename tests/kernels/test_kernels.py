"""Conventions for every kernel: it is exported by its package, has few parameters, and has a name of a kernel."""

import importlib
import pkgutil
from functools import cache

import pytest

from pointloom import kernels
from pointloom.kernels.lang import Func, Kernel, Loop, Reduction


@cache
def modules():
    names = [module.name for module in pkgutil.walk_packages(kernels.__path__, "pointloom.kernels.")]
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
        value.resolve()
