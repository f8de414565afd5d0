"""Clouds of Livox's custom message, written by rosbags with the driver's definitions."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.bags.clouds import table_of_livox

pytest.importorskip("rosbags")

from rosbags.typesys import get_types_from_msg

from .test_recorded_frames import Writer

KIND = "livox_ros_driver2/msg/CustomMsg"
POINT = "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\nuint8 line\n"
CLOUD = "std_msgs/Header header\nuint64 timebase\nuint32 point_num\nuint8 lidar_id\nuint8[3] rsvd\n"


def made(folder, form, frame="livox_frame", count_error=0):
    with Writer(folder, form) as out:
        point = KIND.replace("Msg", "Point")
        kinds = get_types_from_msg(POINT, point)
        out.store.register(kinds | get_types_from_msg(CLOUD + f"{point.replace('/msg', '')}[] points\n", KIND))
        make = out.store.types[point]
        for number, count in enumerate((5, 1, 0, 40)):
            points = [make(1000 * i, 1.5 * i, -i, 0.25 * number, i % 256, 16, i % 6) for i in range(count)]
            values = 10**18, count + count_error, 1, np.zeros(3, np.uint8), points
            out.send("/livox/lidar", KIND, number + 1, *values, frame=frame)
    return out.path


@pytest.mark.parametrize("form", ["bag1", "mcap"])
@pytest.mark.parametrize("frame", ["a", "livox", "livox_frame"])
def test_points_have_times_lines_and_reflectivity(tmp_path, form, frame):
    scans = list(loom.open_recording(made(tmp_path, form, frame=frame)).scans())
    assert [len(scan) for scan in scans] == [5, 1, 0, 40]
    i = np.arange(40)
    np.testing.assert_array_equal(scans[3].points, np.column_stack([1.5 * i, -i, np.full(40, 0.75)]))
    np.testing.assert_allclose(scans[3]["time"], 1e-6 * i)
    np.testing.assert_array_equal(scans[3]["line"], i % 6)
    np.testing.assert_array_equal(scans[3]["reflectivity"], i)


def test_truncated_or_inconsistent_cloud_is_named(tmp_path):
    with pytest.raises(FileError, match=r"/run:.*0.*6.*5"):
        list(loom.open_recording(made(tmp_path, "mcap", count_error=1)).scans())
    recording = loom.open_recording(made(tmp_path, "bag1"))
    encoding, data = recording.bytes_at(recording.rows_of("/livox/lidar")[3])
    for end in (0, 10, 20, 30, len(data) - 1):
        with pytest.raises(FileError, match=r"/run\.bag:"):
            table_of_livox(recording.path, data[:end], encoding)
