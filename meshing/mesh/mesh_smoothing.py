"""Meshes smoothed and sharpened: positions, normals and colours moved towards or away from those of neighbours."""

from __future__ import annotations

from typing import Any, Self

from ...core.checks import check_count, check_number, shown
from ...core.dropped_results import returns_new
from ...kernels.remeshing.mesh_filters import approach_mean_kernel, average_kernel, filter_values, sharpen_kernel
from ...kernels.remeshing.vertex_values import narrow_directions, narrow_rows, widen_rows
from .mesh_arrays import MeshArrays
from .mesh_rows import PER_VERTEX
from .mesh_seams import sew

MOST_PASSES = 10_000
SCOPES = {"all": tuple(PER_VERTEX), "vertex": ("vertices",), "normal": ("vertex_normals",), "color": ("vertex_colors",)}


class MeshSmoothing(MeshArrays):
    """The part of TriangleMesh that smooths it."""

    @returns_new
    def filter_smooth_simple(self, number_of_iterations: int = 1, filter_scope: Any = "all") -> Self:
        """Move each vertex to the mean of itself and its neighbours.

        Args:
            number_of_iterations: Passes.
            filter_scope: What is smoothed: "all", "vertex", "normal" or "color", or a member of Open3D's FilterScope.

        Returns:
            The mesh with what was smoothed in place of what it was, and all else as it was. Normals are of unit length
            (Open3D leaves them shorter). A vertex that is not finite stays and counts for no neighbour. Vertices at one
            place of a seam, where borders lie on each other as texture leaves them, count as one: they move together
            (in Open3D the surface tears there) and get the mean of their normals and colours.

        Raises:
            ValueError: Iterations outside 0..10,000; an unknown scope, or one that the mesh has nothing of.
            TypeError: No whole number.

        Notes:
            O(m + t) memory. Sums run in float64 over ascending neighbours, and positions are rounded once, at the end:
            the same bits from run to run. With the scopes Normal and Color Open3D's vertices hold what was in memory.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_smooth_simple().vertices[0].tolist()
            [1.0, 1.0, 1.0]
        """
        return self._filtered([(average_kernel, 0.0)], number_of_iterations, filter_scope)

    @returns_new
    def filter_smooth_laplacian(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, filter_scope: Any = "all"
    ) -> Self:
        """Move each vertex towards the mean of its neighbours, weighted by one over their distances.

        Smooths everything and shrinks what is curved or open; see `filter_smooth_taubin`.

        Args:
            number_of_iterations: Passes.
            lambda_filter: Share of the way a pass.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. A vertex without neighbours stays, where Open3D makes it NaN.

        Raises:
            ValueError: As `filter_smooth_simple`; a factor that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_simple`. Distances are those of the positions before the pass. Taubin, "A signal
            processing approach to fair surface design", SIGGRAPH 1995, equation 2.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
            >>> roof.filter_smooth_laplacian(1, lambda_filter=1.0).vertices[0].tolist()
            [1.5, 1.5, 0.0]
        """
        factor = check_number("lambda_filter", lambda_filter)
        return self._filtered([(approach_mean_kernel, factor)], number_of_iterations, filter_scope)

    @returns_new
    def filter_smooth_taubin(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, mu: float = -0.53, filter_scope: Any = "all"
    ) -> Self:
        """Smooth without shrinking: each iteration is a pass with `lambda_filter` and one back with `mu`.

        Args:
            number_of_iterations: Pairs of passes.
            lambda_filter: Share of the way to the weighted mean of the neighbours, > 0.
            mu: The same of the second pass; below -lambda_filter, which lets low frequencies through.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_laplacian`.

        Raises:
            ValueError: As `filter_smooth_simple`; a factor that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_laplacian`, with twice the passes. Taubin 1995, section 3.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
            >>> roof.filter_smooth_taubin(5)
            TriangleMesh(3 vertices, 1 triangles, cpu)
        """
        factors = (check_number("lambda_filter", lambda_filter), check_number("mu", mu))
        return self._filtered([(approach_mean_kernel, f) for f in factors], number_of_iterations, filter_scope)

    @returns_new
    def filter_sharpen(self, number_of_iterations: int = 1, strength: float = 1, filter_scope: Any = "all") -> Self:
        """Move each vertex away from its neighbours, which makes edges and noise stand out.

        Args:
            number_of_iterations: Passes.
            strength: How far: in sums of the differences between a vertex and its neighbours.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. Colours are not cut to 0..1, as in Open3D.

        Raises:
            ValueError: As `filter_smooth_simple`; a strength that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_simple`.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_sharpen(strength=0.5).vertices[0].tolist()
            [-1.5, -1.5, -1.5]
        """
        factor = check_number("strength", strength)
        return self._filtered([(sharpen_kernel, factor)], number_of_iterations, filter_scope)

    def _filtered(self, passes: list[tuple[Any, float]], iterations: int, scope: Any) -> Self:
        reason = "by then hardly anything is left but the mean of all vertices; take fewer"
        count = check_count("number_of_iterations", iterations, minimum=0, maximum=MOST_PASSES, because=reason)
        names = [name for name in _names_of(scope) if name in self._arrays]
        if not names:
            raise ValueError(f"filter_scope: the mesh has no {_names_of(scope)[0]} to filter")
        if count == 0 or not len(self):
            return self._with_arrays()
        sewn = sew(self)
        arrays = sewn.mesh._device_arrays
        wide = {name: widen_rows(arrays[name]) for name in {"vertices", *names}}
        values = filter_values(arrays["triangles"], wide["vertices"], names, wide, passes * count)
        narrow: dict[str, Any] = {}
        for name, rows in values.items():
            if name == "vertex_normals":
                narrow[name] = sewn.spread(narrow_directions(rows, arrays[name]))
            else:
                narrow[name] = sewn.spread(narrow_rows(rows))
        return self._with_arrays(**narrow)


def _names_of(scope: Any) -> tuple[str, ...]:
    """The arrays of a scope: one of ours by name, or a member of Open3D's enum."""
    name = scope if isinstance(scope, str) else getattr(scope, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(scope)}")
    if name.lower() not in SCOPES:
        raise ValueError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(name)}")
    return SCOPES[name.lower()]
