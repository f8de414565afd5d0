"""Transparency: colors are blended from front to back in any input order; the background can be transparent."""

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.visualization.render.picture_files import save_picture

SIZE = (64, 48)
RED, BLUE, GREEN = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)


def wall(z, color, opacity=1.0, half=3.0):
    """A square across the image (or a part of it) at a depth [m], as bright as its color."""
    corners = np.array([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]])
    mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]])
    return {"geometry": mesh, "color": color, "opacity": opacity, "shaded": False}


def dots(z, color, opacity, spacing=0.05):
    """A cloud of overlapping discs across the middle of the image."""
    steps = np.arange(-0.6, 0.6, spacing)
    x, y = (each.ravel() for each in np.meshgrid(steps, steps))
    cloud = loom.PointCloud(np.column_stack([x, y, np.full(x.size, float(z))]))
    return {"geometry": cloud, "color": color, "opacity": opacity, "shaded": False, "point_size": 9}


def view():
    """A camera at the origin that looks along z."""
    camera = loom.PinholeCameraIntrinsic(*SIZE, 60.0, 60.0, (SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2)
    return loom.View(camera, np.eye(4))


def draw(*geometries, **options):
    return loom.render(list(geometries), view(), **options)


def middle(picture):
    return picture[SIZE[1] // 2, SIZE[0] // 2].astype(int).tolist()


def test_colors_are_blended_with_the_background_by_opacity(device):
    picture = draw(wall(2, RED, 0.4), wall(3, BLUE), device=device)
    assert middle(picture) == [102, 0, 153]
    assert middle(draw(wall(2, RED, 0.4), background="black", device=device)) == [102, 0, 0]


def test_layers_are_sorted_by_depth_for_any_input_order(device):
    walls = [wall(2, RED, 0.5), wall(3, GREEN, 0.5), wall(4, BLUE, 0.5)]
    picture = draw(*walls, background="black", device=device)
    assert np.abs(np.array(middle(picture)) - [127.5, 63.75, 31.875]).max() <= 1
    assert draw(*walls[::-1], background="black", device=device).tobytes() == picture.tobytes()


def test_faces_behind_faces_of_one_mesh_are_seen(device):
    ball = loom.TriangleMesh.create_sphere(1.0).translate((0, 0, 4))
    style = {"color": RED, "opacity": 0.5, "shaded": False}
    both = draw({"geometry": ball, **style}, background="black", device=device)
    front = draw({"geometry": ball, **style, "back_faces": False}, background="black", device=device)
    assert middle(front) == [128, 0, 0] and middle(both) == [191, 0, 0]


def test_discs_of_one_cloud_that_overlap_are_one_layer(device):
    picture = draw(dots(2, RED, 0.4), wall(3, BLUE), device=device)
    inside = picture[20:28, 26:38].reshape(-1, 3)
    assert (inside == [102, 0, 153]).all()


def test_a_cloud_between_two_walls_is_behind_the_one_and_before_the_other(device):
    shown = [wall(3, BLUE, 0.5), dots(2, RED, 0.5), wall(1, GREEN, 0.5)]
    assert np.abs(np.array(middle(draw(*shown, background="black", device=device))) - [63.75, 127.5, 31.875]).max() <= 1


def test_opaque_surfaces_hide_transparent_ones(device):
    assert middle(draw(wall(2, RED), wall(3, GREEN, 0.5), dots(4, BLUE, 0.5), device=device)) == [255, 0, 0]


def test_zero_opacity_is_invisible_and_full_opacity_is_the_default(device):
    plain = wall(2, RED)
    del plain["opacity"]
    assert draw(wall(2, RED, 1.0), device=device).tobytes() == draw(plain, device=device).tobytes()
    assert middle(draw(wall(2, RED, 0.0), wall(3, BLUE), device=device)) == [0, 0, 255]


def test_beyond_the_maximum_of_layers_the_opaque_surface_follows(device):
    walls = [wall(2 + 0.05 * k, RED, 0.02) for k in range(40)]
    red, _, blue = middle(draw(*walls, wall(9, BLUE), device=device))
    assert red == round(255 * (1 - 0.98**16)) and blue == round(255 * 0.98**16)


def test_depth_is_that_of_opaque_surfaces(device):
    _, depth = draw(wall(2, RED, 0.5), wall(3, BLUE, half=0.3), depth=True, device=device)
    assert depth[24, 32] == pytest.approx(3.0) and depth[0, 0] == 0


def test_a_transparent_background_leaves_colors_and_how_opaque_they_are(device):
    picture = draw(wall(2, RED, 0.4), wall(3, BLUE, half=0.3), background="transparent", device=device)
    assert picture.shape == (*SIZE[::-1], 4) and repr(picture) == "Picture(64 x 48)" and picture._repr_png_()
    assert middle(picture) == [102, 0, 153, 255]
    assert picture[1, 1].tolist() == [255, 0, 0, 102]
    nothing = draw(wall(2, RED, half=0.2), background="transparent", device=device)
    assert nothing[0, 0].tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("ground", ["black", (0.2, 0.4, 1.0)])
def test_a_transparent_picture_laid_over_a_ground_is_the_picture_before_it(device, ground):
    ball = loom.TriangleMesh.create_sphere(1.0).translate((0, 0, 4))
    shown = [{"geometry": ball, "opacity": 0.6}, wall(6, GREEN, 0.5, half=1.4)]
    words = {"legend": [("a", RED)], "labels": [("here", (0, 0, 3))], "scale_bar": True}
    clear = draw(*shown, background="transparent", device=device, **({} if ground == "black" else words))
    opaque = draw(*shown, background=ground, device=device, **({} if ground == "black" else words))
    share = clear[..., 3:] / 255
    laid = clear[..., :3] * share + 255 * np.array((0, 0, 0) if ground == "black" else ground) * (1 - share)
    assert np.abs(laid - opaque).max() <= 2.5


@pytest.mark.parametrize("name", ["a.png", "a.webp"])
def test_files_contain_transparent_geometries(tmp_path, name):
    picture = draw(wall(2, RED, 0.4, half=0.5), background="transparent")
    save_picture(tmp_path / name, picture)
    with Image.open(tmp_path / name) as read:
        assert read.mode == "RGBA" and np.array_equal(np.array(read), picture)


@pytest.mark.parametrize("name", ["a.jpg", "a.gif"])
def test_files_without_transparency_support_are_rejected_with_a_remedy(tmp_path, name):
    with pytest.raises(FileError, match="does not support transparency"):
        save_picture(tmp_path / name, np.zeros((4, 4, 4), np.uint8))


def test_lines_are_light_before_black(device):
    box = loom.AxisAlignedBoundingBox([-1, -1, 4], [1, 1, 6])
    assert draw(box, background="black", device=device).max() > 200
    assert draw({"geometry": box, "color": (0.1, 0.1, 0.1)}, background="black", device=device).max() < 40


@pytest.mark.parametrize(("opacity", "kind"), [(1.5, ValueError), (-0.1, ValueError), ("half", TypeError)])
def test_an_opacity_out_of_range_is_refused(opacity, kind):
    with pytest.raises(kind, match="opacity"):
        draw(wall(2, RED, opacity))
    with pytest.raises(ValueError, match="opacity:"):
        draw({"geometry": loom.AxisAlignedBoundingBox([0, 0, 1], [1, 1, 2]), "opacity": 0.5})
