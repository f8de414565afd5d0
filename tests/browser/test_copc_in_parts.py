"""A COPC file in Chromium: coarse levels come first, and finer nodes are read for close views."""

from __future__ import annotations

import numpy as np

import pointloom as loom

from .pixels import count_pixels, see
from .viewer_scenes import RED

UTM = np.array([448_500.0, 5_412_200.0, 300.0])
COUNT, BUDGET = 300_000, 70_000
AT = UTM + np.array([190.0, 190.0, 0.0])


def test_coarse_points_come_first_and_finer_nodes_after_zooming(open_page, tmp_path):
    rng = np.random.default_rng(3)
    points = np.column_stack([rng.random((COUNT, 2)) * 500, rng.random(COUNT)]) + UTM
    path = tmp_path / "city.copc.laz"
    loom.write_point_cloud(path, loom.PointCloud(points, colors=np.tile(np.array(RED, np.uint8), (COUNT, 1))))
    with loom.Viewer(port=0, max_points=BUDGET, point_size=1.0) as viewer:
        viewer.set_view(front=(0, 0, 1), up=(0, 1, 0), lookat=AT, zoom=0.7)
        viewer.add_copc("city", path)
        tree = viewer.scene.shown["city"].tree
        coarse = tree.nodes.nodes_read
        page = open_page(viewer, width=900, height=700)
        assert count_pixels(see(page), RED) > 0
        (session,) = viewer.sessions.values()
        stream = session.streams["city"]
        assert 0 < stream.drawn <= BUDGET < COUNT
        assert coarse <= tree.nodes.nodes_read < len(tree) / 2
        read = tree.nodes.nodes_read
        viewer.set_view(front=(0, 0, 1), up=(0, 1, 0), lookat=AT, zoom=0.08)
        assert count_pixels(see(page), RED) > 0
        assert read < tree.nodes.nodes_read < len(tree) and stream.drawn <= BUDGET
