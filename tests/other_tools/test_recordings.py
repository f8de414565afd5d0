"""Recordings for Rerun and Foxglove, read with the packages of those viewers."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

UTM = np.array([500_000.0, 5_400_000.0, 300.0])
COLOR = (255, 128, 0)
CLOUD, BOX, MESH = "a cloud/1", "box", "mesh"


def pose(*, degrees: float = 0.0, scale: float = 1.0) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = scale * Rotation.from_euler("xz", [degrees, 2 * degrees], degrees=True).as_matrix()
    T[:3, 3] = UTM - T[:3, :3] @ UTM + [2.0, 0.0, 0.0]
    return T


def record(path) -> tuple[Any, np.ndarray]:
    """Five steps: a cloud, its motion, a mesh and lines, a scaled mesh, no cloud. The recorder and points."""
    points = np.random.default_rng(0).random((50, 3)) + UTM
    cloud = loom.PointCloud(points, colors=np.tile(np.array(COLOR) / 255, (50, 1)))
    with loom.record(path, automatic=False, fps=4.0, title="a test") as r:
        r.add(CLOUD, cloud)
        r.plot("fitness", 0.5)
        r.step("first")
        r.set_pose(CLOUD, pose(degrees=30.0))
        r.step("second")
        r.add(MESH, loom.TriangleMesh.create_box().translate(UTM), color=(1, 0, 0))
        r.add(BOX, cloud.get_axis_aligned_bounding_box())
        r.step("third")
        r.set_pose(MESH, pose(scale=2.0))
        r.step("fourth")
        r.remove(CLOUD)
        r.step("fifth")
    return r, points


def test_a_recording_of_rerun_has_each_shape_once_and_each_pose(tmp_path):
    pytest.importorskip("rerun", exc_type=ImportError)
    from rerun.chunk import RrdReader

    r, points = record(tmp_path / "a.rrd")
    columns: dict[tuple[str, str], list[tuple[int | None, Any]]] = {}
    for chunk in RrdReader(tmp_path / "a.rrd").stream():
        rows = chunk.to_record_batch().to_pydict()
        for name in rows:
            frames = rows.get("frame", [None] * chunk.num_rows)
            columns.setdefault((chunk.entity_path, name), []).extend(zip(frames, rows[name], strict=True))
    scene, origin = "/scene/a\\ cloud\\/1", columns["/scene", "origin"][0][1]
    ((frame, positions),) = columns[f"{scene}/0", "Points3D:positions"]
    assert frame == 0
    np.testing.assert_allclose(np.array(positions) + origin, points, atol=1e-6)
    assert set(columns[f"{scene}/0", "Points3D:colors"][0][1]) == {int.from_bytes(bytes([*COLOR, 255]), "big")}
    turns, steps = columns[scene, "Transform3D:mat3x3"], columns[scene, "Transform3D:translation"]
    assert [frame for frame, _ in turns] == [0, 1, 4]  # where it changes
    T = r.timeline.frames[1].shown[CLOUD].pose
    np.testing.assert_allclose(np.reshape(turns[1][1], (3, 3)).T, T[:3, :3], atol=1e-6)
    np.testing.assert_allclose(steps[1][1], [T[:3, 3]], atol=1e-6)
    assert [frame for frame, _ in columns[scene, "Clear:is_recursive"]] == [0, 4]
    assert [frame for frame, _ in columns["/scene/mesh/0", "Mesh3D:vertex_positions"]] == [2]
    assert len(columns["/scene/box/0", "LineStrips3D:strips"][0][1]) == 12
    assert columns["/plots/fitness", "Scalars:scalars"] == [(0, [0.5])]
    assert [text for _, (text,) in columns["/label", "TextLog:text"]] == ["first", "second", "third", "fourth", "fifth"]


class JsonDecoder:
    """For the plotted numbers."""

    def decoder_for(self, encoding, schema):
        return json.loads if encoding == "json" else None


def read_mcap(path) -> dict[str, list[tuple[float, Any]]]:
    """The messages of each topic with their time [s]."""
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory

    topics: dict[str, list[tuple[float, Any]]] = {}
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory(), JsonDecoder()])
        for _, channel, raw, message in reader.iter_decoded_messages():
            topics.setdefault(channel.topic, []).append((raw.log_time / 1e9, message))
    return topics


def xyz(message: Any) -> list[float]:
    return [message.x, message.y, message.z]


def test_a_recording_of_foxglove_has_each_shape_once_and_each_pose(tmp_path):
    pytest.importorskip("foxglove", exc_type=ImportError)
    r, points = record(tmp_path / "a.mcap")
    topics = read_mcap(tmp_path / "a.mcap")
    origin = xyz(topics["/tf"][0][1].translation)
    (time, cloud), (end, empty) = topics[f"/points/{CLOUD}"]
    assert (time, end, cloud.frame_id, len(empty.data)) == (0.0, 1.0, CLOUD, 0)
    fields = [(field.name, field.offset, field.type) for field in cloud.fields]
    kind = np.dtype([(name, "<f4" if code == 7 else "u1") for name, _, code in fields])
    assert [offset for _, offset, _ in fields] == [kind.fields[name][1] for name in kind.names]
    rows = np.frombuffer(cloud.data, kind)
    np.testing.assert_allclose(np.stack([rows[axis] for axis in "xyz"], 1) + origin, points, atol=1e-6)
    assert [rows[name][0] for name in ("red", "green", "blue", "alpha")] == [*COLOR, 255]
    moves = [(time, tf) for time, tf in topics["/tf"] if tf.child_frame_id == CLOUD]
    assert [time for time, _ in moves] == [0.0, 0.25, 1.0]
    T, turn = r.timeline.frames[1].shown[CLOUD].pose, moves[1][1].rotation
    R = Rotation.from_quat([turn.x, turn.y, turn.z, turn.w]).as_matrix()
    np.testing.assert_allclose(R, T[:3, :3], atol=1e-9)
    np.testing.assert_allclose(xyz(moves[1][1].translation), T[:3, 3], atol=1e-9)
    entities = {(time, entity.id): entity for time, update in topics["/scene"] for entity in update.entities}
    assert set(entities) == {(0.5, MESH), (0.5, BOX), (0.75, MESH)}  # a scaled pose is applied to the vertices
    for time, frame in ((0.5, 2), (0.75, 3)):
        mesh, T = entities[time, MESH].triangles[0], r.timeline.frames[frame].shown[MESH].pose
        corners = np.array([xyz(point) for point in mesh.points])
        size = 1.0 if frame == 2 else 2.0
        np.testing.assert_allclose(np.ptp(corners, axis=0), [size] * 3, atol=1e-5)
        assert len(mesh.indices) == 36
        assert (mesh.colors[0].r, mesh.colors[0].g) == (1.0, 0.0)
    assert entities[0.75, MESH].frame_id == "scene"
    assert len(entities[0.5, BOX].lines[0].points) == 24
    assert topics["/plots"] == [(0.0, {"fitness": 0.5})]
    assert [message.message for _, message in topics["/label"]] == ["first", "second", "third", "fourth", "fifth"]


@pytest.mark.parametrize(("suffix", "module"), [(".rrd", "rerun"), (".mcap", "foxglove")])
def test_a_notebook_shows_the_last_frame_of_a_recording_for_another_viewer(tmp_path, suffix, module):
    pytest.importorskip(module, exc_type=ImportError)
    r, _ = record(tmp_path / f"a{suffix}")
    output = r._repr_mimebundle_()
    assert "image/jpeg" in output
    assert f"a{suffix}" in output["text/html"]
    assert "<iframe" not in output["text/html"]
