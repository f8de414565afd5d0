"""Where pages look from at first: what stands upright is that of the geometry, or what the program said."""

import numpy as np
import pytest

import pointloom as loom


def test_the_first_view_stands_upright():
    cone = loom.TriangleMesh.create_cone(0.5, 4.0)
    with loom.Viewer(port=0) as viewer:
        viewer.add("cone", cone)
        assert upwards(viewer) == "z"
        viewer.remove("cone")
        cone.up = "y"
        viewer.add("cone", cone)
        assert upwards(viewer) == "y"
        viewer.up = "x"
        assert viewer.up == (1.0, 0.0, 0.0) and upwards(viewer) == "x"
        with pytest.raises(ValueError, match="up: expected x, y, z or a direction"):
            viewer.up = "down"


def upwards(viewer):
    """The axis that points upwards the most in the first view."""
    return "xyz"[int(np.argmax(-viewer.home().T_world_camera[:3, 1]))]
