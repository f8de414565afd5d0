"""Every kernel, function, reduction and loop of the package is in the kernel language."""

import importlib
import pkgutil
from functools import cache

import pytest

from pointloom import kernels
from pointloom.kernels.lang import Func, Kernel, Loop, Reduction


@cache
def modules():
    names = [module.name for module in pkgutil.walk_packages(kernels.__path__, "pointloom.kernels.")]
    return [importlib.import_module(name) for name in names]


# Each kernel and function is checked at its first use, too, and by `make check-cuda`.
@pytest.mark.parametrize(
    "kind", [*(pytest.param(kind, marks=pytest.mark.slow) for kind in (Kernel, Func, Reduction)), Loop]
)
def test_everything_is_in_the_language(kind):
    for value in (value for module in modules() for value in vars(module).values() if isinstance(value, kind)):
        value.resolve()
