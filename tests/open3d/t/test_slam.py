"""Frame-to-model tracking of tensor images against the true poses of a synthetic room."""

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as bridge

WIDTH, HEIGHT, FARTHEST = 96, 72, 6.0


def test_a_model_tracks_a_camera_as_the_example_of_dense_slam(device):
    views = loom.datasets.room_frames(48, width=WIDTH, height=HEIGHT)[:3]
    slam, Tensor, where = bridge.t.pipelines.slam, bridge.core.Tensor, bridge.core.Device(device.upper())
    K = Tensor(np.asarray(views[0].intrinsic.matrix))
    model = slam.Model(0.03, 16, 1000, Tensor(np.eye(4)), where)
    given, rendered = (slam.Frame(HEIGHT, WIDTH, K, where) for _ in range(2))
    T_world_camera = np.eye(4)
    for i, view in enumerate(views):
        depth = Tensor((view.depth * 1000).round().astype(np.uint16))
        given.set_data_from_image("depth", bridge.t.geometry.Image(depth))
        given.set_data("color", Tensor(np.ascontiguousarray(view.color)))
        if i:
            found = model.track_frame_to_model(given, rendered, 1000.0, FARTHEST, 0.07)
            T_world_camera = T_world_camera @ found.transformation.numpy()
        model.update_frame_pose(i, T_world_camera)
        model.integrate(given, 1000.0, FARTHEST, 8.0)
        model.synthesize_model_frame(rendered, 1000.0, 0.1, FARTHEST, 8.0, i == 2)
    true = np.linalg.inv(views[0].T_world_camera) @ views[2].T_world_camera
    assert np.linalg.norm(true[:3, 3]) > 0.05
    assert np.allclose(model.get_current_frame_pose().numpy(), true, atol=8e-3)
    depth = rendered.get_data("depth")
    assert depth.device == where and depth.shape == (HEIGHT, WIDTH, 1)
    assert rendered.get_data_as_image("color").columns == WIDTH
    seen = (depth.numpy()[..., 0] > 0) & (views[2].depth < FARTHEST)
    assert seen.mean() > 0.4
    assert np.median(np.abs(depth.numpy()[..., 0] / 1000 - views[2].depth)[seen]) < 0.015
    cloud, mesh = model.extract_pointcloud(2.0), model.extract_trianglemesh(2.0)
    assert len(cloud.point.positions.numpy()) > 1000 and len(mesh.vertex.positions.numpy()) > 1000
    assert model.frame_id == 2 and slam.Model(model).voxel_grid is model.voxel_grid


def test_frames_and_models_explain_what_is_missing():
    slam = bridge.t.pipelines.slam
    frame = slam.Frame(3, 4, np.eye(3), "CPU:0")
    assert (frame.height(), frame.width()) == (3, 4)
    with pytest.raises(KeyError, match="depth"):
        frame.get_data("depth")
    with pytest.raises(AttributeError, match="voxel_grid"):
        slam.Model(0.01, device="CPU:0").frustum_block_coords  # noqa: B018
    with pytest.raises(AttributeError, match="run_slac_optimizer_for_fragments"):
        bridge.t.pipelines.slac  # noqa: B018
