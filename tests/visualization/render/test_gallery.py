"""The gallery draws each step of the tutorial, with more than one color besides the background."""

import runpy
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom

STEPS = runpy.run_path(str(Path(__file__).parents[3] / "docs" / "gallery.py"))["STEPS"]


@pytest.mark.slow
@pytest.mark.parametrize("step", STEPS, ids=lambda step: step.__name__)
def test_each_step_has_a_picture(step):
    image = loom.render(size=(160, 120), **step())
    covered = (image != 255).any(axis=2).mean()
    shades = np.unique(image.reshape(-1, 3), axis=0)
    assert 0.1 < covered < 0.9 and len(shades) > 100
