"""Orthographic maps of meshes: colors and heights seen from above."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_finite, check_positive, check_shape
from ...core.coordinate_systems import map_crs
from ...core.errors import FilePath
from ...core.units import DEGREE, METRE, is_same
from ...kernels.drawing import plan_view
from ...kernels.drawing.plan_view import NUM_CHANNELS, PlanCells
from ...kernels.drawing.surfaces import Surface, Texture
from ...kernels.lang import int32, vec3
from ...kernels.memory import download, empty, upload
from ...kernels.rays.scene_trees import SceneTrees
from ...kernels.rays.triangle_tree import TriangleTree
from ...pcd.geodesy import WorldFrame
from ...pcd.geotiff import BLOCK_CELLS, geotiff
from ...pcd.raster import Raster
from ...pcd.raster_cells import check_box
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from .plan_grid import PlanGrid, grid_over, grid_within

CELLS_PER_STRIP = 2**20  # cells per batch, 24 B each on the device
VERTICES_PER_PART = 2**18  # vertices projected per batch, about 300 B each
EVERY_MATERIAL = -1  # material id for all triangles


@dataclass(frozen=True, eq=False)
class Orthophoto:
    """A mesh seen from above, as created by `loom.meshing.orthophoto`.

    Attributes:
        colors: RGBA, uint8 (rows, columns, 4), northernmost row first. Alpha is 0 if empty. None if the mesh has none.
        heights: Raster of the highest surface at cell centers. NaN if empty.
    """

    colors: NDArray[np.uint8] | None
    heights: Raster

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """(x0, y0, x1, y1) of the cells."""
        return self.heights.bounds

    def __repr__(self) -> str:
        (rows, columns), cell = self.heights.values.shape, self.heights.cell
        seen, system = int(np.isfinite(self.heights.values).sum()), self.heights.crs or "no system"
        kind = "" if self.colors is not None else ", no colors"
        return f"Orthophoto({columns} x {rows} cells of {cell:g}, {seen:,} seen{kind}, {system})"

    def write(self, path: FilePath, *, overwrite: bool = True) -> Path:
        """Write the colors as a Cloud Optimized GeoTIFF with alpha and overviews, atomically.

        Raises ValueError without colors, FileError if writing fails, rasterio is missing or the system unknown.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ground = loom.TriangleMesh.create_box(40, 20, 1)
            >>> ground.vertex_colors = np.full((len(ground.vertices), 3), 0.5)
            >>> loom.meshing.orthophoto(ground, 0.5, crs="EPSG:32632").write("ortho.tif").name
            'ortho.tif'
        """
        if self.colors is None:
            raise ValueError("colors: the mesh has neither a texture nor vertex colors. Write its heights instead")
        heights, (rows, _, _) = self.heights, self.colors.shape
        georeference = self.colors.shape[:2], (heights.corner[0], heights.corner[1]), heights.cell, heights
        with geotiff(path, *georeference, overwrite=overwrite, for_maps=True, is_image=True) as file:
            for top in range(0, rows, BLOCK_CELLS):
                part = self.colors[top : top + BLOCK_CELLS]
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
    """Create a map of a mesh: colors and heights seen from above, sampled at cell centers.

    Colors are bilinear from the texture, or interpolated from vertices. Cells without surface stay empty. Projected in
    float64, stored in float32 about the mesh's center: 0.03 mm within 500 m. 9 B per cell, 50 B per triangle. Ties go
    to the lowest triangle. Bitwise reproducible.

    Args:
        mesh: The mesh, z up. Meters east, north and up about the origin of `frame`, if given.
        cell: Edge of a cell [m], not larger than the texture's detail.
        frame: Position on the Earth, such as `result.fit.frame` of `loom.photogrammetry.reconstruct_video`: the map is
            in its UTM zone. If None: the mesh's own coordinates.
        epsg: Another UTM zone than that of the frame, 32601..32660 or 32701..32760.
        corner: A corner of cells, x and y.
        bounds: (x0, y0, x1, y1) of the map. If None: those of the mesh.
        crs: Coordinate system of a mesh without `frame` as rasterio accepts it: "EPSG:26910" or well-known text. If
            None: that of the mesh.

    Raises:
        TypeError, ValueError: If `mesh` is not a TriangleMesh, or `frame` is not a WorldFrame, or if an argument is out
            of range, the unit does not fit, there is neither a triangle nor bounds, or there are more than 2^28 cells.
        MemoryError: If the map does not fit into memory.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = loom.TriangleMesh([[0, 0, 1], [8, 0, 1], [0, 8, 1]], [[0, 1, 2]], vertex_colors=np.eye(3))
        >>> made = loom.meshing.orthophoto(ground, 1.0, frame=loom.WorldFrame(47.5, 8.25, 430.0))
        >>> made.heights.crs, round(float(np.nanmax(made.heights.values)), 3)
        ('EPSG:32632', 431.0)
        >>> loom.meshing.orthophoto(ground, 1.0).colors[1, 0].tolist()
        [0, 16, 239, 255]
    """
    check_mesh("mesh", mesh)
    side, start = check_positive("cell", cell), check_finite("corner", check_shape("corner", corner, (2,)))
    box = None if bounds is None else check_box(bounds)
    system = _check_system(mesh, frame, epsg, crs)
    vertices, origin = _vertices_in_frame(mesh, frame, epsg)
    tree = TriangleTree(vertices, mesh.arrays["triangles"])
    if box is not None:
        grid = grid_within(box, start, side)
    elif tree.count:
        low, high = (end.astype(np.float64)[:2] + origin[:2] for end in (tree.low, tree.high))
        grid = grid_over(low, high, start, side)
    else:
        raise ValueError("mesh: expected triangles with finite corners, got none. Pass bounds to create an empty map")
    heights = np.empty(grid.shape, np.float32)
    surfaces = _surfaces_of(mesh, vertices)
    colors = np.empty((*grid.shape, NUM_CHANNELS), np.uint8) if surfaces else None
    for rows, part_heights, part_colors in _strips(grid, tree, origin, mesh, surfaces):
        heights[rows] = part_heights
        if colors is not None:
            colors[rows] = part_colors
    raster = Raster(heights, grid.corner, side, np.zeros(grid.shape, bool), "dsm", system)
    return Orthophoto(colors, raster)


def _check_system(mesh: TriangleMesh, frame: Any, epsg: Any, crs: str | None) -> str | None:
    if mesh.unit is not None and is_same(mesh.unit, DEGREE):
        raise ValueError("mesh: expected a length unit, got degrees")
    if frame is None:
        if epsg is not None:
            raise ValueError("epsg: requires frame, which georeferences the mesh. For a mesh in UTM pass crs")
        return map_crs("crs, mesh", crs, mesh.crs, with_heights=True)
    if not isinstance(frame, WorldFrame):
        raise TypeError(f"frame: expected a WorldFrame, got {type(frame).__name__}")
    if crs is not None:
        raise ValueError("crs: expected None, because the frame defines a UTM zone. Pass epsg for another system")
    if not is_same(mesh.unit, METRE):
        raise ValueError(f"mesh: expected meters with a frame, got {mesh.unit}")
    frame.to_utm(np.zeros((1, 3)), epsg)
    return f"EPSG:{frame.epsg if epsg is None else epsg}"


def _vertices_in_frame(
    mesh: TriangleMesh, frame: WorldFrame | None, epsg: int | None
) -> tuple[Any, NDArray[np.float64]]:
    """Projected vertices: a device array of vec3 about an origin, float64 (3,)."""
    if frame is None:
        return mesh.arrays["vertices"], mesh.origin
    positions = np.array(mesh.vertices)
    for first in range(0, len(positions), VERTICES_PER_PART):
        part = positions[first : first + VERTICES_PER_PART]
        finite = np.isfinite(part).all(axis=1)
        part[finite] = frame.to_utm(part[finite], epsg)
    finite = positions[np.isfinite(positions).all(axis=1)]
    origin = (finite.min(axis=0) + finite.max(axis=0)) / 2 if len(finite) else np.zeros(3)
    positions -= origin
    return upload(positions.astype(np.float32), vec3, mesh.device), origin


def _surfaces_of(mesh: TriangleMesh, vertices: Any) -> list[tuple[int, Surface]]:
    """Appearance of each material. Triangles without color are omitted."""
    arrays, none = mesh.arrays, empty(0, vec3, mesh.device)
    flat = view_as(arrays["triangles"], int32, (3 * arrays["triangles"].size,))
    surfaces: list[tuple[int, Surface]] = []
    numbers = [EVERY_MATERIAL]
    if "triangle_uvs" in arrays and mesh.textures:
        numbers = (
            [0] if "triangle_material_ids" not in arrays else np.unique(np.asarray(mesh.triangle_material_ids)).tolist()
        )
    for number in numbers:
        if 0 <= number < len(mesh.textures):
            texture = Texture(mesh.textures[number], arrays["triangle_uvs"])
            surface = Surface(vertices, flat, normals=none, colors=none, texture=texture)
        elif "vertex_colors" in arrays:
            surface = Surface(vertices, flat, normals=none, colors=arrays["vertex_colors"])
        else:
            continue
        is_for_all = "triangle_material_ids" not in arrays or numbers == [EVERY_MATERIAL]
        surfaces.append((EVERY_MATERIAL if is_for_all else number, surface))
    return surfaces


def _strips(
    grid: PlanGrid, tree: TriangleTree, origin: NDArray[np.float64], mesh: TriangleMesh, surfaces: list[Any]
) -> Iterator[tuple[slice, NDArray[np.float32], NDArray[np.uint8]]]:
    """Rows of a map from the north, their heights, and colors if there are surfaces."""
    trees, (rows, columns) = SceneTrees([tree], [0], np.eye(4)[None]), grid.shape
    top = grid.corner[1] + rows * grid.cell
    above = float(trees.high[2] + 0.01 * (trees.high[2] - trees.low[2]))
    cells = PlanCells(grid.corner[0] - origin[0], top - origin[1], grid.cell, columns, above)
    materials = mesh.arrays.get("triangle_material_ids")
    materials = empty(0, int32, mesh.device) if materials is None else materials
    step = max(1, CELLS_PER_STRIP // columns)
    for first in range(0, rows, step):
        strip = slice(first, min(first + step, rows))
        count = strip.stop - first
        seen = plan_view.look_down(cells, first, count, trees)
        heights = plan_view.heights_of(seen, tree.vertices, tree.triangles, float(origin[2]))
        colors = np.empty(0, np.uint8)
        if surfaces:
            colors = download(plan_view.colors_of(seen, surfaces, materials)).reshape(count, columns, NUM_CHANNELS)
        yield strip, download(heights).reshape(count, columns), colors
