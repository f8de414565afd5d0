"""`pointloom video --ortho --dem`: maps of georeferenced models, and rejection of others."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm.image_positions import PicturePlace, PicturePlaces
from pointloom.photogrammetry.video import motion

from ...cli.commands import names_in, run
from .conftest import COUNT
from .made_flights import FRAME

STAGES = ["frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh"]


def gps_positions(count=COUNT, size=20.0, level=True):
    """GPS of the fast stages' pictures for a unit of `size` meters, with x east and y north as in their poses."""
    k = np.arange(count)
    enu = size * np.column_stack([0.5 * k, np.where(k % 2 == 0, -1.0, 0.0), np.zeros(count)])
    enu[:, 1] *= level
    rows = FRAME.to_geodetic(enu).tolist()
    positions = [
        PicturePlace(f"frame_{10 * k:06d}.png", *row, horizontal_sigma=0.02, vertical_sigma=0.02)
        for k, row in enumerate(rows)
    ]
    return PicturePlaces(tuple(positions), {}, {}, COUNT)


def settings_with(positions, **units):
    return loom.video.Settings(units=loom.video.Units(places=positions, **units))


def outputs(folder, cell=0.5):
    return loom.video.Outputs(folder / "m.ply", ortho=folder / "ortho.tif", dem=folder / "dem.tif", cell=cell)


def test_maps_are_georeferenced_by_gps(quick, film, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    result = loom.video.reconstruct(film, settings_with(gps_positions()), outputs=outputs(tmp_path), device="cpu")
    assert result.fit is not None and result.fit.by == "exif" and result.mesh is not None
    assert [name.rsplit("/", 1)[1] for name in result.files] == ["m.ply", "ortho.tif", "dem.tif"]
    vertices = result.fit.frame.to_utm(result.mesh.vertices)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    first_camera = FRAME.to_utm([[0.0, 0, 0]])[0]
    assert np.abs(first_camera[:2] - low[:2]).max() < 1 and np.abs(high[:2] - low[:2] - 20).max() < 1
    with rasterio.open(tmp_path / "ortho.tif") as ortho, rasterio.open(tmp_path / "dem.tif") as dem:
        assert ortho.crs.to_epsg() == dem.crs.to_epsg() == result.fit.frame.epsg == 32632
        assert (ortho.bounds, ortho.res) == (dem.bounds, (0.5, 0.5))
        assert np.abs(np.array(ortho.bounds) - (*low[:2], *high[:2])).max() <= 0.5
        colors, heights = ortho.read(), dem.read(1, masked=True)
    assert (colors[:3, colors[3] == 255] == 255).all()
    assert (colors[3] == 255).sum() * 0.25 == pytest.approx(400, rel=0.1)
    assert heights.min() >= low[2] - 1e-3 and heights.max() <= high[2] + 1e-3
    np.testing.assert_array_equal(heights.mask, colors[3] == 0)


@pytest.mark.parametrize(
    "settings",
    [
        loom.video.Settings(),  # a film
        loom.video.Settings(units=loom.video.Units(scale=2.0)),
        settings_with(gps_positions(2)),
        settings_with(gps_positions(), align="none"),
    ],
)
def test_maps_without_georeference_are_rejected_early(quick, film, tmp_path, settings):
    pytest.importorskip("rasterio")
    with pytest.raises(loom.FileError, match=r"ortho\.tif"):
        loom.video.reconstruct(film, settings, outputs=outputs(tmp_path))
    assert (quick.ran, names_in(tmp_path)) == ([], ["walk.mp4"])


def test_maps_with_collinear_gps_are_rejected_before_depth(quick, film, tmp_path):
    pytest.importorskip("rasterio")
    with pytest.raises(loom.FileError, match=r"ortho\.tif"):
        loom.video.reconstruct(film, settings_with(gps_positions(level=False)), outputs=outputs(tmp_path))  # on a line
    assert (quick.ran, names_in(tmp_path)) == (STAGES[:4], ["walk.mp4"])


def test_too_many_cells_are_rejected_early(quick, film, tmp_path, monkeypatch):
    pytest.importorskip("rasterio")
    read = motion.read_model

    def with_points(made):
        model = read(made)
        points = np.random.default_rng(0).uniform(0, 1, (50, 3))
        return loom.SfmModel(model.names, model.cameras, model.T_camera_world, points)

    monkeypatch.setattr(motion, "read_model", with_points)
    with pytest.raises(ValueError, match="cell:"):
        loom.video.reconstruct(film, settings_with(gps_positions()), outputs=outputs(tmp_path, 1e-5))
    assert quick.ran == STAGES[:4]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--ortho", "o.tif"), "--cell"),
        (("--dem", "d.tif", "--cell", "0"), "--cell"),
        (("--dem", "d.png", "--cell", "1"), r"d.png: is not a GeoTIFF file name"),
        (("--ortho", "o.tif", "--dem", "o.tif", "--cell", "1"), "o.tif"),
    ],
)
def test_the_command_rejects_invalid_maps(quick, film, tmp_path, monkeypatch, words, message):
    pytest.importorskip("rasterio")
    monkeypatch.chdir(tmp_path)
    result = run("video", film, "-o", "m.ply", *words)
    assert result.exit_code in (1, 2) and message in " ".join(result.stderr.split())
    assert quick.ran == []


@pytest.mark.parametrize("given", [{"ortho": "o.tif"}, {"cell": 1.0}, {"dem": "d.tif", "cell": -1.0}])
def test_maps_and_cells_go_together(given):
    with pytest.raises(ValueError, match="cell: "):
        loom.video.Outputs("m.ply", **given)
