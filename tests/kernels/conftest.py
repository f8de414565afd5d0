"""What the tests of kernels share: the table of tolerances."""

import importlib.util
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def tolerances():
    """The values of tests/tolerances.py by name."""
    spec = importlib.util.spec_from_file_location("tolerances", Path(__file__).parents[1] / "tolerances.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.Tolerances()
