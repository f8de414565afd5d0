"""Parts of a mesh: removal and merging of triangles and vertices, selection, connected components."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import hand_out_host
from ...core.checks import check_count, check_indices, check_numeric, check_positive, is_on_gpu
from ...core.gpu_arrays import take_indices, take_mask
from ...kernels.array_types import Mask
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.duplicates import find_equal_points
from ...kernels.arrays.select import invert_mask, positions_of, positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.arrays.subsets import other_rows
from ...kernels.extent.masks import mask_finite
from ...kernels.lang import int32, uint8
from ...kernels.memory import cast, download, upload
from ...kernels.meshes import clean_triangles, crowded_edges, merge_vertices, mesh_edits
from ...kernels.meshes.clean_triangles import mask_not_finite
from ...kernels.meshes.close_vertices import find_close_vertices
from ...kernels.meshes.mesh_components import Parts
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.polygon_volume import SelectionPolygonVolume, mask_cropped
from .mesh_arrays import Mesh, MeshArrays

MIN_CELL_RATIO = 2.0**-45  # of the largest coordinate: float64 cannot resolve smaller cells


def select_by_index(mesh: Mesh, indices: ArrayLike, cleanup: bool) -> Mesh:
    """As `TriangleMesh.select_by_index`."""
    rows = _rows_of(mesh, "indices", indices, mesh.arrays.vertex_count, "vertices")
    return _select_vertices(mesh, mesh_edits.first_listed(rows, mesh.arrays.vertex_count), cleanup)


def select_faces_by_mask(mesh: Mesh, mask: ArrayLike) -> Mesh:
    """As `TriangleMesh.select_faces_by_mask`."""
    rows = _inverse_mask(mesh, mask, len(mesh), "triangles")
    return remove_unreferenced_vertices(drop_triangles(mesh, rows))


def crop(
    mesh: Mesh, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool
) -> Mesh:
    """As `TriangleMesh.crop`."""
    vertices = mesh.arrays["vertices"]
    inside = positions_of(mask_cropped(bounding_box, vertices, mesh.arrays.origin))  # sync
    return _select_vertices(mesh, other_rows(inside, vertices.size) if invert else inside, True)


def cluster_connected_triangles(mesh: MeshArrays) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
    """As `TriangleMesh.cluster_connected_triangles`."""
    parts = _parts(mesh)
    counts, areas = parts.read()
    broken = positions_of(mask_not_finite(mesh.arrays["vertices"], mesh.arrays["triangles"]))
    if broken.size:
        areas[download(parts.labels)[download(broken)]] = np.nan
    results = (hand_out_host(values, mesh.arrays.library, mesh.device) for values in (counts, areas))
    return mesh.arrays.hand_out(parts.labels, dtype=np.int32), *results


def remove_small_components(mesh: Mesh, min_triangles: int, min_area: float) -> Mesh:
    """As `TriangleMesh.remove_small_components`."""
    count, area = check_count("min_triangles", min_triangles), check_positive("min_area", min_area, allow_zero=True)
    return keep_triangles(mesh, _parts(mesh).mask_large(count, area))[0]  # sync


def remove_vertices_by_mask(mesh: Mesh, mask: ArrayLike) -> Mesh:
    """As `TriangleMesh.remove_vertices_by_mask`."""
    used = cast(_inverse_mask(mesh, mask, mesh.arrays["vertices"].size, "vertices"), int32)
    arrays = mesh.arrays.triangles_at(mesh_edits.complete_triangles(mesh.arrays["triangles"], used))
    return _keep_vertices(mesh, arrays.pop("triangles"), used, **arrays)


def remove_vertices_by_index(mesh: Mesh, vertex_indices: ArrayLike) -> Mesh:
    """As `TriangleMesh.remove_vertices_by_index`."""
    rows = _rows_of(mesh, "vertex_indices", vertex_indices, mesh.arrays.vertex_count, "vertices")
    return _at_vertices(mesh, other_rows(rows, mesh.arrays.vertex_count))


def remove_unreferenced_vertices(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.remove_unreferenced_vertices`."""
    triangles = mesh.arrays["triangles"]
    return _keep_vertices(mesh, triangles, mesh_edits.mark_referenced(triangles, mesh.arrays["vertices"].size))


def remove_duplicated_vertices(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.remove_duplicated_vertices`."""
    owners = find_equal_points(mesh.arrays["vertices"])
    new_indices, count = merge_vertices.number_owners(owners)  # sync
    owner_rows = merge_vertices.list_owners(owners, new_indices, count)
    triangles = merge_vertices.rename_corners(mesh.arrays["triangles"], owners, new_indices)
    return mesh.with_arrays(triangles=triangles, **mesh.arrays.vertices_at(owner_rows))


def merge_close(mesh: Mesh, name: str, distance: float) -> Mesh:
    """`merge_close_vertices`; `name` is the argument named in errors."""
    radius, vertices = check_positive(name, distance), mesh.arrays["vertices"]
    low, high, count = bound_points(vertices)
    extent = float(np.abs([low, high]).max()) if count else 0.0
    if radius < MIN_CELL_RATIO * extent or radius * radius == 0:
        raise ValueError(
            f"{name}: {radius:g} m is too small for coordinates up to {extent:g} m. Use remove_duplicated_vertices "
            "to merge vertices at one position"
        )
    owners = positions(vertices.size, mesh.device)
    find_close_vertices(vertices, positions_of(mask_finite(vertices, True, True), count), radius, owners)
    new_indices, count = merge_vertices.number_owners(owners)  # sync
    rows = mesh.arrays.per_vertex()
    unit = [name == "vertex_normals" for name in rows]
    means = merge_vertices.average_members(rows.values(), unit, owners, new_indices, count)
    triangles = merge_vertices.rename_corners(mesh.arrays["triangles"], owners, new_indices)
    arrays: dict[str, Any] = dict(zip(rows, means, strict=True))
    if mesh.arrays.attributes["vertex_attributes"]:
        owner_rows = merge_vertices.list_owners(owners, new_indices, count)
        arrays |= mesh.arrays.attributes_at("vertex_attributes", owner_rows)
    return mesh.with_arrays(triangles=triangles, **arrays)


def remove_triangles_by_mask(mesh: Mesh, mask: ArrayLike) -> Mesh:
    """As `TriangleMesh.remove_triangles_by_mask`."""
    rows = positions_of(_inverse_mask(mesh, mask, len(mesh), "triangles"))  # sync
    return mesh.with_arrays(**mesh.arrays.triangles_at(rows))


def remove_triangles_by_index(mesh: Mesh, triangle_indices: ArrayLike) -> Mesh:
    """As `TriangleMesh.remove_triangles_by_index`."""
    rows = _rows_of(mesh, "triangle_indices", triangle_indices, len(mesh), "triangles")
    return mesh.with_arrays(**mesh.arrays.triangles_at(other_rows(rows, len(mesh))))


def remove_degenerate_triangles(mesh: Mesh, *, zero_area: bool) -> Mesh:
    """As `TriangleMesh.remove_degenerate_triangles`."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    return drop_triangles(mesh, clean_triangles.mask_degenerate(vertices, triangles, zero_area=zero_area))


def remove_duplicated_triangles(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.remove_duplicated_triangles`."""
    return drop_triangles(mesh, clean_triangles.mask_repeats(mesh.arrays["triangles"]))


def remove_non_manifold_edges(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.remove_non_manifold_edges`."""
    crowded = crowded_edges.CrowdedTriangles(mesh.arrays["triangles"], mesh.arrays.vertex_count)
    if not crowded.rows.size:
        return mesh.with_arrays()
    plain = mesh
    if crowded.plain.size < len(mesh):
        plain = mesh.with_arrays(**mesh.arrays.triangles_at(crowded.plain))
        crowded = crowded_edges.CrowdedTriangles(plain.arrays["triangles"], mesh.arrays.vertex_count)
    vertices, triangles = plain.arrays["vertices"], plain.arrays["triangles"]
    return drop_triangles(plain, crowded_edges.mask_crowding(vertices, triangles, crowded))


def drop_triangles(mesh: Mesh, mask: wp.array) -> Mesh:
    """Remove masked triangles. All vertices stay."""
    rows = mesh_edits.unmarked_rows(mask)  # sync
    return mesh.with_arrays(**({} if rows.size == mask.size else mesh.arrays.triangles_at(rows)))


def drop_triangles_and_vertices(mesh: Mesh, removed: Mask, used: Mask) -> Mesh:
    """Remove masked triangles, and vertices outside the mask `used`. One sync."""
    rows, vertices = positions_of_each(invert_mask(removed), used)  # sync
    arrays = mesh.arrays.triangles_at(rows) | mesh.arrays.vertices_at(vertices)
    new_indices = mesh_edits.mask_and_index(vertices, used.size)[1]
    arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
    return mesh.with_arrays(**arrays)


def drop_degenerate_triangles(mesh: Mesh) -> Mesh:
    """Remove fully degenerate triangles and unused vertices. One sync."""
    triangles, count = mesh.arrays["triangles"], mesh.arrays.vertex_count
    removed = clean_triangles.mask_degenerate(mesh.arrays["vertices"], triangles, zero_area=False)
    return drop_triangles_and_vertices(mesh, removed, clean_triangles.mask_used(triangles, removed, count))


def drop_invalid_triangles(mesh: Mesh) -> Mesh:
    """Remove non-finite, degenerate and duplicate triangles and unused vertices."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    removed = clean_triangles.join_masks(
        clean_triangles.mask_repeats(triangles),
        clean_triangles.mask_degenerate(vertices, triangles, zero_area=False),
        clean_triangles.mask_not_finite(vertices, triangles),
    )
    return drop_triangles_and_vertices(mesh, removed, clean_triangles.mask_used(triangles, removed, vertices.size))


def keep_triangles(mesh: Mesh, mask: wp.array, *others: wp.array) -> tuple[Mesh, *tuple[wp.array, ...]]:
    """Select by a uint8 mask: (mesh, triangle rows, rows of used vertices, positions of other masks). One sync."""
    count = mesh.arrays["vertices"].size
    used = mesh_edits.mark_chosen(mesh.arrays["triangles"], mask, count)
    rows, vertices, *positions = positions_of_each(mask, used, *others)  # sync
    arrays = mesh.arrays.triangles_at(rows) | mesh.arrays.vertices_at(vertices)
    new_indices = mesh_edits.mask_and_index(vertices, count)[1]
    arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
    return mesh.with_arrays(**arrays), rows, vertices, *positions


def _keep_vertices(mesh: Mesh, triangles: wp.array, used: wp.array, **per_triangle: Any) -> Mesh:
    """Select by a vertex mask, int32 of 1 or 0, and drop triangles with other vertices."""
    rows = mesh.arrays.per_vertex()
    triangles, selected = mesh_edits.keep_vertices(triangles, used, rows.values())
    arrays: dict[str, Any] = dict(zip(rows, selected, strict=True))
    if mesh.arrays.attributes["vertex_attributes"]:
        arrays |= mesh.arrays.attributes_at("vertex_attributes", positions_of(cast(used, uint8)))  # sync
    return mesh.with_arrays(triangles=triangles, **arrays, **per_triangle)


def _inverse_mask(mesh: MeshArrays, mask: ArrayLike, count: int, of: str) -> wp.array:
    """Inverse of a removal mask, uint8 on the mesh's device."""
    if is_on_gpu(mask):
        return invert_mask(take_mask("mask", mask, mesh.device, count))
    return upload(~_check_mask(mask, count, of), uint8, mesh.device)


def _rows_of(mesh: MeshArrays, name: str, indices: ArrayLike, count: int, of: str) -> wp.array:
    if is_on_gpu(indices):
        return take_indices(name, indices, mesh.device, count, of=f"mesh of {count} {of}")
    rows = check_indices(name, indices, count, of=f"mesh of {count} {of}")
    return upload(rows, int32, mesh.device)


def _select_vertices(mesh: Mesh, rows: wp.array, cleanup: bool) -> Mesh:
    chosen = _at_vertices(mesh, rows)
    if not cleanup:
        return chosen
    chosen = remove_duplicated_vertices(chosen)
    vertices, triangles = chosen.arrays["vertices"], chosen.arrays["triangles"]
    repeats = clean_triangles.mask_repeats(triangles)
    used = clean_triangles.mask_used(triangles, repeats, vertices.size)  # keep those of degenerate triangles
    degenerate = clean_triangles.mask_degenerate(vertices, triangles, zero_area=False)
    return drop_triangles_and_vertices(chosen, clean_triangles.join_masks(repeats, degenerate), used)


def _at_vertices(mesh: Mesh, rows: wp.array) -> Mesh:
    """Select vertices by row, each once, and the triangles between them."""
    used, new_indices = mesh_edits.mask_and_index(rows, mesh.arrays.vertex_count)
    arrays = mesh.arrays.triangles_at(mesh_edits.complete_triangles(mesh.arrays["triangles"], used))  # sync
    arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
    arrays |= mesh.arrays.vertices_at(rows)
    return mesh.with_arrays(**arrays)


def _parts(mesh: MeshArrays) -> Parts:
    return Parts(mesh.arrays["vertices"], mesh.arrays["triangles"])


def _check_mask(mask: ArrayLike, count: int, of: str) -> NDArray[np.bool_]:
    chosen = check_numeric("mask", mask)
    if chosen.dtype != np.bool_ and not (chosen.size == 0 and isinstance(mask, list | tuple)):  # [] is float64
        raise ValueError(f"mask: expected booleans, one for each of the mesh's {of}, got {chosen.dtype}")
    if chosen.shape != (count,):
        raise ValueError(f"mask: expected shape [{count}], one for each of the mesh's {of}, got {list(chosen.shape)}")
    return chosen.astype(np.bool_)
