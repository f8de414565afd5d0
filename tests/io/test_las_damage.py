"""Damaged LAS and LAZ: headers are checked against the file."""

import struct
import subprocess
import sys
import textwrap
import tracemalloc
from pathlib import Path

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_crs import crs_name

from .las_files import edited, make


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(0, "4s", b"LASX")], "is not a LAS file"),
        ([(24, "B", 2)], "LAS 2.2 is not supported"),
        ([(94, "<H", 200)], "header of 227 bytes"),
        ([(96, "<I", 1 << 31)], "points should start at byte 2147483648"),
        ([(100, "<I", 1 << 31)], "2147483648 records cannot fit into the 0 bytes"),
        ([(104, "B", 11)], "unknown point format 11"),
        ([(104, "B", 6)], "point format 6 came with LAS 1.4"),
        ([(105, "<H", 0)], "points of 0 bytes"),
        ([(107, "<I", 0xFFFFFFFF)], "counts 4294967295 points, the file contains 20"),
        ([(107, "<I", 19)], "counts 19 points, but the file contains 20"),
        ([(131, "<d", 0.0)], "scales"),
        ([(131, "<d", -0.01)], "scales"),
        ([(139, "<d", np.nan)], "scales"),
        ([(147, "<d", np.inf)], "scales"),
        ([(147, "<d", 1e35)], "exceed"),
        ([(163, "<d", np.nan)], "offsets"),
    ],
)
def test_inconsistent_header_is_an_error(edits, reason, small_las):
    with pytest.raises(loom.FileError, match=reason) as caught:
        loom.read_point_cloud(edited(small_las, *edits))
    assert str(small_las) in str(caught.value) and "byte" in caught.value.where


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(107, "<I", 5)], "counts 8 points in one field and 5 in another"),
        ([(247, "<Q", 1 << 60)], "the file contains 8"),
        ([(235, "<QI", 1 << 50, 1)], "extended records should start at byte 1125899906842624"),
        ([(235, "<QI", 893, 1 << 31)], "2147483648 records cannot fit"),
        ([(375 + 20, "<H", 60_000)], "record 0 of 1 has 60000 bytes"),
        ([(375 + 54 + 2, "B", 200)], "the record of extra dimensions is damaged"),
        ([(375 + 54 + 2, "B", 10)], "its extra dimensions need 4 bytes more"),
        ([(375 + 54 + 4, "32s", b"")], "two dimensions of its points have one name, or one has none"),
    ],
)
def test_inconsistent_header_of_version_1_4_is_an_error(edits, reason, tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng, [laspy.ExtraBytesParams("height", "f4")])
    with pytest.raises(loom.FileError, match=reason):
        loom.read_point_cloud(edited(path, *edits))


def test_extended_records_may_follow_the_points(tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng)
    size, wkt = path.stat().st_size, b'PROJCRS["Somewhere",BASEGEOGCRS["x"]]'
    other = struct.pack("<H16sHQ32s", 0, b"waveforms", 1, 3000, b"") + bytes(3000)
    record = struct.pack("<H16sHQ32s", 0, b"LASF_Projection", 2112, len(wkt), b"") + wkt
    path.write_bytes(path.read_bytes() + other + record)
    with pytest.raises(loom.FileError, match=r"/a\.las \(byte 615\):.*8"):
        read_las(path)
    edited(path, (235, "<QI", size, 2))
    assert len(read_las(path).points) == 8 and crs_name(open_las(path).header) == "Somewhere"


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_file_cut_anywhere_is_an_error(suffix, tmp_path, rng):
    path = tmp_path / f"a{suffix}"
    make(path, 7, 300, rng)
    content = path.read_bytes()
    for length in [0, 1, 4, 100, 226, 300, 400, *range(500, len(content), len(content) // 15), len(content) - 1]:
        path.write_bytes(content[:length])
        with pytest.raises(loom.FileError):
            read_las(path)


def test_compressed_points_are_checked_against_their_tables(tmp_path, rng):
    path = tmp_path / "a.laz"
    make(path, 6, 2000, rng)
    content, header = path.read_bytes(), open_las(path).header
    record = content.index(header.find("laszip encoded", 22204))
    (table,) = struct.unpack_from("<q", content, header.begin)
    layers = header.begin + 8 + header.record_length + 4
    contradictions = {
        "the header counts 1099511627776 points, the table 1 chunks": [(247, "<Q", 1 << 40)],
        "the header counts 50001 points": [(247, "<Q", 50_001)],
        "the compressed points are damaged": [(247, "<Q", 50_000)],
        "the table of chunks should be at byte -5": [(header.begin, "<q", -5)],
        "the table of chunks should be at byte 4611686018427387904": [(header.begin, "<q", 1 << 62)],
        "4294967295 chunks in": [(table + 4, "<I", 0xFFFFFFFF)],
        "the layers of chunk 0 do not fit": [(layers, "<I", 0xFFFFFFFF)],
        "compressor 9 is not supported": [(record, "<H", 9)],
        "chunks of 0 points": [(record + 12, "<I", 0)],
        "9 items": [(record + 32, "<H", 9)],
        "LASzip's points have 24 bytes": [(record + 34, "<HH", 14, 24)],
        r"items \(type, bytes\) \[\(99, 30\)\]": [(record + 34, "<H", 99)],
    }
    for reason, edits in contradictions.items():
        path.write_bytes(content)
        with pytest.raises(loom.FileError, match=reason):
            read_las(edited(path, *edits))
    path.write_bytes(content.replace(b"laszip encoded", b"laszip encodeX"))
    with pytest.raises(loom.FileError, match=r"/a\.laz \(byte 100\):"):
        read_las(path)


@pytest.mark.parametrize("count", [4_000_000_000, 2_000_000_000])
def test_unchecked_count_allocates_memory_only_with_its_points(tmp_path, rng, count):
    path = tmp_path / "a.laz"
    make(path, 0, 3, rng, [laspy.ExtraBytesParams("long", "60000u1")] if count < 2**31 else [])
    header, content = open_las(path).header, path.read_bytes()
    record = content.index(header.find("laszip encoded", 22204))
    edited(path, (107, "<I", count), (record + 12, "<I", count + 1))  # one chunk of all points
    tracemalloc.start()
    with pytest.raises(loom.FileError, match=r"/a\.laz:"):
        read_las(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 150e6


CHUNKS = """
    import resource, struct, sys
    from pathlib import Path
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    from pointloom.core.errors import FileError
    from pointloom.io.points.las import open_las, read_las

    for path in map(Path, sys.argv[1:]):
        content, header = path.read_bytes(), open_las(path).header
        record = content.index(header.find("laszip encoded", 22204))
        at, form = (247, "<Q") if header.version == "1.4" else (107, "<I")
        for chunk_size in (1 << 20, 1 << 28, (1 << 31) - 1, 1 << 31, (1 << 32) - 2):
            for count in (1, 300, 1 << 28, (1 << 32) - 2):
                damaged = bytearray(content)
                struct.pack_into("<I", damaged, record + 12, chunk_size)
                struct.pack_into(form, damaged, at, count)
                if form == "<Q":
                    struct.pack_into("<I", damaged, 107, 0)
                path.write_bytes(damaged)
                try:
                    assert len(read_las(path).points) == count <= 300
                except FileError:
                    assert count > 300
"""


def run_in_little_memory(folder, script, *paths):
    """Output of a script with 4 GiB of memory, which the system may kill."""
    (folder / "script.py").write_text(textwrap.dedent(script))
    package = str(Path(loom.__file__).parents[1])
    answer = subprocess.run(
        [sys.executable, str(folder / "script.py"), *map(str, paths)],
        capture_output=True, text=True, timeout=100, check=False, env={"PYTHONPATH": package},
    )  # fmt: skip
    assert answer.returncode == 0, answer.stderr[-2000:]
    return answer.stdout


@pytest.mark.slow
def test_a_chunk_size_beyond_the_memory_does_not_end_the_process(tmp_path, rng):
    for point_format in (0, 3, 6):
        make(tmp_path / f"{point_format}.laz", point_format, 300, rng)
    run_in_little_memory(tmp_path, CHUNKS, *tmp_path.glob("*.laz"))


def test_chunks_of_very_many_points_are_unpacked_to_the_same_points(tmp_path, rng, monkeypatch):
    path = tmp_path / "a.laz"
    make(path, 7, 51_000, rng, [laspy.ExtraBytesParams("height", "f4")])
    expected = read_las(path)
    monkeypatch.setattr("pointloom.io.points.laszip._PARALLEL_CHUNK_BYTES", 0)
    result = read_las(path)
    np.testing.assert_array_equal(result.points, expected.points)
    for name, values in expected.attributes.items():
        np.testing.assert_array_equal(result.attributes[name], values)


FUZZ = """
    import random, resource, sys
    from pathlib import Path
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    from pointloom.core.errors import FileError
    from pointloom.io.points.las import read_las

    chance, outcomes = random.Random(7), [0, 0]
    for path in map(Path, sys.argv[1:]):
        content = path.read_bytes()
        for round in range(120):
            damaged = bytearray(content)
            reach = len(content) if round % 2 else min(len(content), 1500)
            for _ in range(chance.randint(1, 3)):
                at = chance.randrange(reach)
                how = chance.randrange(4)
                if how == 0:
                    damaged[at % len(damaged)] ^= 1 << chance.randrange(8)
                elif how == 1:
                    damaged[at : at + 4] = b"\\xff\\xff\\xff\\x7f"
                elif how == 2:
                    del damaged[at : at + chance.randint(1, 30)]
                else:
                    damaged[at:at] = chance.randbytes(5)
            broken = path.with_stem("broken")
            broken.write_bytes(damaged)
            try:
                table = read_las(broken)
            except FileError as error:
                assert str(broken) in str(error)
                outcomes[0] += 1
            else:
                assert all(len(values) == len(table.points) for values in table.attributes.values())
                outcomes[1] += 1
    print(*outcomes)
"""


@pytest.mark.slow
def test_damaged_bytes_give_a_table_or_a_file_error_within_little_memory(tmp_path, rng, shipped_file):
    paths = [tmp_path / "a.las", tmp_path / "b.laz", tmp_path / "c.laz"]
    paths[0].write_bytes((shipped_file("lidar-pdal/autzen/autzen-utm.las")).read_bytes())
    make(paths[1], 3, 1500, rng)
    make(paths[2], 7, 1500, rng, [laspy.ExtraBytesParams("height", "f4")])
    answer = run_in_little_memory(tmp_path, FUZZ, *paths)
    refused, read = map(int, answer.split())
    assert refused + read == 360 and refused > 100
