"""The node of docs/other-tools.md with stand-ins for the modules of ROS 2, which has no wheels."""

from __future__ import annotations

import sys
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

from ..page_blocks import blocks_of

STEP, SCANS = 0.3, 11  # [m] between scans
DEGREES = 2.0  # between scans


def room() -> np.ndarray:
    """Points on the walls, the floor and the ceiling of a room of 16 x 16 x 5 m."""
    rng = np.random.default_rng(0)
    points = rng.uniform(-8, 8, (12_000, 3)) * [1, 1, 0.3]
    rows = np.arange(len(points))
    points[rows, rows % 3] = np.where(rng.random(len(points)) < 0.5, -1, 1) * np.array([8.0, 8.0, 2.5])[rows % 3]
    return points


def true_pose(k: int) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("z", DEGREES * k, degrees=True).as_matrix()
    T[0, 3] = STEP * k
    return T


def module(name: str, **members: Any) -> ModuleType:
    made = ModuleType(name)
    vars(made).update(members)
    return made


def odometry_message(**fields: Any) -> SimpleNamespace:
    """A message with the fields of nav_msgs/Odometry that the node uses."""
    position, orientation = SimpleNamespace(), SimpleNamespace()
    pose = SimpleNamespace(pose=SimpleNamespace(position=position, orientation=orientation), covariance=None)
    return SimpleNamespace(pose=pose, **fields)


class Node:
    def __init__(self, name: str):
        self.name, self.published, self.subscribed = name, {}, {}

    def create_publisher(self, kind: Any, topic: str, depth: int) -> SimpleNamespace:
        return SimpleNamespace(publish=self.published.setdefault(topic, []).append)

    def create_subscription(self, kind: Any, topic: str, callback: Any, profile: Any) -> None:
        self.subscribed[topic] = callback


@pytest.fixture
def nodes(monkeypatch) -> list[Node]:
    """The nodes that a program spins. Each receives the scans of a moving sensor."""
    spun: list[Node] = []

    def spin(node: Node) -> None:
        for k in range(SCANS):
            T = np.linalg.inv(true_pose(k))
            points = (room() @ T[:3, :3].T + T[:3, 3]).astype(np.float32)
            header = SimpleNamespace(frame_id="lidar", stamp=k)
            node.subscribed["points"](SimpleNamespace(header=header, points=points))
        spun.append(node)

    def read_points_numpy(message: Any, field_names: tuple[str, ...], skip_nans: bool) -> np.ndarray:
        assert field_names == ("x", "y", "z")
        assert skip_nans
        return message.points

    clouds = module(
        "point_cloud2", read_points_numpy=read_points_numpy, create_cloud_xyz32=lambda header, points: (header, points)
    )
    for made in (
        module("rclpy", init=lambda: None, spin=spin),
        module("rclpy.node", Node=Node),
        module("rclpy.qos", qos_profile_sensor_data=object()),
        module("nav_msgs"),
        module("nav_msgs.msg", Odometry=odometry_message),
        module("sensor_msgs"),
        module("sensor_msgs.msg", PointCloud2=object),
        module("sensor_msgs_py", point_cloud2=clouds),
    ):
        monkeypatch.setitem(sys.modules, made.__name__, made)
    return spun


def test_the_node_publishes_poses_of_the_sensor_and_a_map(nodes):
    (block,) = [block for block in blocks_of("docs/other-tools.md") if "test_ros_node" in (block.reason or "")]
    assert len(block.code.strip().splitlines()) <= 40
    exec(compile(block.source(), block.page, "exec"), {"__name__": "page"})
    (node,) = nodes
    messages = node.published["odometry"]
    assert len(messages) == SCANS
    types = get_typestore(Stores.ROS2_HUMBLE).types
    for k, message in enumerate(messages):
        assert set(vars(message)) <= set(types["nav_msgs/msg/Odometry"].__dataclass_fields__)
        assert (message.header.frame_id, message.child_frame_id) == ("odom", "lidar")
        position, turn = message.pose.pose.position, message.pose.pose.orientation
        T = true_pose(k)
        np.testing.assert_allclose([position.x, position.y, position.z], T[:3, 3], atol=0.02)
        R = Rotation.from_quat([turn.x, turn.y, turn.z, turn.w])
        assert np.degrees((R * Rotation.from_matrix(T[:3, :3]).inv()).magnitude()) < 0.2
        assert np.shape(message.pose.covariance) == (36,)
    position_variances = np.array([message.pose.covariance[[0, 7, 14]] for message in messages[1:]])
    assert (position_variances > 0).all()
    ((header, points),) = node.published["map"]
    assert header.frame_id == "odom"
    assert np.abs(np.abs(points).max(axis=0) - [8.0, 8.0, 2.5]).max() < 0.1
