"""Sample data sets of Open3D are read from a folder, and nothing is downloaded."""

from pathlib import Path

import pytest

import pointloom.open3d as o3d
from pointloom.core.errors import FileError

ICP_FILES = ("cloud_bin_0.pcd", "cloud_bin_1.pcd", "cloud_bin_2.pcd", "init.log")


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """An empty home and no folder of samples."""
    for name in ("POINTLOOM_SAMPLES", "OPEN3D_DATA_ROOT"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def write(folder: Path, *names: str) -> list[str]:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    return [str(folder / name) for name in names]


@pytest.mark.parametrize("layout", ["extract/DemoICPPointClouds", "DemoICPPointClouds"])
@pytest.mark.parametrize("place", ["argument", "POINTLOOM_SAMPLES", "OPEN3D_DATA_ROOT", "open3d_data"])
def test_files_are_found_in_each_folder(place, layout, tmp_path, home, monkeypatch):
    root = home / "open3d_data" if place == "open3d_data" else tmp_path / "samples"
    paths = write(root / layout, *ICP_FILES)
    if place.isupper():
        monkeypatch.setenv(place, str(root))
    dataset = o3d.data.DemoICPPointClouds(data_root=str(root) if place == "argument" else "")
    assert dataset.paths == paths[:3] and dataset.transformation_log_path == paths[3]
    assert (dataset.data_root, dataset.extract_dir) == (str(root), str(root / layout))
    assert dataset.prefix == "DemoICPPointClouds" and dataset.download_dir.endswith("download/DemoICPPointClouds")


def test_a_missing_file_is_an_error_with_its_folder_and_an_alternative(tmp_path, monkeypatch):
    with pytest.raises(FileError) as raised:
        o3d.data.BunnyMesh().path  # noqa: B018
    assert raised.value.path.endswith("home/open3d_data/extract/BunnyMesh/BunnyMesh.ply")
    assert "POINTLOOM_SAMPLES" in raised.value.remedy and "loom.datasets.object_mesh()" in raised.value.remedy
    samples = tmp_path / "samples"
    monkeypatch.setenv("POINTLOOM_SAMPLES", str(samples))
    write(samples / "DemoICPPointClouds", *ICP_FILES[:1])
    with pytest.raises(FileError) as raised:
        o3d.data.DemoICPPointClouds().paths  # noqa: B018
    assert raised.value.path == str(samples / "DemoICPPointClouds/cloud_bin_1.pcd")
    with pytest.raises(FileError):  # a given folder is the only one that is searched
        o3d.data.DemoICPPointClouds(str(tmp_path / "other")).paths  # noqa: B018


def test_models_and_textures_have_maps_of_paths(tmp_path):
    crate = write(tmp_path / "CrateModel", "crate.mtl", "crate.obj", "crate.jpg")
    dataset = o3d.data.CrateModel(str(tmp_path))
    assert dataset.path == crate[1]
    assert dataset.path_map == dict(zip(("crate_material", "crate_model", "texture_image"), crate, strict=True))
    names = ("image/b.jpg", "image/a.jpg", "depth/0.png")
    colors = sorted(write(tmp_path / "SampleFountainRGBDImages", *names)[:2])
    assert o3d.data.SampleFountainRGBDImages(str(tmp_path)).color_paths == colors


def test_a_data_set_of_the_caller_needs_its_folder(tmp_path):
    descriptor = o3d.data.DataDescriptor(o3d.data.open3d_downloads_prefix + "a.zip", "0" * 32)
    with pytest.raises(FileError):
        o3d.data.DownloadDataset("Own", descriptor, str(tmp_path))
    write(tmp_path / "Own", "a.ply")
    assert o3d.data.DownloadDataset("Own", descriptor, str(tmp_path)).extract_dir == str(tmp_path / "Own")
    with pytest.raises(ValueError, match="prefix:"):
        o3d.data.Dataset("")


@pytest.mark.slow
def test_data_sets_have_the_attributes_of_open3d():
    real = pytest.importorskip("open3d").data
    for name in dir(real):
        kind = getattr(real, name)
        if not name.startswith("_") and isinstance(kind, type) and name != "DataDescriptor":
            attributes = {each for each in dir(kind) if not each.startswith("_")}
            assert attributes == {each for each in dir(getattr(o3d.data, name)) if not each.startswith("_")}, name
