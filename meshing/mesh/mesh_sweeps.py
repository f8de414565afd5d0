"""Meshes swept along lines and about axes, polygons filled, profiles turned.

In NumPy: what is swept is small, and made once.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_number,
    check_numeric,
    check_rows,
    check_shape,
    shown,
)
from ...core.coordinates import split_origin
from ...core.dropped_results import returns_new
from ...kernels.lang import int32, vec3, vec3i
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import upload
from .flat_polygons import fill_loops, signed_area, turn_by_depth
from .mesh_measures import MeshMeasures
from .mesh_shapes import MeshShapes, check_vertex_count
from .shape_arrays import Shape

SAME_AREA = 1e-6  # of a polygon's area: what its triangles may be off


LARGEST_STEP = 1e30  # [m] or times: float32 ends at 3e38


class MeshSweeps(MeshShapes, MeshMeasures):
    """The part of TriangleMesh that makes meshes of outlines and of other meshes that move."""

    @returns_new
    def extrude_linear(self, vector: ArrayLike, scale: float = 1.0, capping: bool = True) -> Self:
        """What the mesh sweeps when it moves along a vector.

        Args:
            vector: The way [m], shape [3].
            scale: What the vector is multiplied with.
            capping: Keep the mesh at the beginning and at the end; else only the walls that its border sweeps.

        Returns:
            Its vertices where they begin, then where they end; triangles at the beginning, at the end, and of the
            walls, all facing outwards. A mesh in one piece whose triangles turn one way and face the vector all over,
            or turn away from it, makes a watertight one. Colours and attributes stay, normals are made anew where there
            were any, textures are left behind.

        Raises:
            ValueError: Not three finite numbers, or a way without a length.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> wedge = loom.TriangleMesh([[1, 1, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 2]]).extrude_linear([0, 0, 1])
            >>> wedge.is_watertight(), wedge.get_volume(), len(wedge)
            (True, 0.5, 8)
        """
        way = check_finite("vector", check_shape("vector", vector, (3,))) * _check_length("scale", scale)
        if not way.any():
            raise ValueError("vector: expected a way of some length, got none")
        corners = self.vertices
        return self._swept(np.stack([corners, corners + way]), False, bool(capping))

    @returns_new
    def extrude_rotation(
        self, angle: float, axis: ArrayLike, resolution: int = 16, translation: float = 0.0, capping: bool = True
    ) -> Self:
        """What the mesh sweeps when it turns about an axis through zero, and moves along it on the way.

        Args:
            angle: [degrees], of any size.
            axis: A direction, shape [3]; the mesh turns to the left seen against it.
            resolution: Steps.
            translation: The way along the axis [m].
            capping: As of `extrude_linear`.

        Returns:
            Its vertices after each step, those on the axis once where nothing moves along it; triangles at the
            beginning, at the end, and of the walls, step by step. A whole turn without a translation closes: the last
            vertices are the first ones (Open3D keeps both), and no ends are kept. Else as `extrude_linear`.

        Raises:
            ValueError: No direction, an angle of zero, no step, or more than 2^22 vertices.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> square = loom.TriangleMesh([[2, 0, 0], [3, 0, 0], [3, 0, 1], [2, 0, 1]], [[0, 1, 2], [0, 2, 3]])
            >>> ring = square.extrude_rotation(360, [0, 0, 1], resolution=32)
            >>> ring.is_watertight(), ring.euler_poincare_characteristic()
            (True, 0)
        """
        way = check_direction("axis", axis)
        whole, rise = np.radians(_check_length("angle", angle)), _check_length("translation", translation)
        if not whole:
            raise ValueError("angle: expected one other than zero")
        steps = check_count("resolution", resolution, minimum=1)
        corners = self.vertices
        check_vertex_count("resolution", (steps + 1) * len(corners))
        shares = np.linspace(0, 1, steps + 1)[:, None, None]
        along = matmul(corners, way)[:, None] * way
        across, side = corners - along, np.cross(way, corners)
        rings = along + np.cos(whole * shares) * across + np.sin(whole * shares) * side + rise * shares * way
        is_closed = not rise and abs(abs(float(angle)) - 360) < 1e-9 and steps > 2
        if not rise:
            reach = np.linalg.norm(across, axis=1)
            rings[:, reach <= 1e-7 * np.abs(corners).max(initial=0)] = corners[
                reach <= 1e-7 * np.abs(corners).max(initial=0)
            ]
        return self._swept(rings, is_closed, bool(capping) and not is_closed)

    @classmethod
    def from_polygon(cls, outline: ArrayLike, holes: Sequence[ArrayLike] = (), *, device: Any = None) -> Self:
        """A flat polygon with holes, in triangles.

        Args:
            outline: Its corners in order [m], shape [k, 2] in the plane z = 0 or [k, 3]; the first one may stand at the
                end again.
            holes: Outlines of holes, likewise.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            All corners in their order, and triangles between them alone, those along straight lines too. In two
            dimensions it faces up, in three the side from which the outline runs to the left.

        Raises:
            ValueError: Fewer than three corners, numbers that are not finite, corners off one plane, or outlines that
                cross themselves or each other.
            TypeError: No numbers.
            ImportError: manifold3d is not installed.
            DeviceError: No such device.

        Notes:
            A point is off the plane beyond 1e-6 of the outline's length. Same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> hole = [[1, 1], [2, 1], [2, 2], [1, 2]]
            >>> frame = loom.TriangleMesh.from_polygon([[0, 0], [3, 0], [3, 3], [0, 3]], [hole])
            >>> frame.get_surface_area(), frame.extrude_linear([0, 0, 2]).get_volume()
            (8.0, 16.0)
        """
        if (
            not isinstance(holes, Sequence | np.ndarray)
            or isinstance(holes, str | bytes)
            or getattr(holes, "ndim", 1) == 0
        ):
            raise TypeError(f"holes: expected a list of outlines, got {shown(holes)}")
        loops = [_open_ring("outline", outline), *(_open_ring("holes", hole) for hole in holes)]
        if len({loop.shape[1] for loop in loops}) > 1:
            raise ValueError("holes: expected as many coordinates as those of the outline")
        places = np.concatenate(loops)
        flat = _flattened(places, len(loops[0]))
        parts = np.split(flat, np.cumsum([len(loop) for loop in loops])[:-1])
        turned = turn_by_depth(parts)
        order = np.split(np.arange(len(flat)), np.cumsum([len(loop) for loop in loops])[:-1])
        order = [rows[::-1] if turn else rows for rows, turn in zip(order, turned, strict=True)]
        triangles = np.concatenate(order)[fill_loops("from_polygon", [flat[rows] for rows in order])]
        _check_area(flat, order, triangles)
        if places.shape[1] == 2:
            places = np.c_[places, np.zeros(len(places))]
        return cls._of(Shape(places, triangles, np.zeros((0, 2))), device)

    @classmethod
    def revolve(cls, profile: ArrayLike, angle: float = 360.0, resolution: int = 64, *, device: Any = None) -> Self:
        """The surface that a line sweeps when it turns about the z axis.

        Args:
            profile: Its points as distance from the axis and height [m], shape [k, 2]; a line that goes up faces
                outwards. Where the last point is the first one again, it closes.
            angle: [degrees], up to 360 either way; with less the surface is open.
            resolution: Steps.
            device: As of `from_polygon`.

        Returns:
            The points of the line after each step, those on the axis once.

        Raises:
            ValueError: Fewer than two points, a distance below zero, no step, or more than 2^22 vertices.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> vase = loom.TriangleMesh.revolve([[0, 0], [1, 0], [0.5, 2], [0, 2]])
            >>> vase.is_watertight(), round(vase.get_volume(), 2)
            (True, 3.66)
        """
        line = check_finite("profile", check_rows("profile", profile, 2, dtype=np.float64))
        if len(line) < 2 or (line[:, 0] < 0).any():
            raise ValueError(f"profile: expected two points or more, none closer than zero, got {line.tolist()[:4]}")
        turn, steps = check_number("angle", angle), check_count("resolution", resolution, minimum=3)
        if not 0 < abs(turn) <= 360:
            raise ValueError(f"angle: expected up to 360 degrees either way, got {turn}")
        is_ring = len(line) > 2 and bool((line[0] == line[-1]).all())
        line = line[:-1] if is_ring else line
        check_vertex_count("profile, resolution", (steps + 1) * len(line))
        angles = np.radians(turn) * np.linspace(0, 1, steps + 1)
        radius, height = line.T
        rings = np.stack(
            [np.outer(np.cos(angles), radius), np.outer(np.sin(angles), radius), np.tile(height, (steps + 1, 1))], -1
        )
        first = np.arange(len(line) - (not is_ring))
        pairs = np.c_[first, (first + 1) % len(line)]
        if turn < 0:
            pairs = pairs[:, ::-1]
        numbers = _ring_numbers(rings, abs(turn) == 360)
        used, triangles = _used(_walls(numbers, pairs))
        return cls._of(Shape(rings.reshape(-1, 3)[used], triangles, np.zeros((0, 2))), device)

    def _swept(self, rings: NDArray[np.float64], is_closed: bool, capping: bool) -> Self:
        """The mesh with its vertices at each of some places, [k, m, 3], joined by walls along its border."""
        own = self.triangles.astype(np.int64)
        sides = own[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        low, high = np.sort(sides, axis=1).T
        _, group, counts = np.unique(low * (len(self.vertices) + 1) + high, return_inverse=True, return_counts=True)
        on_border = np.flatnonzero(counts[group.reshape(-1)] == 1)
        numbers = _ring_numbers(rings, is_closed)
        places = rings.reshape(-1, 3)
        ends = np.concatenate([numbers[0][own[:, ::-1]], numbers[-1][own]])
        walls = _walls(numbers, sides[on_border])
        whole = walls if is_closed else np.concatenate([ends, walls])
        sources = np.concatenate(
            [np.arange(len(own)), np.arange(len(own)), np.tile(on_border // 3, 2 * (len(rings) - 1))]
        )
        keep = np.ones(len(whole), bool) if capping or is_closed else np.arange(len(whole)) >= 2 * len(own)
        sources = sources[2 * len(own) :] if is_closed else sources
        keep &= (whole != np.roll(whole, 1, axis=1)).all(axis=1)
        if _volume(places, whole) < 0:
            whole = whole[:, ::-1]
        used, triangles = _used(whole[keep])
        return self._with_copies(places[used], used % max(rings.shape[1], 1), triangles, sources[keep])

    def _with_copies(self, places: Any, of_vertices: Any, triangles: Any, of_triangles: Any) -> Self:
        """Vertices and triangles that have what belongs to some of this mesh, but for normals and textures."""
        local, origin = split_origin(places)
        bare = self._with_arrays(triangle_uvs=None, vertex_normals=None)
        arrays = bare._vertices_at(upload(of_vertices.astype(np.int32), int32, self._device))
        arrays |= bare._triangles_at(upload(of_triangles.astype(np.int32), int32, self._device))
        arrays["vertices"] = upload(local, vec3, self._device)
        arrays["triangles"] = upload(triangles.astype(np.int32), vec3i, self._device)
        swept = bare._with_arrays(**arrays, origin=origin)
        return swept.compute_vertex_normals() if "vertex_normals" in self._arrays else swept


def _check_length(name: str, value: Any) -> float:
    """A number that places can be multiplied by or moved by, and stay within float32 about their middle."""
    number = check_number(name, value)
    if abs(number) > LARGEST_STEP:
        raise ValueError(f"{name}: expected a number up to {LARGEST_STEP:g}, got {number:g}")
    return number


def _ring_numbers(rings: NDArray[np.float64], is_closed: bool) -> NDArray[np.int64]:
    """The number of each vertex at each place, [k, m]; those that stay where they are have one."""
    count, width = rings.shape[:2]
    numbers = np.arange(count * width).reshape(count, width)
    numbers[:, (rings == rings[0]).all(axis=(0, 2))] = numbers[:1, (rings == rings[0]).all(axis=(0, 2))]
    if is_closed:
        numbers[-1] = numbers[0]
    return numbers


def _walls(numbers: NDArray[np.int64], lines: NDArray[np.int64]) -> NDArray[np.int64]:
    """Two triangles for each step of each line, [2 (k - 1) n, 3]."""
    a, b = numbers[:-1, lines[:, 0]], numbers[:-1, lines[:, 1]]
    c, d = numbers[1:, lines[:, 1]], numbers[1:, lines[:, 0]]
    return (
        np.concatenate(
            [
                np.stack(corners, -1)
                for pair in zip(a, b, c, d, strict=True)
                for corners in ((pair[0], pair[1], pair[2]), (pair[0], pair[2], pair[3]))
            ]
        )
        if len(a)
        else np.zeros((0, 3), np.int64)
    )


def _used(triangles: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """(the vertices that triangles use, the triangles by their places among them)."""
    triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
    used, numbers = np.unique(triangles, return_inverse=True)
    return used, numbers.reshape(-1, 3)


def _volume(places: NDArray[np.float64], triangles: NDArray[np.int64]) -> float:
    """Six times the volume inside the finite triangles, below zero where they face inwards."""
    corners = places[triangles]
    corners = corners[np.isfinite(corners).all(axis=(1, 2))]
    if not len(corners):
        return 0.0
    corners = corners - corners[0, 0]
    return float(np.einsum("ti,ti->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])))


def _open_ring(name: str, points: ArrayLike) -> NDArray[np.float64]:
    """The points of an outline, without the first one again at its end."""
    given = check_numeric(name, points)
    width = 3 if given.ndim == 2 and given.shape[1] == 3 else 2
    ring = check_finite(name, check_rows(name, points, width, dtype=np.float64))
    if len(ring) > 1 and (ring[0] == ring[-1]).all():
        ring = ring[:-1]
    if len(ring) < 3:
        raise ValueError(f"{name}: expected three corners or more, got {len(ring)}")
    return ring


def _flattened(places: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    """Places [n, 2] or [n, 3] in the plane of the first `count`."""
    if places.shape[1] == 2:
        return places - places[0]
    local = places - places[0]
    ring = local[:count]
    normal = np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    size, length = norm(normal), np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1).sum()
    if not size > 1e-12 * length**2:
        raise ValueError("outline: its corners lie on a line, or it crosses itself")
    normal /= size
    off = np.abs(matmul(local, normal)).max()
    if off > 1e-6 * length:
        raise ValueError(f"outline, holes: corners lie up to {off:g} m off their plane")
    u = np.cross(np.eye(3)[np.abs(normal).argmin()], normal)
    u /= norm(u)
    return matmul(local, np.array([u, np.cross(normal, u)]).T)


def _check_area(flat: NDArray[np.float64], order: list[Any], triangles: NDArray[np.int64]) -> None:
    """Refuse triangles that overlap."""
    a, b, c = flat[triangles].transpose(1, 0, 2)
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    whole = sum(signed_area(flat[rows]) for rows in order)
    scale = sum(abs(signed_area(flat[rows])) for rows in order)
    if not abs(np.abs(doubled).sum() / 2 - whole) <= SAME_AREA * scale or not whole > 0:
        raise ValueError("outline, holes: they cross themselves or each other")
