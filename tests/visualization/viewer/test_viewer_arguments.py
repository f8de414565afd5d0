"""Every argument of the viewer's calls rejects invalid values with an error that names it; clouds of all kinds."""

from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, hostile_clouds, read_table, warnings_of
from .stand_in import page_in

CALLS = """
viewer.add(name="cloud", geometry=cloud)
viewer.add(name="cloud", geometry=cloud, color=(1, 0, 0), color_by="height", colormap="jet", limits=(0, 1), point_size=2.0, line_width=1.0, pose=pose)
viewer.add_all(geometries=[cloud])
viewer.update(name="cloud", geometry=cloud)
viewer.remove(name="cloud")
viewer.set_pose(name="cloud", T=pose)
viewer.set_visible(name="cloud", visible=True)
viewer.set_view(view=None)
viewer.set_view(zoom=0.5, front=(0, 0, 1), lookat=(0, 0, 0), up=(0, 1, 0), field_of_view=60.0)
viewer.get_view(client=None)
viewer.color_by(by="height", colormap="jet", limits=(0, 1))
loom.Viewer(port=0, max_points=10, point_size=3.0, background=(1, 1, 1))
"""  # noqa: E501
CASES = []
for line in CALLS.strip().splitlines():
    ((function, expressions),) = read_table(line, {}).values()
    CASES += [(function, expressions, name) for name in expressions if name not in ("visible", "port")]
# Accepted names in messages.
WORDS = {"name": "geometries", "geometries": "points", "geometry": "geometries|points", "color_by": "by"}


@pytest.fixture(scope="module")
def viewer():
    with loom.Viewer(port=0) as viewer:
        yield viewer


@pytest.mark.parametrize(("function", "expressions", "argument"), CASES, ids=lambda value: str(value)[:24])
def test_a_hostile_value_is_refused_by_name(viewer, function, expressions, argument):
    cloud = loom.PointCloud(np.random.default_rng(0).random((60, 3)))
    things: dict[str, Any] = {"viewer": viewer, "loom": loom, "cloud": cloud, "pose": np.eye(4)}

    def call(**given: Any) -> None:
        viewer.clear()
        viewer.add("cloud", cloud)
        made = eval(function, things)(**given)
        if isinstance(made, loom.Viewer):
            made.close()

    good = {name: eval(value, things) for name, value in expressions.items()}
    call(**good)
    faults = faults_of(call, good, argument, also=WORDS.get(argument, ""))
    assert not faults, "\n".join(faults)


def test_clouds_of_all_kinds_are_shown_without_a_warning(viewer):
    with page_in(viewer):
        for title, cloud in hostile_clouds().items():

            def show(cloud=cloud):
                viewer.clear()
                viewer.add("cloud", cloud)
                viewer.show_normals(True)
                viewer.color_by("height")
                viewer.update("cloud", cloud)
                viewer.color_by(None)
                viewer.show_normals(False)

            assert warnings_of(show) == [], title
