"""Meshes as maps: what is seen straight from above, as colours and as heights on square cells."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_finite, check_positive, check_shape
from ...core.errors import FilePath
from ...core.units import DEGREE, METRE, is_same
from ...kernels.drawing import plan_view
from ...kernels.drawing.plan_view import CHANNELS, PlanCells
from ...kernels.drawing.surfaces import Surface
from ...kernels.lang import int32, uint8, vec2, vec3
from ...kernels.memory import download, empty, upload
from ...kernels.rays.scene_trees import SceneTrees
from ...kernels.rays.triangle_tree import TriangleTree
from ...pcd.geodesy import WorldFrame
from ...pcd.geotiff import BLOCK, geotiff
from ...pcd.raster_cells import check_box
from ...pcd.terrain import Raster
from ..mesh.mesh import TriangleMesh
from .plan_grid import PlanGrid, grid_over, grid_within

STRIP = 2**20  # cells that are looked at together, of which 24 B each lie on the device
PART = 2**18  # vertices that are projected together, some 300 B each
EVERY = -1  # as a material: all triangles


@dataclass(frozen=True, eq=False)
class Orthophoto:
    """A mesh as it is seen straight from above, as `loom.orthophoto` makes it.

    Attributes:
        colors: Red, green, blue and alpha, uint8 [rows, columns, 4], the northernmost row first; alpha is 0 where
            nothing is seen or what is seen has no colour, else 255. None of a mesh without any colours.
        heights: The highest surface at each cell's centre, a raster as of `loom.rasterize` on the same cells; NaN
            where nothing is seen. `heights.write("dem.tif")` writes it.
    """

    colors: NDArray[np.uint8] | None
    heights: Raster

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Low x, low y, high x, high y of the cells."""
        return self.heights.bounds

    def __repr__(self) -> str:
        """Its size, and how much of it is seen."""
        (rows, columns), cell = self.heights.values.shape, self.heights.cell
        seen, system = int(np.isfinite(self.heights.values).sum()), self.heights.crs or "no system"
        kind = "" if self.colors is not None else ", no colours"
        return f"Orthophoto({columns} x {rows} cells of {cell:g}, {seen:,} seen{kind}, {system})"

    def write(self, path: FilePath, *, overwrite: bool = True) -> Path:
        """Write the colours as a Cloud Optimized GeoTIFF with alpha and overviews, whole or not at all.

        Args:
            path: The file, which ends in .tif or .tiff.
            overwrite: Whether an existing file may be replaced.

        Raises:
            ValueError: The mesh had no colours.
            FileError: The file cannot be written, the package rasterio is missing, or it does not know the system.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ground = loom.TriangleMesh.create_box(40, 20, 1)
            >>> ground.vertex_colors = np.full((len(ground.vertices), 3), 0.5)
            >>> loom.orthophoto(ground, 0.5, crs="EPSG:32632").write("ortho.tif").name
            'ortho.tif'
        """
        if self.colors is None:
            raise ValueError("colors: the mesh has neither a texture nor colours of vertices; write its heights")
        told, (rows, _, _) = self.heights, self.colors.shape
        place = self.colors.shape[:2], (told.corner[0], told.corner[1]), told.cell, told
        with geotiff(path, *place, overwrite=overwrite, for_maps=True, is_picture=True) as file:
            for top in range(0, rows, BLOCK):
                part = self.colors[top : top + BLOCK]
                window = ((top, top + len(part)), (0, part.shape[1]))
                file.write(np.ascontiguousarray(np.moveaxis(part, 2, 0)), window=window)
        return Path(path)


def orthophoto(
    mesh: TriangleMesh,
    cell: float,
    *,
    frame: WorldFrame | None = None,
    epsg: int | None = None,
    corner: ArrayLike = (0.0, 0.0),
    bounds: ArrayLike | None = None,
    crs: str | None = None,
) -> Orthophoto:
    """A map of a mesh: its colours and heights as they are seen straight from above.

    Each cell is what a ray down through its centre meets first; cells that meet nothing stay empty, and nothing is made
    up between neighbours. Colours are those of the texture, between its four pixels there, or else of the vertices.

    Args:
        mesh: The mesh, z up; metres east, north and up about the origin of `frame`, where that is given.
        cell: The side of a cell [m].
        frame: Where the mesh lies on the Earth, such as `result.fit.frame` of `loom.video.reconstruct`: the map is in
            the UTM zone of that place. None keeps the mesh's own coordinates.
        epsg: Another UTM zone than that of the frame, 32601..32660 or 32701..32760.
        corner: A corner of cells, x and y.
        bounds: (x0, y0, x1, y1) that the map covers; None covers the mesh.
        crs: The coordinate system of a mesh without `frame`, for files, as rasterio takes it: "EPSG:26910" or
            well-known text.

    Returns:
        An Orthophoto, `colors` and `heights`.

    Raises:
        TypeError: No TriangleMesh, or no WorldFrame.
        ValueError: An argument out of range; a mesh in degrees, or with `frame` in another unit than metres; a mesh
            without triangles, where no bounds are given; more than 2^28 cells, with the cell that fits.
        MemoryError: The map does not fit into memory.

    Notes:
        Vertices are projected in float64, and kept about the middle of the mesh in float32: within 500 m of it to 0.03
        mm. 9 B of memory a cell for the result, 24 MB for the rays, which go in strips of rows; some 50 B a triangle.
        Of surfaces at one height the triangle of the lowest number is seen. The same bits from run to run.

        A colour is that of one place, not the mean over a cell: make cells no larger than what the texture shows.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = loom.TriangleMesh([[0, 0, 1], [8, 0, 1], [0, 8, 1]], [[0, 1, 2]], vertex_colors=np.eye(3))
        >>> made = loom.orthophoto(ground, 1.0, frame=loom.video.WorldFrame(47.5, 8.25, 430.0))
        >>> made.heights.crs, round(float(np.nanmax(made.heights.values)), 3)
        ('EPSG:32632', 431.0)
        >>> loom.orthophoto(ground, 1.0).colors[1, 0].tolist()
        [0, 16, 239, 255]
    """
    if not isinstance(mesh, TriangleMesh):
        raise TypeError(f"mesh: expected a TriangleMesh, got {type(mesh).__name__}")
    side, start = check_positive("cell", cell), check_finite("corner", check_shape("corner", corner, (2,)))
    box = None if bounds is None else check_box(bounds)
    system = _check_system(mesh, frame, epsg, crs)
    vertices, origin = _placed_vertices(mesh, frame, epsg)
    tree = TriangleTree(vertices, mesh.array("triangles"))
    if box is not None:
        grid = grid_within(box, start, side)
    elif tree.count:
        low, high = (end.astype(np.float64)[:2] + origin[:2] for end in (tree.low, tree.high))
        grid = grid_over(low, high, start, side)
    else:
        raise ValueError("mesh: has no triangles whose corners are finite; give the bounds of a map without any")
    heights = np.empty(grid.shape, np.float32)
    surfaces = _surfaces_of(mesh, vertices)
    colors = np.empty((*grid.shape, CHANNELS), np.uint8) if surfaces else None
    for rows, part_heights, part_colors in _strips(grid, tree, origin, mesh, surfaces):
        heights[rows] = part_heights
        if colors is not None:
            colors[rows] = part_colors
    told = Raster(heights, grid.corner, side, np.zeros(grid.shape, bool), "dsm", system)
    return Orthophoto(colors, told)


def _check_system(mesh: TriangleMesh, frame: Any, epsg: Any, crs: str | None) -> str | None:
    """The coordinate system, as rasterio takes it."""
    if mesh.unit is not None and is_same(mesh.unit, DEGREE):
        raise ValueError("mesh: is in degrees, which are no lengths")
    if frame is None:
        if epsg is not None:
            raise ValueError("epsg: goes with frame, which tells where the mesh lies; of a mesh in UTM give crs")
        return crs
    if not isinstance(frame, WorldFrame):
        raise TypeError(f"frame: expected a WorldFrame, got {type(frame).__name__}")
    if crs is not None:
        raise ValueError("crs: the frame has a UTM zone of its own; leave it out, or give epsg")
    if not is_same(mesh.unit, METRE):
        raise ValueError(f"mesh: is in {mesh.unit}, and a frame counts metres")
    frame.to_utm(np.zeros((1, 3)), epsg)
    return f"EPSG:{frame.epsg if epsg is None else epsg}"


def _placed_vertices(mesh: TriangleMesh, frame: WorldFrame | None, epsg: int | None) -> tuple[Any, NDArray[np.float64]]:
    """The vertices where the map has them: a device array of vec3 about an origin, float64 [3]."""
    if frame is None:
        return mesh.array("vertices"), mesh.origin
    places = np.array(mesh.vertices)
    for first in range(0, len(places), PART):
        part = places[first : first + PART]
        finite = np.isfinite(part).all(axis=1)
        part[finite] = frame.to_utm(part[finite], epsg)
    finite = places[np.isfinite(places).all(axis=1)]
    origin = (finite.min(axis=0) + finite.max(axis=0)) / 2 if len(finite) else np.zeros(3)
    places -= origin
    return upload(places.astype(np.float32), vec3, mesh.device), origin


def _surfaces_of(mesh: TriangleMesh, vertices: Any) -> list[tuple[int, Surface]]:
    """The looks of a mesh by the numbers of its materials, those of triangles without any colour left out."""
    arrays, none, device = mesh._device_arrays, empty(0, vec3, mesh.device), mesh.device
    flat = view_as(arrays["triangles"], int32, (3 * arrays["triangles"].size,))
    looks: dict[str, Any] = {"normals": none, "plain": vec3(0.0, 0.0, 0.0), "lit": False, "edges": False}
    found: list[tuple[int, Surface]] = []
    numbers = [EVERY]
    if "triangle_uvs" in arrays and mesh.textures:
        numbers = (
            [0] if "triangle_material_ids" not in arrays else np.unique(np.asarray(mesh.triangle_material_ids)).tolist()
        )
    for number in numbers:
        if 0 <= number < len(mesh.textures):
            pixels = np.ascontiguousarray(mesh.textures[number][:, :, :3])
            image = upload(pixels.ravel(), uint8, device), pixels.shape[1], pixels.shape[0]
            held = {"colors": none, "uvs": arrays["triangle_uvs"], "texture": image}
        elif "vertex_colors" in arrays:
            nothing: Any = empty(0, uint8, device), 0, 0
            held = {"colors": arrays["vertex_colors"], "uvs": empty(0, vec2, device), "texture": nothing}
        else:
            continue
        is_for_all = "triangle_material_ids" not in arrays or numbers == [EVERY]
        found.append((EVERY if is_for_all else number, Surface(vertices, flat, **held, **looks)))
    return found


def _strips(
    grid: PlanGrid, tree: TriangleTree, origin: NDArray[np.float64], mesh: TriangleMesh, surfaces: list[Any]
) -> Iterator[tuple[slice, NDArray[np.float32], NDArray[np.uint8]]]:
    """Rows of a map from the northernmost on, their heights, and their colours where there are surfaces."""
    trees, (rows, columns) = SceneTrees([tree], [0], np.eye(4)[None]), grid.shape
    top = grid.corner[1] + rows * grid.cell
    above = float(trees.high[2] + 0.01 * (trees.high[2] - trees.low[2]))
    cells = PlanCells(grid.corner[0] - origin[0], top - origin[1], grid.cell, columns, above)
    materials = mesh._device_arrays.get("triangle_material_ids")
    materials = empty(0, int32, mesh.device) if materials is None else materials
    step = max(1, STRIP // columns)
    for first in range(0, rows, step):
        strip = slice(first, min(first + step, rows))
        count = strip.stop - first
        seen = plan_view.look_down(cells, first, count, trees)
        heights = plan_view.heights_of(seen, tree.vertices, tree.triangles, float(origin[2]))
        colors = np.empty(0, np.uint8)
        if surfaces:
            colors = download(plan_view.colors_of(seen, surfaces, materials)).reshape(count, columns, CHANNELS)
        yield strip, download(heights).reshape(count, columns), colors
