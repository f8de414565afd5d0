"""Gradients of the splat training prototype, benchmarks/splat_training.py, follow the equations."""

import importlib.util
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"


@pytest.fixture(scope="module")
def training():
    """The module, which imports its neighbor by name."""
    sys.path.insert(0, str(FOLDER))
    spec = importlib.util.spec_from_file_location("splat_training", FOLDER / "splat_training.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    yield module
    sys.path.remove(str(FOLDER))
    sys.modules.pop("splat_gradients", None)


@pytest.mark.slow
def test_gradients_are_differences_of_a_float64_picture(training, device):
    assert training.largest_differences(device).max() < 1e-5
