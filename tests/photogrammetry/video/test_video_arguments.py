"""The function behind `pointloom video` rejects invalid arguments before any work."""

from typing import Any

import pytest

import pointloom as loom
from pointloom.core.errors import DeviceError, FileError
from pointloom.photogrammetry.video.control_files import read_ground_control
from pointloom.photogrammetry.video.job import reconstruct_video
from pointloom.photogrammetry.video.outputs import VideoOutputs
from pointloom.photogrammetry.video.settings import VideoSettings

from ...cli.commands import names_in
from ...hostile import missing_from, public_arguments, read_table
from ..argument_tests import argument_tests

PLACING = 'masks=None, camera_model="SIMPLE_RADIAL", pairs="auto", max_features=500, panorama=False, mapper="auto"'
MAPS = 'ortho="ortho.tif", dem="dem.tif", cell=0.1, up="z"'
CALLS = f"""
loom.photogrammetry.reconstruct_video(source=film, settings=settings, outputs=outputs, work=work, device="cpu", progress=None)
loom.photogrammetry.VideoSettings(max_frames=30, max_size=320, intrinsic=None, units=units, seed=0, cameras=None, {PLACING})
loom.photogrammetry.VideoUnits(scale=2.0, known=None, align=None, places=None, control=None, scale_bars=None)
loom.photogrammetry.GroundControl(points=[point], marks=marks, bars=[bar], crs="EPSG:32632", checks=["A"], path="gcp.txt")
loom.photogrammetry.ControlMark(point="A", image="a.jpg", pixel=[3.0, 4.0], where="line 3")
loom.photogrammetry.ScaleBar(a="A", b="B", meters=1.5, sigma=0.01)
read_ground_control(path=gcp, scale_bars=None)
loom.photogrammetry.VideoOutputs(mesh="room.ply", cloud="c.ply", trajectory="p.log", picture="room.png", training="scene", {MAPS})
"""  # noqa: E501
TABLE = read_table(CALLS, {})
RESULTS = {"Fit", "PlacesFit", "KnownPlaces", "StageReport", "VideoFigures", "VideoResult"}
RESULTS |= {"ControlFit", "ControlResidual", "BarResidual", "GpsGaps"}
INSIDE = {f"VideoOutputs.{name}" for name in ("check", "check_fit", "check_units", "write", "write_training")}
INSIDE |= {
    "PlacesFit.why_doubted",
    "VideoUnits.check_names",
    "VideoSettings.read_posed",
    "VideoSettings.digest_of_cameras",
}


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(loom.photogrammetry, RESULTS | INSIDE, "photogrammetry.video")) == {}


@pytest.fixture
def things(quick, film, tmp_path, monkeypatch) -> dict[str, Any]:
    monkeypatch.chdir(tmp_path)  # where a string of digits is a good name of a folder
    settings, outputs = loom.photogrammetry.VideoSettings(), loom.photogrammetry.VideoOutputs()
    named = {
        "loom": loom,
        "film": film,
        "settings": settings,
        "outputs": outputs,
        "units": loom.photogrammetry.VideoUnits(),
    }
    gcp = tmp_path / "gcp.txt"
    gcp.write_text("EPSG:32632\n447000 5260000 410 320 240 a.jpg A\n")
    point = loom.registration.ControlPoint("A", [447000.0, 5260000.0, 410.0])
    marks = [loom.photogrammetry.ControlMark(name, "a.jpg", [3.0, 4.0]) for name in "AB"]
    bar = loom.photogrammetry.ScaleBar("A", "B", 1.5)
    named |= {"read_ground_control": read_ground_control, "gcp": gcp, "point": point, "marks": marks, "bar": bar}
    return named | {"work": None}


test_good_arguments_are_accepted, test_hostile_values_are_rejected_by_name = argument_tests(TABLE)


def test_frame_counts_and_sizes_below_the_minimum_are_rejected():
    for given in ({"max_frames": 1}, {"max_size": 63}):
        with pytest.raises(ValueError, match=next(iter(given))):
            VideoSettings(**given)


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"source": None}, TypeError),
        ({"outputs": "room.ply"}, TypeError),
        ({"device": "gpu"}, (DeviceError, ValueError)),
    ],
)
def test_invalid_calls_do_nothing(quick, film, tmp_path, given, error):
    call = {"source": film, "outputs": VideoOutputs(mesh=tmp_path / "room.ply")} | given
    with pytest.raises(error):
        reconstruct_video(call.pop("source"), **call)
    assert quick.ran == []
    assert names_in(tmp_path) == ["walk.mp4"]


def test_two_outputs_in_one_file_are_refused(quick, film, tmp_path):
    with pytest.raises(FileError, match=r"room\.ply"):
        reconstruct_video(film, outputs=VideoOutputs(mesh=tmp_path / "room.ply", cloud=tmp_path / "." / "room.ply"))
    assert quick.ran == []
