"""The call behind `pointloom video` refuses arguments that make no sense before it does anything."""

import numpy as np
import pytest

from pointloom.app.video.job import Settings, mesh_video
from pointloom.pcd.errors import DeviceError, FileError

from ..commands import names_in


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"max_frames": 1}, ValueError),
        ({"max_frames": 2.5}, TypeError),
        ({"max_frames": True}, TypeError),
        ({"max_frames": "150"}, TypeError),
        ({"max_size": 63}, ValueError),
        ({"max_size": np.nan}, TypeError),
        ({"max_size": None}, TypeError),
        ({"seed": -1}, ValueError),
        ({"seed": "0"}, TypeError),
        ({"units": "metres"}, TypeError),
        ({"intrinsic": 5}, TypeError),
        ({"intrinsic": "nowhere.json"}, FileError),
    ],
)
def test_settings_that_make_no_sense_are_refused(given, error):
    with pytest.raises(error, match=f"{next(iter(given))}|nowhere|path"):
        Settings(**given)


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"source": None}, TypeError),
        ({"source": 3}, TypeError),
        ({"output": None}, TypeError),
        ({"settings": {"max_frames": 3}}, TypeError),
        ({"progress": "loud"}, TypeError),
        ({"device": "gpu"}, (DeviceError, ValueError)),
        ({"resume": True}, ValueError),
        ({"work": 3}, TypeError),
    ],
)
def test_calls_that_make_no_sense_do_nothing(quick, film, tmp_path, given, error):
    call = {"source": film, "output": tmp_path / "room.ply"} | given
    with pytest.raises(error):
        mesh_video(call.pop("source"), call.pop("output"), **call)
    assert quick.ran == []
    assert names_in(tmp_path) == ["walk.mp4"]


def test_two_outputs_in_one_file_are_refused(quick, film, tmp_path):
    with pytest.raises(FileError, match=r"room\.ply: is given for two outputs"):
        mesh_video(film, tmp_path / "room.ply", cloud=tmp_path / "." / "room.ply")
    assert quick.ran == []
