"""Recordings for Rerun and Foxglove, read with the packages of those viewers."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

UTM = np.array([500_000.0, 5_400_000.0, 300.0])
COLOR = (255, 128, 0)
CLOUD, BOX, MESH = "a cloud/1", "box", "mesh"


def pose(*, degrees: float = 0.0, scale: float = 1.0, center: np.ndarray = UTM) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = scale * Rotation.from_euler("xz", [degrees, 2 * degrees], degrees=True).as_matrix()
    T[:3, 3] = center - T[:3, :3] @ center + [2.0, 0.0, 0.0]
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


def recorded(path: Path) -> Iterator[Any]:
    """Recordings of an algorithm and of all kinds of shapes, colors and poses."""
    target = loom.datasets.object_mesh().sample_points_uniformly(2_000, seed=0).translate(UTM)
    with loom.record(path) as r:
        loom.registration.registration_icp(target.translate([0.01, 0.0, 0.005]), target, 0.05)
    assert len(r.timeline.frames) > 5
    yield r
    yield record(path)[0]
    rng = np.random.default_rng(1)
    box, cloud = loom.TriangleMesh.create_box(), loom.PointCloud(rng.random((20, 3)), colors=rng.random((20, 3)))
    painted = loom.TriangleMesh(box.vertices, box.triangles, vertex_colors=rng.random((8, 3)))
    lines = loom.LineSet(rng.random((6, 3)), [[0, 1], [2, 3], [4, 5]], colors=rng.random((3, 3)))
    kinds = {0: cloud, 3: painted, 4: lines}  # of the same name
    with loom.record(path, automatic=False) as r:
        for k in range(6):
            if k in kinds:
                r.add("a", kinds[k])
            if k in (1, 4):
                r.add("b", painted)
                r.set_pose("b", pose(degrees=10.0 * k, scale=1.0 + k, center=np.ones(3)))
            r.set_pose("a", pose(degrees=20.0 * k, scale=2.0 if k == 2 else 1.0, center=np.ones(3)))
            if k == 5:
                r.remove("a")
            r.step(f"{k}")
    yield r


Shown = dict[tuple[str, str], tuple[np.ndarray, np.ndarray]]  # name, kind: world positions of corners, colors


def corners(kind: str, positions: np.ndarray, indices: Any, colors: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions and colors of all points, ends of lines or corners of triangles."""
    if kind == "points":
        return positions, np.broadcast_to(colors, positions.shape)
    rows = np.asarray(indices).ravel()
    painted = np.repeat(colors, 2, axis=0) if kind == "lines" and len(colors) > 1 else colors
    painted = painted[rows] if kind == "triangles" and len(painted) > 1 else painted
    return positions[rows], np.broadcast_to(painted, (len(rows), 3))


def expected(timeline: Any, k: int) -> Shown:
    shown: Shown = {}
    for name, placement in timeline.frames[k].shown.items():
        T = np.eye(4) if placement.pose is None else placement.pose
        for shape in (timeline.shapes[number] for number in placement.shapes):
            assert (name, shape.kind) not in shown
            positions = shape.positions @ T[:3, :3].T + T[:3, 3] + timeline.origin
            colors = np.array([shape.plain]) if shape.colors is None else shape.colors
            shown[name, shape.kind] = corners(shape.kind, positions, shape.indices, colors)
    return shown


def assert_shown(got: Shown, wanted: Shown) -> None:
    assert set(got) == set(wanted)
    for key, (positions, colors) in wanted.items():
        np.testing.assert_allclose(got[key][0], positions, rtol=0, atol=1e-5)  # float32 within 100 m of the origin
        np.testing.assert_array_equal(got[key][1], colors, err_msg=str(key))


def test_the_query_engine_of_rerun_shows_each_frame_of_a_recording(tmp_path):
    rerun = pytest.importorskip("rerun", exc_type=ImportError)
    pytest.importorskip("datafusion", exc_type=ImportError)
    path = tmp_path / "a.rrd"
    for r in recorded(path):
        command = [sys.executable, "-m", "rerun", "rrd", "verify", str(path)]
        subprocess.run(command, check=True, capture_output=True, timeout=60)
        with rerun.server.Server(datasets={"a": [path]}) as server:
            client = server.client()  # a temporary object would end before the query
            table = client.get_dataset("a").reader(index="frame", fill_latest_at=True).to_arrow_table()
        rows = sorted(table.to_pylist(), key=lambda row: row["frame"])
        timeline = r.timeline
        assert [row["frame"] for row in rows] == list(range(len(timeline.frames)))
        for k, row in enumerate(rows):
            assert_shown(shown_by_rerun(rerun, row, set(timeline.frames[k].shown)), expected(timeline, k))
            assert row["/label:TextLog:text"] == [timeline.frames[k].label]
            seconds = row["time"].total_seconds()
            np.testing.assert_allclose(seconds, k / timeline.fps, atol=1e-6)


def shown_by_rerun(rerun: Any, row: dict[str, Any], names: set[str]) -> Shown:
    """The shapes of a row of the table of all entities."""
    shown: Shown = {}
    kinds = {"Points3D": "points", "LineStrips3D": "lines", "Mesh3D": "triangles"}
    entities = {f"/scene/{rerun.escape_entity_path_part(name)}": name for name in names | {CLOUD, BOX, MESH, "a", "b"}}
    data = {"Points3D": "positions", "LineStrips3D": "strips", "Mesh3D": "vertex_positions"}
    for column, value in row.items():
        path, _, component = column.partition(":")
        archetype, _, field = component.partition(":")
        if data.get(archetype) != field or value is None or not len(value):
            continue
        entity = path.rpartition("/")[0]
        R = np.reshape(row[f"{entity}:Transform3D:mat3x3"][0], (3, 3)).T
        t = np.array(row[f"{entity}:Transform3D:translation"][0])

        def field_of(name: str, path: str = path, archetype: str = archetype) -> Any:
            return row.get(f"{path}:{archetype}:{name}")

        packed = field_of("vertex_colors" if archetype == "Mesh3D" else "colors") or field_of("albedo_factor")
        colors = np.array(packed, ">u4").view("u1").reshape(-1, 4)[:, :3]
        indices = field_of("triangle_indices")
        positions = np.array(value, float).reshape(-1, 3) @ R.T + t + row["/scene:origin"]
        if archetype == "LineStrips3D":
            indices = np.arange(len(positions))
        key = entities[entity], kinds[archetype]
        assert key not in shown
        shown[key] = corners(kinds[archetype], positions, indices, colors)
    return shown


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


def test_the_reader_of_mcap_shows_each_frame_of_a_recording(tmp_path):
    pytest.importorskip("foxglove", exc_type=ImportError)
    path = tmp_path / "a.mcap"
    for r in recorded(path):
        timeline, topics = r.timeline, read_mcap(path)
        for k in range(len(timeline.frames)):
            time = k / timeline.fps + 1e-6
            assert_shown(shown_by_foxglove(topics, time), expected(timeline, k))
        assert [message.message for _, message in topics["/label"]] == [frame.label for frame in timeline.frames]
        times = [time for time, _ in topics["/label"]]
        np.testing.assert_allclose(times, np.arange(len(times)) / timeline.fps, atol=1e-6)


def shown_by_foxglove(topics: dict[str, list[tuple[float, Any]]], end: float) -> Shown:
    """The shapes at a time, by the newest transforms, clouds and entities."""
    poses: dict[str, np.ndarray] = {}
    for time, tf in topics["/tf"]:
        if time <= end:
            T, q = np.eye(4), tf.rotation
            T[:3, :3] = Rotation.from_quat([q.x, q.y, q.z, q.w]).as_matrix()
            T[:3, 3] = xyz(tf.translation)
            poses[tf.child_frame_id] = T if tf.parent_frame_id == "world" else poses[tf.parent_frame_id] @ T
    shown: Shown = {}

    def show(key: tuple[str, str], frame: str, positions: Any, indices: Any, colors: Any) -> None:
        placed = np.asarray(positions) @ poses[frame][:3, :3].T + poses[frame][:3, 3]
        shown[key] = corners(key[1], placed, indices, np.rint(colors).astype(int))

    entities: dict[str, Any] = {}
    for topic, messages in topics.items():
        past = [message for time, message in messages if time <= end]
        if topic.startswith("/points/") and past and len(past[-1].data):
            rows = np.frombuffer(past[-1].data, [("xyz", "<f4", 3), ("rgba", "u1", 4)])
            assert rows.itemsize == past[-1].point_stride
            show((topic.removeprefix("/points/"), "points"), past[-1].frame_id, rows["xyz"], None, rows["rgba"][:, :3])
        for message in past if topic == "/scene" else ():
            for deletion in message.deletions:
                entities.pop(deletion.id, None)
            entities.update({entity.id: entity for entity in message.entities})
    for name, entity in entities.items():
        for kind, primitives in (("lines", entity.lines), ("triangles", entity.triangles)):
            for part in primitives:
                colors = [[255 * color.r, 255 * color.g, 255 * color.b] for color in part.colors]
                positions = np.array([xyz(point) for point in part.points])
                if kind == "lines":
                    shown_colors = np.rint(colors).astype(int)
                    placed = positions @ poses[entity.frame_id][:3, :3].T + poses[entity.frame_id][:3, 3]
                    shown[name, kind] = placed, shown_colors
                else:
                    show((name, kind), entity.frame_id, positions, part.indices, colors)
    return shown


@pytest.mark.parametrize(("suffix", "module"), [(".rrd", "rerun"), (".mcap", "foxglove")])
def test_a_notebook_shows_the_last_frame_of_a_recording_for_another_viewer(tmp_path, suffix, module):
    pytest.importorskip(module, exc_type=ImportError)
    r, _ = record(tmp_path / f"a{suffix}")
    output = r._repr_mimebundle_()
    assert "image/jpeg" in output
    assert f"a{suffix}" in output["text/html"]
    assert "<iframe" not in output["text/html"]
