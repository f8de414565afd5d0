"""Splats from and to PLY, .splat and SPZ: exact round trips, Open3D's values, and rejected files."""

import gzip
import struct
import tracemalloc

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError

from ..pcd.test_splats import made


@pytest.mark.parametrize("degree", range(5))
def test_ply_keeps_every_bit_and_further_columns(tmp_path, degree):
    splats = made(20, degree)
    splats.cloud["label"] = np.arange(20, dtype=np.int32)
    loom.write_splats(tmp_path / "a.ply", splats)
    again = loom.read_splats(tmp_path / "a.ply")
    assert again.degree == degree
    for name in splats.cloud.arrays:
        np.testing.assert_array_equal(again.cloud[name], splats.cloud[name])


def test_spz_rounds_by_its_steps(tmp_path):
    splats = made(2000, 3)
    loom.write_splats(tmp_path / "a.spz", splats)
    again = loom.read_splats(tmp_path / "a.spz")
    assert np.abs(again.centers - splats.centers).max() <= 0.5 / 4096
    assert np.abs(np.log(again.scales) - np.log(splats.scales)).max() <= 0.5 / 16 + 1e-6
    assert np.abs(again.opacities - splats.opacities).max() <= 0.5 / 255 + 1e-6
    assert np.abs((again.rotations * splats.rotations).sum(axis=1)).min() > 1 - 1e-5
    small = np.abs(splats.harmonics).max(axis=(1, 2)) < 0.9
    assert np.abs(again.harmonics - splats.harmonics)[small, 1:4].max() <= 4 / 128 + 1e-6
    assert np.abs(again.harmonics - splats.harmonics)[small].max() <= 8 / 128 + 1e-6
    loom.write_splats(tmp_path / "b.spz", splats)
    assert (tmp_path / "a.spz").read_bytes() == (tmp_path / "b.spz").read_bytes()


def test_splat_rounds_colors_opacities_and_rotations_to_bytes(tmp_path):
    splats = made(500, 0)
    loom.write_splats(tmp_path / "a.splat", splats)
    again = loom.read_splats(tmp_path / "a.splat")
    np.testing.assert_array_equal(again.centers, splats.centers.astype(np.float32))
    np.testing.assert_allclose(again.scales, splats.scales, rtol=1e-6)
    assert np.abs(again.opacities - splats.opacities).max() <= 0.5 / 255 + 1e-6
    assert np.abs((again.rotations * splats.rotations).sum(axis=1)).min() > 1 - 1e-3


def test_spz_of_version_2_has_three_bytes_a_rotation(tmp_path):
    body = bytes(3) * 3 + bytes([255]) + bytes([128] * 3) + bytes([160] * 3) + bytes([255, 127, 127])
    head = struct.pack("<IIIBBBB", 0x5053474E, 2, 1, 0, 12, 0, 0)
    (tmp_path / "a.spz").write_bytes(gzip.compress(head + body))
    one = loom.read_splats(tmp_path / "a.spz")
    np.testing.assert_allclose(one.scales, 1)
    np.testing.assert_allclose(one.rotations, [[0, 1, 0, 0]], atol=5e-3)
    assert np.isposinf(one.cloud["opacity"][0]) and one.opacities[0] == 1


@pytest.mark.parametrize("extension", [".splat", ".spz"])
def test_centers_that_a_format_would_round_are_refused(tmp_path, extension):
    far = made(3, 0, at=(500_000.0, 4_000_000.0, 0))
    with pytest.raises(FileError, match=r"would be rounded by .* translate the splats"):
        loom.write_splats(tmp_path / f"a{extension}", far)
    loom.write_splats(tmp_path / "a.ply", far)
    np.testing.assert_allclose(loom.read_splats(tmp_path / "a.ply").centers, far.centers, rtol=0, atol=1e-7)


@pytest.mark.parametrize("column", ["x", "f_dc_1", "f_rest_8", "opacity", "scale_2", "rot_0"])
def test_numbers_that_are_none_are_counted_or_dropped(tmp_path, column):
    splats = made(9, 1)
    group, _, part = column.rpartition("_")
    name = group or column
    if column == "x":
        points = splats.centers.copy()
        points[4, 0] = np.nan
        splats.cloud.points = points
    else:
        values = splats.cloud[name].copy()
        values[(4, int(part)) if group else 4] = np.nan
        splats.cloud[name] = values
    loom.write_splats(tmp_path / "a.ply", splats)
    with pytest.raises(FileError, match=r"/a\.ply \(splat 4\):.*1.*9"):
        loom.read_splats(tmp_path / "a.ply")
    with pytest.warns(UserWarning, match=r"/a\.ply:.*1.*9"):
        assert len(loom.read_splats(tmp_path / "a.ply", drop_invalid=True)) == 8


def test_a_cloud_is_no_splats_and_compressed_splats_are_no_cloud(tmp_path):
    with pytest.raises(FileError, match=r"/b\.ply:.*read_splats"):
        loom.read_point_cloud(compressed(tmp_path / "b.ply", packed(), CHUNK))
    (tmp_path / "a.splat").write_bytes(bytes(31))
    with pytest.raises(FileError, match=r"/a\.splat"):
        loom.read_splats(tmp_path / "a.splat")
    (tmp_path / "a.splat").write_bytes(np.full(16, -3.0, "<f4").tobytes())
    with pytest.raises(FileError, match=r"/a\.splat \(byte 12\):.*0"):
        loom.read_splats(tmp_path / "a.splat")
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.eye(3)))
    with pytest.raises(FileError, match=r"/a\.ply:.*f_dc_0"):
        loom.read_splats(tmp_path / "a.ply")
    with pytest.raises(FileError, match=r"/a\.las:"):
        loom.read_splats(tmp_path / "a.las")


@pytest.mark.parametrize(("name", "columns", "message"), [
    ("scale", 2, "expected 3 columns scale_i, got 2; splats of 2D"),
    ("f_rest", 8, "expected 0, 9, 24, 45 or 72 columns f_rest_i, got 8"),
])  # fmt: skip
def test_other_numbers_of_columns_are_refused(tmp_path, name, columns, message):
    cloud = made(3, 1).cloud.copy()
    cloud[name] = np.zeros((3, columns), np.float32)
    loom.write_point_cloud(tmp_path / "a.ply", cloud)
    with pytest.raises(FileError, match=message):
        loom.read_splats(tmp_path / "a.ply")


@pytest.mark.parametrize("version", [3, 4])
def test_wrong_count_allocates_no_memory(tmp_path, version):
    head = struct.pack("<IIIBBBB", 0x5053474E, version, 0xFFFFFFFF, 3, 12, 0, 6)
    content = head + struct.pack("<I", 32) + bytes(200)
    (tmp_path / "a.spz").write_bytes(gzip.compress(content) if version == 3 else content)
    with pytest.raises(FileError, match=r"/a\.spz \(byte 8\):.*4.*294.*967.*295"):
        loom.read_splats(tmp_path / "a.spz")


@pytest.mark.parametrize(("offset", "value", "message"), [
    (4, 1, "SPZ of version 1"), (12, 7, "harmonics of degree 7"), (13, 24, "24 fractional bits"), (0, 0, "magic"),
])  # fmt: skip
def test_invalid_spz_headers_are_rejected(tmp_path, offset, value, message):
    loom.write_splats(tmp_path / "a.spz", made(3, 0))
    content = bytearray(gzip.decompress((tmp_path / "a.spz").read_bytes()))
    content[offset] = value
    (tmp_path / "a.spz").write_bytes(gzip.compress(bytes(content)))
    with pytest.raises(FileError, match=message):
        loom.read_splats(tmp_path / "a.spz")


@pytest.mark.parametrize(("edit", "words"), [
    (lambda content: gzip.compress(content[:10]), ": ends after 10 bytes of a header of 16"),
    (lambda content: gzip.compress(content[:-1]), ": ends after 59 of 60 bytes of splats. The file is cut off"),
    (lambda content: gzip.compress(content + b"x"), " (byte 76): continues after its 3 splats"),
    (lambda content: gzip.compress(content)[:-4], ": ends before gzip's checksum. The file is cut off"),
    (lambda content: gzip.compress(content)[:-9], ": ends "),
    (lambda content: gzip.compress(content)[:-8] + bytes(8), ": gzip: "),
    (lambda content: gzip.compress(content)[:4], ": ends after 0 bytes of a header of 16"),
])  # fmt: skip
def test_truncated_and_extended_spz_files_are_rejected(tmp_path, edit, words):
    path = tmp_path / "a.spz"
    loom.write_splats(path, made(3, 0))
    content = gzip.decompress(path.read_bytes())
    path.write_bytes(gzip.compress(content[:14] + b"\2" + content[15:] + b"extension"))
    assert len(loom.read_splats(path)) == 3
    path.write_bytes(edit(content))
    with pytest.raises(FileError) as caught:
        loom.read_splats(path)
    assert str(caught.value).startswith(f"{path}{words}")


def streams_of(head=b"", table=32, first=None, entry=(None, None), behind=b""):
    """SPZ of version 4 with one splat: a header, a table of the sizes of its streams, and the streams."""
    zstandard = pytest.importorskip("zstandard")
    streams = [zstandard.compress(bytes(size)) for size in (9, 1, 3, 3, 4)]
    streams[0] = first or streams[0]
    sizes = [[len(stream), size] for stream, size in zip(streams, (9, 1, 3, 3, 4), strict=True)]
    sizes[0] = [given if given is not None else size for given, size in zip(entry, sizes[0], strict=True)]
    start = head or struct.pack("<IIIBBBB", 0x5053474E, 4, 1, 0, 12, 0, 5)
    rows = b"".join(struct.pack("<QQ", *row) for row in sizes)
    return start + struct.pack("<I", table) + bytes(12) + rows + b"".join(streams) + behind


def packed_by_zstandard(count, **options):
    return pytest.importorskip("zstandard").ZstdCompressor(**options).compress(bytes(count))


@pytest.mark.parametrize(("make", "words"), [
    (lambda: streams_of()[:31], " (byte 0): has 31 bytes, fewer than the header of SPZ"),
    (lambda: streams_of(struct.pack("<IIIBBBB", 0x5053474E, 4, 1, 0, 12, 0, 6)), " (byte 15): 6 streams, expected 5"),
    (lambda: streams_of(table=31), " (byte 16): a table at byte 31 of "),
    (lambda: streams_of(table=999), " (byte 16): a table at byte 999 of "),
    (lambda: streams_of(entry=(None, 8)), " (byte 112): the stream of points has 8 bytes, expected 9"),
    (lambda: streams_of(entry=(999, None)), " (byte 112): the stream of points reaches beyond the file"),
    (lambda: streams_of(first=packed_by_zstandard(8)), " (byte 112): a stream of 8 bytes, expected 9"),
    (lambda: streams_of(first=packed_by_zstandard(8, write_content_size=False)), " (byte 112): a stream of 8 bytes"),
    (lambda: streams_of(first=b"damaged"), ": the stream at byte 112: "),
    (lambda: streams_of(behind=b"xyz"), "continues after its last stream, by 3 bytes"),
])  # fmt: skip
def test_invalid_streams_of_spz_are_rejected(tmp_path, make, words):
    path = tmp_path / "a.spz"
    path.write_bytes(streams_of())
    assert len(loom.read_splats(path)) == 1
    path.write_bytes(make())
    with pytest.raises(FileError) as caught:
        loom.read_splats(path)
    assert words in str(caught.value).removeprefix(str(path))


def test_a_stream_that_declares_more_bytes_than_expected_is_not_decompressed(tmp_path):
    (tmp_path / "a.spz").write_bytes(streams_of(first=packed_by_zstandard(1 << 25)))
    tracemalloc.start()
    try:
        with pytest.raises(FileError, match="a stream of 33,554,432 bytes, expected 9"):
            loom.read_splats(tmp_path / "a.spz")
        assert tracemalloc.get_traced_memory()[1] < 1 << 22
    finally:
        tracemalloc.stop()


def test_other_objects_and_a_missing_column_are_named(tmp_path):
    with pytest.raises(TypeError, match="splats: expected GaussianSplats, got PointCloud"):
        loom.write_splats(tmp_path / "a.ply", loom.PointCloud(np.eye(3)))
    loom.write_splats(tmp_path / "a.ply", made(3, 0))
    (tmp_path / "a.ply").write_bytes((tmp_path / "a.ply").read_bytes().replace(b"f_dc_2", b"f_dc_7"))
    with pytest.raises(FileError, match=r"/a\.ply: vertices have no f_dc_2, but 3 columns f_dc_i"):
        loom.read_splats(tmp_path / "a.ply")


ENDS = [f"{end}_{what}{axis}" for what in ("", "scale_") for end in ("min", "max") for axis in "xyz"]
COLOR_ENDS = [f"{end}_{channel}" for end in ("min", "max") for channel in "rgb"]
PACKED = ("position", "rotation", "scale", "color")


def compressed(path, splats, chunks, *, ends=ENDS, sh=None, kind="uint"):
    """A compressed PLY of packed splats (n, 4), bounds of chunks and bytes of harmonics."""
    splats, chunks = np.array(splats, "<u4").reshape(-1, 4), np.array(chunks, "<f4").reshape(-1, len(ends))
    head = f"ply\nformat binary_little_endian 1.0\nelement chunk {len(chunks)}\n"
    head += "".join(f"property float {name}\n" for name in ends) + f"element vertex {len(splats)}\n"
    head += "".join(f"property {kind} packed_{name}\n" for name in PACKED)
    if sh is not None:
        sh = np.array(sh, np.uint8)
        names = "".join(f"property uchar f_rest_{k}\n" for k in range(sh.shape[1]))
        head += f"element sh {len(sh)}\n{names}"
    body = chunks.tobytes() + splats.tobytes() + (b"" if sh is None else sh.tobytes())
    path.write_bytes(f"{head}end_header\n".encode() + body)
    return path


def packed(position=(0, 0, 0), rotation=0, scale=(0, 0, 0), color=(0, 0, 0, 0)):
    position, scale = (x << 21 | y << 11 | z for x, y, z in (position, scale))
    return [position, rotation, scale, int.from_bytes(bytes(color), "big")]


CHUNK = [0, -1, 10, 1, 1, 20, -5, -4, -3, -1, -2, 0]


def test_compressed_splats_are_between_the_bounds_of_their_chunk(tmp_path):
    rows = [packed(), packed((2047, 1023, 2047), 0, (2047, 1023, 0), (255, 0, 51, 255)), packed((1023, 0, 0))]
    result = loom.read_splats(compressed(tmp_path / "a.ply", rows, [CHUNK], sh=[[0, 255] + [128] * 7] * 3))
    np.testing.assert_allclose(result.centers, [[0, -1, 10], [1, 1, 20], [1023 / 2047, -1, 10]], rtol=1e-6)
    np.testing.assert_allclose(result.cloud["scale"][:2], [[-5, -4, -3], [-1, -2, -3]])
    np.testing.assert_allclose(result.opacities, [0, 1, 0])
    np.testing.assert_allclose(result.cloud["f_dc"][1] * 0.28209479 + 0.5, [1, 0, 0.2], atol=1e-6)
    np.testing.assert_allclose(result.cloud["f_rest"][0], [-4, 4] + [128 * 8 / 255 - 4] * 7, atol=1e-6)
    many = loom.read_splats(compressed(tmp_path / "b.ply", [packed()] * 257, [CHUNK, [7] * 12]))
    assert many.centers[255].tolist() == [0, -1, 10] and many.centers[256].tolist() == [7, 7, 7]


def test_colors_of_compressed_splats_have_bounds_in_newer_files(tmp_path):
    row, chunk = packed(color=(255, 0, 51, 255)), [*CHUNK, -1, 0.25, 0, 2, 1, 1]
    result = loom.read_splats(compressed(tmp_path / "a.ply", row, chunk, ends=[*ENDS, *COLOR_ENDS]))
    np.testing.assert_allclose(result.cloud["f_dc"][0] * 0.28209479 + 0.5, [2, 0.25, 0.2], atol=1e-6)


@pytest.mark.parametrize("largest", range(4))
def test_the_largest_part_of_a_compressed_rotation_follows_from_the_others(tmp_path, largest):
    others = np.array([0.1, -0.2, 0.3])
    bits = np.rint((others / np.sqrt(2) + 0.5) * 1023).astype(int).tolist()
    word = largest << 30 | bits[0] << 20 | bits[1] << 10 | bits[2]
    result = loom.read_splats(compressed(tmp_path / "a.ply", packed(rotation=word), CHUNK))
    expected = np.insert(others, largest, np.sqrt(1 - (others**2).sum()))
    np.testing.assert_allclose(result.rotations[0], expected, atol=1e-3)


def test_compressed_splats_that_do_not_go_with_their_chunks_are_refused(tmp_path):
    for more, message in (
        ({"chunks": []}, "expected 1 chunks of 256 for 1 splats, got 0"),
        ({"chunks": [CHUNK] * 2}, "expected 1 chunks"),
        ({"chunks": CHUNK[1:], "ends": ENDS[1:]}, "has no min_x"),
        ({"chunks": [*CHUNK, 0], "ends": [*ENDS, "min_r"]}, "expected all of min_r"),
        ({"kind": "int"}, "packed_position .*unsigned integers of 4 bytes"),
        ({"sh": [[0] * 8]}, "expected 9, 24, 45 or 72"),
        ({"sh": [[0] * 9] * 2}, "expected 1 rows"),
    ):
        path = compressed(tmp_path / "a.ply", packed(), **({"chunks": CHUNK} | more))
        with pytest.raises(FileError, match=message) as caught:
            loom.read_splats(path)
        assert caught.value.path == str(path)
