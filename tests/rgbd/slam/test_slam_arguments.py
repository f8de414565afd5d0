"""Every argument of every public call of dense SLAM refuses what makes no sense, by an error that names it."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, public_arguments, read_table

CALLS = """
slam.DenseSLAM(intrinsic=camera, voxel_size=0.1, truncation=0.4, T_init=pose, depth_scale=1000.0, depth_max=3.0, submap_frames=10, seed=0, device="cpu")
tracker().close_loops(progress=None)
tracker().extract_point_cloud(weight_threshold=0.0)
tracker().extract_triangle_mesh(weight_threshold=0.0)
tracker().integrate(frame=frame)
tracker().join_maps()
tracker().trajectory_of(number=0)
tracker().render(T_world_camera=pose)
tracker().run(source=[frame], progress=None)
tracker().step(frame=frame)
tracker().track(frame=frame)
slam.Model(intrinsic=camera, voxel_size=0.1, truncation=0.4, T_init=pose, depth_scale=1000.0, depth_max=3.0, device="cpu")
model().extract_point_cloud(weight_threshold=0.0)
model().extract_triangle_mesh(weight_threshold=0.0)
model().integrate(frame=frame, T_world_camera=pose)
model().prepare(frame=frame)
model().render(T_world_camera=pose, weight_threshold=0.0)
model().track_frame(frame=frame, T_world_camera=pose)
slam.Submap(volume=submap.volume, T_world_submap=pose, frames=[0, 1], T_submap_camera=[pose, pose])
submap.cloud(voxel_size=0.1)
slam.SubmapRecorder(intrinsic=camera, voxel_size=0.1, truncation=0.4, depth_scale=1000.0, depth_max=3.0, frames=4, way=1.0, shared=0.25, device="cpu")
recorder().add(depth=frame.depth, T_world_camera=pose, color=color, number=0)
slam.close_loops(submaps=[submap], voxel_size=0.1, drift=0.05, seed=0, progress=None)
slam.corrected_trajectory(submaps=[submap], T_world_submap=[pose])
slam.fuse_submaps(submaps=[submap], T_world_submap=[pose], voxel_size=0.1)
"""  # noqa: E501
HOMES = {"tracker()": "DenseSLAM", "model()": "Model", "recorder()": "SubmapRecorder", "submap": "Submap"}
TABLE = read_table(CALLS.replace("slam.", "loom.slam."), HOMES)
TABLE = {name.removeprefix("slam."): call for name, call in TABLE.items()}
RESULTS = {"LoopClosure", "MapJoin", "TrackingResult"}
INSIDE = {
    "Model.seen_from",
    "Model.fuse",
    "Model.begin_anew",
    "SubmapRecorder.take_over",
}  # what tracking asks the model for
CAMERA = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
FRAME = SimpleNamespace(depth=1.0 + 0.1 * np.sin(np.mgrid[:24, :32].sum(axis=0)), color=None)


@cache
def things() -> dict[str, Any]:
    model = loom.slam.Model(CAMERA, voxel_size=0.1, depth_max=2.0)
    model.integrate(FRAME, np.eye(4))

    @cache  # for all values: what is refused changes nothing
    def tracker() -> Any:
        made = loom.slam.DenseSLAM(CAMERA, voxel_size=0.1, submap_frames=10)
        made.step(FRAME)
        made.track(FRAME)
        return made

    def recorder(color: bool = True) -> loom.slam.SubmapRecorder:
        return loom.slam.SubmapRecorder(CAMERA, voxel_size=0.1, frames=4, color=color)

    plain = recorder(color=False)
    plain.add(FRAME.depth, np.eye(4))
    return {
        "loom": loom,
        "submap": plain.finish()[0],
        "recorder": recorder,
        "color": np.full((24, 32, 3), 100, np.uint8),
        "camera": CAMERA,
        "pose": np.eye(4),
        "frame": FRAME,
        "model": lambda: model,
        "tracker": tracker,
    }


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(loom.slam, RESULTS | INSIDE)) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, things())(**{name: eval(value, dict(things())) for name, value in expressions.items()})


CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    values = things()
    good = {name: eval(expression, dict(values)) for name, expression in expressions.items()}
    also = {"source": "frame", "depth": "intrinsic"}.get(argument, "")
    faults = faults_of(lambda **given: eval(function, dict(values))(**given), good, argument, also=also)
    assert not faults, "\n".join(faults)
