"""The box around many boxes is that around all of them, however they come, move and go."""

import numpy as np

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
