"""The box around many boxes is that around all of them, however they come, move and go."""

import numpy as np
import pytest

from pointloom.drawing.viewer.extents import Extents


def test_the_union_is_that_of_all_boxes_after_each_of_many_changes(rng):
    extents, boxes = Extents(), {}
    for _ in range(400):
        name = f"box {rng.integers(40)}"
        if rng.random() < 0.3:
            extents.drop(name)
            boxes.pop(name, None)
        else:
            low = rng.integers(-5, 5, 3).astype(float)
            boxes[name] = low, low + rng.integers(0, 3, 3)
            extents.put(name, boxes[name])
        found = extents.union()
        assert len(extents) == len(boxes)
        if not boxes:
            assert found is None
            continue
        assert (found[0] == np.min([low for low, _ in boxes.values()], axis=0)).all()
        assert (found[1] == np.max([high for _, high in boxes.values()], axis=0)).all()
    corners = extents.corners()
    assert corners.shape == (8 * len(boxes), 3)
    assert {tuple(corner) for corner in corners} >= {tuple(low) for low, _ in boxes.values()}


@pytest.mark.parametrize("count", [3, 300])
def test_all_boxes_are_looked_at_only_when_one_leaves_the_border_and_somebody_asks(count, monkeypatch):
    extents = Extents()
    for k in range(count):
        extents.put(f"{k}", (np.full(3, k), np.full(3, k + 1.0)))
    monkeypatch.setattr(extents, "_ends", extents._ends.view(Counted))
    Counted.mins = 0
    extents.union()
    extents.put("1", (np.full(3, 1.5), np.full(3, 1.6)))  # within
    extents.put("new", (np.full(3, -7.0), np.full(3, -6.0)))  # beyond
    extents.union()
    assert Counted.mins == 0
    for _ in range(5):
        extents.put("new", (np.full(3, 1.0), np.full(3, 1.2)))
        extents.put("new", (np.full(3, -7.0), np.full(3, -6.0)))
    assert Counted.mins == 0
    extents.drop("new")
    assert (extents.union()[0] == 0).all()
    extents.union()
    assert Counted.mins == 1


class Counted(np.ndarray):
    """An array that counts how often it is searched through."""

    mins = 0

    def min(self, *given, **more):
        Counted.mins += 1
        return np.asarray(self).min(*given, **more)
