"""The gallery draws each step of the tutorial, with more than one color besides the background."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom

GALLERY = Path(__file__).parents[3] / "docs" / "gallery.py"


def load():
    spec = importlib.util.spec_from_file_location("gallery", GALLERY)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


gallery = load()


@pytest.mark.slow
@pytest.mark.parametrize("step", gallery.STEPS, ids=lambda step: step.__name__)
def test_each_step_has_a_picture(step):
    image = loom.render(size=(160, 120), **step())
    covered = (image != 255).any(axis=2).mean()
    shades = np.unique(image.reshape(-1, 3), axis=0)
    assert 0.1 < covered < 0.9 and len(shades) > 100
