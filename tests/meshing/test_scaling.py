"""Results scale with the data: operations at powers of two, which scale float32 exactly, equal those at one.

Each line has the power of the length that a result is, its tolerance (0: bitwise), and the operation.
"""

from functools import cache

import numpy as np
import pytest

import pointloom as loom

from .shape_scenes import icosphere
from .simplification_scenes import bumpy_torus
from .test_mesh_smoothing import bumpy_ball, pulled
from .test_mesh_voxels import soup

CASES = """
1 0 ball.subdivide_midpoint(2).vertices
1 0 ball.subdivide_loop(2).vertices
1 3e-7 ball.filter_smooth_simple(2).vertices
1 0.3 wide.filter_smooth_laplacian(2, 0.7).vertices
1 0.3 wide.filter_smooth_taubin(2, 0.4, -0.45).vertices
1 3e-7 ball.filter_sharpen(2, 0.1).vertices
-1 0 ball.compute_vertex_curvature().mean
-2 0 ball.compute_vertex_curvature().gaussian
1 0 ball.compute_geodesic_distances([3])
0 0 ball.compute_vertex_normals().vertex_normals
1 2e-7 bumpy.deform_as_rigid_as_possible(*handles, 5).vertices
0 0 torus.simplify_quadric_decimation(300).triangles
1 0 torus.simplify_quadric_decimation(300).vertices
0 0 torus.simplify_vertex_clustering(0.25 * s).triangles
1 0 torus.simplify_vertex_clustering(0.25 * s).vertices
1 0 torus.simplify_vertex_clustering(0.25 * s, "Quadric").vertices
0 0 torus.compute_uvatlas(128).triangle_uvs
0 0 loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 0.3 * s).triangles
0 0 soup.voxelize(0.1 * s).coordinates
1 1e-6 soup.sample_points_uniformly(300).points
0 0 cloud.estimate_normals(max_nn=10).normals
0 0 loom.compute_eigen_features(cloud, max_nn=12)["planarity"]
0 0 loom.compute_fpfh_feature(cloud, radius=0.2 * s)
"""


@cache
def result_at(scale, operation, device):
    meshes = {"ball": loom.TriangleMesh(*icosphere(1)), "torus": loom.TriangleMesh(*bumpy_torus())}
    wide = loom.TriangleMesh(2.0**20 * icosphere(1)[0], icosphere(1)[1])  # the weights are precise to 1e-12 m
    meshes |= {"wide": wide, "bumpy": bumpy_ball(None, 1), "soup": soup(3)}
    handles, targets = pulled(meshes["bumpy"])
    names = {
        name: loom.TriangleMesh(mesh.vertices * scale, mesh.triangles, origin=[0, 0, 0], device=device)
        for name, mesh in meshes.items()
    }
    points = meshes["torus"].vertices
    names["cloud"] = loom.PointCloud(points * scale, normals=points, origin=[0, 0, 0], device=device)
    return eval(operation, {**names, "loom": loom, "s": scale, "handles": (handles, targets * scale)})


@pytest.mark.parametrize("scale", [2.0**-40, 2.0**40])
@pytest.mark.parametrize("case", CASES.strip().splitlines())
def test_results_scale_with_the_data(device, case, scale):
    power, tolerance, operation = case.split(" ", 2)
    actual, expected = (result_at(s, operation, device) / s ** int(power) for s in (scale, 1.0))
    np.testing.assert_allclose(actual, expected, rtol=0, atol=float(tolerance))
