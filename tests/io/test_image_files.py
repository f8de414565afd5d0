"""Depth maps and images are read exactly or rejected; a damaged PNG is never read as another image."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from pointloom.core.errors import FileError
from pointloom.io.pictures.image_files import PictureHeader, read_color, read_depth, read_picture_header, write_png

from .png_files import png_claiming, with_checksums

BITS = settings(
    max_examples=25, derandomize=True, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def test_round_trip_is_exact(tmp_path, depth, color):
    for array, read in ((depth, read_depth), (color, read_color)):
        write_png(tmp_path / "p.png", array)
        again = read(tmp_path / "p.png")
        assert again.dtype == array.dtype and again.flags.writeable and np.array_equal(again, array)


@pytest.mark.parametrize("view", ["transposed", "every other", "other byte order"])
def test_any_memory_layout_is_written_correctly(tmp_path, depth, view):
    array = {"transposed": depth.T, "every other": depth[::2, ::-2], "other byte order": depth.astype(">u2")}[view]
    write_png(tmp_path / "d.png", array)
    assert np.array_equal(read_depth(tmp_path / "d.png"), array)


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGBA", "CMYK"])
def test_every_kind_of_picture_becomes_rgb(tmp_path, color, mode):
    name = "c.jpg" if mode == "CMYK" else "c.png"
    picture = Image.fromarray(color).convert(mode)
    picture.save(tmp_path / name)
    again = read_color(tmp_path / name)
    assert again.shape == (24, 32, 3) and again.dtype == np.uint8
    if mode != "CMYK":
        assert np.array_equal(again, np.asarray(picture.convert("RGB")))


def test_transparency_is_dropped_and_does_not_darken(tmp_path, color):
    rgba = np.concatenate([color, np.zeros((24, 32, 1), np.uint8)], axis=2)
    Image.fromarray(rgba).save(tmp_path / "c.png")
    assert np.array_equal(read_color(tmp_path / "c.png"), color)
    palette = Image.fromarray(color).convert("P")
    palette.save(tmp_path / "p.png", transparency=bytes(range(256)))
    assert np.array_equal(read_color(tmp_path / "p.png"), np.asarray(palette.convert("RGB")))


def test_float_depth_is_read_from_npy_with_nan(tmp_path):
    depth = np.array([[0.0, 1.5, np.nan], [np.inf, -1.0, 3.25]], np.float32)
    for k, array in enumerate((depth, np.asfortranarray(depth), depth.astype(">f4"))):
        np.save(tmp_path / f"{k}.npy", array)
        again = read_depth(tmp_path / f"{k}.npy")
        assert again.dtype == np.float32 and again.dtype.isnative and again.flags.c_contiguous and again.flags.writeable
        np.testing.assert_array_equal(again, depth)


def test_headers_report_size_and_type_without_pixels(tmp_path, depth, color):
    write_png(tmp_path / "d.png", depth)
    (tmp_path / "d.png").write_bytes((tmp_path / "d.png").read_bytes()[:33])
    assert read_picture_header(tmp_path / "d.png") == PictureHeader("png", 32, 24, 1, 16)
    Image.fromarray(color).save(tmp_path / "c.jpg")
    assert read_picture_header(tmp_path / "c.jpg") == PictureHeader("jpeg", 32, 24, 3, 8)


def test_pictures_are_not_taken_for_depth_nor_depth_or_an_animation_for_color(tmp_path, depth, color):
    for mode in ("L", "RGB", "RGBA", "P"):
        Image.fromarray(color).convert(mode).save(tmp_path / "c.png")
        with pytest.raises(FileError, match=r"/c\.png:.*16-bit"):
            read_depth(tmp_path / "c.png")
    Image.fromarray(color).save(tmp_path / "c.jpg")
    with pytest.raises(FileError, match=r"/c\.jpg:"):
        read_depth(tmp_path / "c.jpg")
    write_png(tmp_path / "d.png", depth)
    with pytest.raises(FileError, match=r"c\.png|d\.png.*read_depth"):
        read_color(tmp_path / "d.png")
    frames = [Image.fromarray(color), Image.fromarray(255 - color)]
    frames[0].save(tmp_path / "a.png", save_all=True, append_images=frames[1:])
    with pytest.raises(FileError, match="an animation"):
        read_color(tmp_path / "a.png")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"P5 2 2 65535\n", "neither PNG nor JPEG"),
        (b"\x89PNG\r\n\x1a\n", "damaged PNG header"),
        (b"\xff\xd8\xff\xe0", "damaged image"),
        (png_claiming(2**20, 2**20), "1048576 x 1048576"),
        (png_claiming(2**31 - 1, 1), "expected 1 to"),
        (png_claiming(400, 300), "take 240300 bytes, but its stream of pixels contains 64"),
        (png_claiming(4, 4)[:-12], "the end of the PNG is missing"),
        (png_claiming(2**14, 2**14), "take 536887296 bytes"),
        (b"\x93NUMPY", ".npy header"),
        (b"\x93NUMPY\x07\x00" + bytes(200), ".npy header"),
    ],
)
def test_damaged_files_are_refused(tmp_path, data, message):
    path = tmp_path / "x.png"
    path.write_bytes(data)
    with pytest.raises(FileError, match=r"x\.png") as caught:
        read_depth(path)
    assert message in str(caught.value)


def test_other_arrays_and_headers_with_a_non_numeric_shape_are_no_depth(tmp_path):
    path = tmp_path / "d.npy"
    for array in (np.zeros((0, 3), np.float32), np.array([[None]]), np.ones((1, 4), np.float32)):
        np.save(path, array, allow_pickle=True)
        path.write_bytes(path.read_bytes().replace(b"(1, 4), }   ", b"(True, 4), }"))
        with pytest.raises(FileError, match=r"d\.npy"):
            read_depth(path)


def test_npy_with_too_few_bytes_is_rejected_before_allocation(tmp_path):
    np.save(tmp_path / "d.npy", np.zeros((10, 10), np.float32))
    data = (tmp_path / "d.npy").read_bytes()
    (tmp_path / "d.npy").write_bytes(data[:-1])
    with pytest.raises(FileError, match=r"/d\.npy:.*399.*400"):
        read_depth(tmp_path / "d.npy")
    (tmp_path / "d.npy").write_bytes(data.replace(b"(10, 10)", b"(99999, 99999)"))
    with pytest.raises(FileError, match="pixels, got 99999 x 99999"):
        read_depth(tmp_path / "d.npy")


def test_missing_files_and_folders_are_file_errors(tmp_path):
    for read in (read_depth, read_color, read_picture_header):
        for path in (tmp_path / "none.png", tmp_path):
            with pytest.raises(FileError, match="cannot be read"):
                read(path)


def test_arrays_and_names_unsupported_by_png_are_rejected(tmp_path, depth):
    with pytest.raises(TypeError, match="list"):
        write_png(tmp_path / "x.png", [[1, 2]])
    for shape, message in ((4, "shape"), ((0, 4), "pixels")):
        with pytest.raises(ValueError, match=message):
            write_png(tmp_path / "x.png", np.zeros(shape, np.uint8))
    assert not list(tmp_path.iterdir())
    with pytest.raises(FileError, match=r"/d\.jpg:"):
        write_png(tmp_path / "d.jpg", depth)
    with pytest.raises(FileError, match=r"/d\.png:"):
        write_png(tmp_path / "none" / "d.png", depth)


@BITS
@given(offset=st.integers(0, 10_000), change=st.integers(1, 255))
def test_any_changed_byte_is_detected(tmp_path, depth, offset, change):
    write_png(tmp_path / "d.png", depth)
    data = bytearray((tmp_path / "d.png").read_bytes())
    data[offset % len(data)] ^= change
    (tmp_path / "d.png").write_bytes(data)
    with pytest.raises(FileError):
        read_depth(tmp_path / "d.png")


@pytest.mark.parametrize("name", ["c.png", "c.jpg", "d.npy"])
@BITS
@given(
    start=st.integers(0, 10_000), length=st.integers(0, 8), patch=st.binary(max_size=8), valid_checksums=st.booleans()
)
def test_changed_bytes_give_a_picture_or_a_file_error(tmp_path, color, name, start, length, patch, valid_checksums):
    """Includes corrected checksums, so that the decoder sees the damage."""
    path = tmp_path / name
    if name == "d.npy":
        np.save(path, color[:, :, 0].astype(np.float32))
    else:
        Image.fromarray(color[:8, :8]).save(path)
    data = path.read_bytes()
    start %= min(len(data), 160) if name == "d.npy" else len(data)
    data = data[:start] + patch + data[start + length :]
    path.write_bytes(with_checksums(data) if valid_checksums and name == "c.png" else data)
    try:
        array = read_depth(path) if name == "d.npy" else read_color(path)
    except FileError:
        return
    assert array.ndim == (2 if name == "d.npy" else 3) and array.size
