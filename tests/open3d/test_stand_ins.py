"""benchmarks/open3d_stand_ins.py: windows and missing files of scripts are replaced."""

from types import SimpleNamespace

import pytest

from benchmarks.open3d_stand_ins import replace


@pytest.fixture
def package():
    """Modules of a package whose readers return the path."""
    io = SimpleNamespace(read_point_cloud=str, read_image=lambda filename, options=0: (filename, options))
    return SimpleNamespace(visualization=SimpleNamespace(), io=io, t=SimpleNamespace(io=SimpleNamespace()))


def test_missing_files_are_replaced_by_those_of_the_same_kind(package, tmp_path):
    folder = tmp_path / "stand_ins"
    folder.mkdir()
    (folder / "cloud.ply").touch()
    replace(package, "data", tmp_path)
    assert package.data == "data"
    assert package.io.read_point_cloud("absent/a.PLY") == str(folder / "cloud.ply")
    assert package.io.read_point_cloud("absent/a.other") == "absent/a.other"
    assert package.io.read_point_cloud(folder / "cloud.ply") == str(folder / "cloud.ply")
    assert package.io.read_image(filename="Depth/1.png", options=2) == (str(folder / "depth.png"), 2)
    assert package.io.read_image("color/1.jpg")[0] == str(folder / "color.jpg")


def test_windows_record_their_geometries_and_end_at_once(package):
    drawn = replace(package, None, None)
    window = package.visualization.Visualizer()
    assert window.create_window("title") and window.add_geometry("cloud")
    assert not window.poll_events()
    window.get_view_control().set_zoom(0.5).anything()
    assert len(window.get_picked_points()) == 0 and float(window.get_render_option().point_size) == 0
    package.visualization.draw_geometries(["mesh", "lines"], zoom=0.5)
    package.visualization.draw("box")
    assert drawn == ["cloud", "mesh", "lines", "box"]
    assert package.io.read_point_cloud("a.ply") == "a.ply"
