"""Devices of other libraries are accepted by every public call that has the argument `device`."""

import contextlib
import inspect
import sys
from functools import partial
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.devices import device_name, resolve_device
from pointloom.core.errors import DeviceError
from pointloom.public_names import results_of

from ..hostile import TORCH_CPU, stand_in
from ..io import test_bags as bags
from ..pcd import test_hostile_arguments as clouds
from ..photogrammetry.depth import test_depth_arguments as depth
from ..photogrammetry.mvs import test_depth_maps as maps
from ..photogrammetry.sfm import test_sfm_arguments as sfm
from ..photogrammetry.video import test_video_arguments as video
from ..registration import test_hostile_arguments as registrations
from ..rgbd import test_hostile_arguments as frames
from ..visualization import test_arguments as images
from .test_argument_errors import LEFT_OUT, public_calls

# Calls of the tables of valid arguments: what their expressions need, the function and the arguments.
TABLES = [(clouds.TABLE, clouds.things), (registrations.TABLE, registrations.things), (images.TABLE, images.things)]
TABLES += [(table, partial(frames.things, package)) for package, table in frames.TABLES.items()]
CALLS = {call: (things, *entry) for table, things in TABLES for call, entry in table.items() if "device" in entry[1]}
# The tests of these tables pass a device of torch themselves (tests/photogrammetry/argument_tests.py).
ELSEWHERE = {
    call for table in (depth, maps, sfm, video) for call, (_, given) in table.TABLE.items() if "device" in given
}
LIBRARY = {*loom.__all__} - LEFT_OUT
BELOW = {"run_tiles", "run_job", "Recording.scans", "Raster.fill_gaps"}
IN_OPEN3D_TESTS = {"PointCloud.from_open3d", "TriangleMesh.from_open3d"}


def test_the_tables_contain_every_public_call_with_a_device():
    modules = [loom, *(value for name in LIBRARY if isinstance(value := getattr(loom, name), ModuleType))]
    results = {name for module in modules for name in results_of(module.__name__)}
    found = {name for name, call in public_calls() if "device" in inspect.signature(call).parameters} - results
    assert found == {*CALLS} - results | ELSEWHERE | BELOW | IN_OPEN3D_TESTS


@pytest.mark.filterwarnings("ignore::pointloom.DroppedResultWarning")
@pytest.mark.parametrize("call", CALLS)
def test_a_device_of_torch_is_accepted(call, device, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    make, function, expressions = CALLS[call]
    things = dict(make())
    given = {name: eval(expression, things) for name, expression in expressions.items()}
    if call == "check_focal":  # the trajectory of the table is of other frames
        given |= {"trajectory": None, "uncertain": ()}
    wanted = [TORCH_CPU] if device == "cpu" else [stand_in("torch.device", type="cuda", index=0), "cuda"]
    for value in wanted:
        with contextlib.suppress(loom.FileError):  # of files that do not exist
            result = eval(function, dict(things))(**given | {"device": value})
            if hasattr(result, "device") and not isinstance(result.device, str):
                assert result.device == resolve_device(device)


def test_tiles_and_recordings_accept_a_device_of_torch(tmp_path, rng):
    loom.write_point_cloud(tmp_path / "cloud.las", loom.PointCloud(rng.random((500, 3)) * 9))
    loom.tiling.plan_tiles(tmp_path / "cloud.las", [{"step": "thin", "spacing": 1.0}], tmp_path / "job", size=9.0)
    assert loom.tiling.run_tiles(tmp_path / "job", device=TORCH_CPU).is_finished
    recording = loom.open_recording(bags.write(tmp_path, "mcap"))
    assert next(recording.scans(device=TORCH_CPU)).device == resolve_device("cpu")
    raster = loom.rasterize(loom.PointCloud(rng.random((500, 3)) * 9), 1.0, "lowest")
    np.testing.assert_array_equal(raster.fill_gaps(1.0, device=TORCH_CPU).values, raster.fill_gaps(1.0).values)


@pytest.mark.parametrize(
    ("given", "name"),
    [
        (TORCH_CPU, "cpu"),
        (stand_in("torch.device", type="cpu", index=0), "cpu"),
        (stand_in("torch.device", type="cuda", index=1), "cuda:1"),
        (stand_in("torch.device", type="meta", index=None), "meta"),
        (stand_in("cupy.cuda.device.Device", id=2), "cuda:2"),
        (stand_in("jaxlib._jax.Device", platform="cpu", id=0), "cpu"),
        (stand_in("jaxlib._jax.Device", platform="gpu", id=1), "cuda:1"),
        (stand_in("jaxlib._jax.Device", platform="tpu", id=1), "tpu"),
        ("cuda", "cuda"),
        (None, None),
    ],
)
def test_devices_of_other_libraries_have_names(given, name):
    assert device_name(given) == name
    if name in ("meta", "tpu", "cuda:1", "cuda:2"):
        with pytest.raises(DeviceError, match=f"^device: expected one of cpu.* got .*{name}"):
            resolve_device(given)


@pytest.mark.parametrize(("available", "name"), [(True, "cuda:3"), (False, "cuda")])
def test_a_device_of_torch_without_a_number_is_its_current_one(monkeypatch, available, name):
    cuda = SimpleNamespace(is_available=lambda: available, current_device=lambda: 3)
    monkeypatch.setitem(sys.modules, "torch", SimpleNamespace(cuda=cuda))
    assert device_name(stand_in("torch.device", type="cuda", index=None)) == name
