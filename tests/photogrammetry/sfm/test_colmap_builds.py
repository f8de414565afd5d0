"""Different builds of pycolmap: with and without a GPU and networks."""

import runpy
from pathlib import Path
from types import SimpleNamespace

import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import colmap_jobs
from pointloom.photogrammetry.sfm.features import find_features

from .conftest import has_pycolmap, write_pictures

WORKER = runpy.run_path(str(Path(colmap_jobs.__file__).with_name("colmap_worker.py")))


@pytest.mark.parametrize(
    ("has_cuda", "devices", "wanted", "used"),
    [(True, 1, None, True), (True, 1, False, False), (True, 0, None, False), (False, 1, None, False)],
)
def test_a_gpu_is_used_where_pycolmap_and_the_machine_have_one(monkeypatch, has_cuda, devices, wanted, used):
    monkeypatch.setitem(WORKER["on_gpu"].__globals__, "_cuda_devices", lambda: devices)
    assert WORKER["on_gpu"](SimpleNamespace(has_cuda=has_cuda), {"gpu": wanted}) is used


def test_a_requested_but_missing_gpu_is_an_error(monkeypatch):
    monkeypatch.setitem(WORKER["on_gpu"].__globals__, "_cuda_devices", lambda: 0)
    for has_cuda, message in ((False, "pip install pycolmap-cuda12"), (True, "there is no CUDA device")):
        with pytest.raises(RuntimeError, match=message):
            WORKER["on_gpu"](SimpleNamespace(has_cuda=has_cuda), {"gpu": True})


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_missing_networks_are_a_named_error(scene_pictures, tmp_path):
    pictures = write_pictures(tmp_path / "p", scene_pictures[:2])
    with pytest.raises(loom.FileError, match="ALIKED and LightGlue require a pycolmap built with ONNX"):
        find_features(pictures, tmp_path / "f.db", kind="aliked")
    assert not (tmp_path / "f.db").exists()
