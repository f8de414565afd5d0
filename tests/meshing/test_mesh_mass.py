"""Centers of mass and inertia tensors of closed meshes, compared with closed forms and sums in exact fractions."""

from fractions import Fraction

import numpy as np
import pytest

import pointloom as loom

from .test_mesh import TETRAHEDRON

UTM = np.array([456_000.0, 5_400_000.0, 300.0])
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


def exact_mass(mesh):
    """Center and inertia tensor by tetrahedra from the coordinate origin, in fractions of the stored vertices."""
    origin = np.asarray(mesh.arrays.origin, float)
    corners = np.asarray(mesh.vertices, np.float64) - origin
    first, second, volume = [Fraction(0)] * 3, [[Fraction(0)] * 3 for _ in range(3)], Fraction(0)
    for triangle in np.asarray(mesh.triangles).tolist():
        a, b, c = ([Fraction(float(x)) for x in corners[k]] for k in triangle)
        total = [x + y + z for x, y, z in zip(a, b, c, strict=True)]
        cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]]
        six = sum(x * y for x, y in zip(a, cross, strict=True))
        volume += six / 6
        for i in range(3):
            first[i] += six * total[i] / 24
            for j in range(3):
                second[i][j] += six * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + total[i] * total[j]) / 120
    center = [x / volume for x in first]
    central = [[second[i][j] - volume * center[i] * center[j] for j in range(3)] for i in range(3)]
    trace = central[0][0] + central[1][1] + central[2][2]
    sign = 1 if volume > 0 else -1
    inertia = [[float(sign * ((trace if i == j else 0) - central[i][j])) for j in range(3)] for i in range(3)]
    return np.array([float(x) for x in center]) + origin, np.array(inertia)


SHAPES = {
    "box": lambda device: loom.TriangleMesh.create_box(4, 2, 1, device=device),
    "tetrahedron": lambda device: loom.TriangleMesh(*TETRAHEDRON, device=device),
    "torus": lambda device: loom.TriangleMesh.create_torus(2, 1, 12, 8, device=device),
}


@pytest.mark.parametrize("moved", [False, True], ids=["at the origin", "rotated, at UTM"])
@pytest.mark.parametrize("shape", SHAPES)
def test_mass_properties_are_those_of_exact_sums(device, shape, moved):
    mesh = SHAPES[shape](device)
    if moved:
        mesh = mesh.rotate(ROTATION).translate(UTM)
    center, inertia = exact_mass(mesh)
    np.testing.assert_allclose(mesh.center_of_mass, center, rtol=1e-15, atol=1e-14)
    np.testing.assert_allclose(mesh.moment_of_inertia, inertia, atol=1e-13 * np.abs(inertia).max())
    assert mesh.center_of_mass.dtype == mesh.moment_of_inertia.dtype == np.float64
    inward = loom.TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1], device=device, origin=mesh.arrays.origin)
    np.testing.assert_allclose(inward.center_of_mass, mesh.center_of_mass, rtol=1e-15, atol=1e-14)
    np.testing.assert_allclose(inward.moment_of_inertia, mesh.moment_of_inertia, atol=1e-13 * np.abs(inertia).max())


def test_a_box_has_the_inertia_of_the_textbook(device):
    box = loom.TriangleMesh.create_box(4, 2, 1, device=device)
    np.testing.assert_allclose(box.moment_of_inertia, np.diag([8 / 12 * 5, 8 / 12 * 17, 8 / 12 * 20]), atol=1e-14)
    np.testing.assert_array_equal(box.center_of_mass, [2, 1, 0.5])
    doubled = box.scale(2, center=[0, 0, 0])
    np.testing.assert_allclose(doubled.moment_of_inertia, 2**5 * box.moment_of_inertia, atol=1e-12)
    np.testing.assert_array_equal(doubled.center_of_mass, [4, 2, 1])
    rotated = box.rotate(ROTATION, center=[0, 0, 0])
    np.testing.assert_allclose(rotated.moment_of_inertia, ROTATION @ box.moment_of_inertia @ ROTATION.T, atol=1e-5)


def test_a_cavity_is_subtracted(device):
    box, small = loom.TriangleMesh.create_box(4, 4, 4), loom.TriangleMesh.create_box(1, 1, 1).translate([2, 1, 1])
    hollow = box + loom.TriangleMesh(small.vertices, small.triangles[:, ::-1])
    hollow = loom.TriangleMesh(hollow.vertices, hollow.triangles, device=device)
    expected = (64 * np.array([2.0, 2, 2]) - [2.5, 1.5, 1.5]) / 63
    np.testing.assert_allclose(hollow.center_of_mass, expected, rtol=1e-14)
    np.testing.assert_allclose(hollow.moment_of_inertia, exact_mass(hollow)[1], atol=1e-12)


@pytest.mark.parametrize("shape", SHAPES)
def test_mass_properties_agree_with_trimesh(shape):
    trimesh = pytest.importorskip("trimesh")
    mesh = SHAPES[shape]("cpu")
    peer = trimesh.Trimesh(np.asarray(mesh.vertices), np.asarray(mesh.triangles), process=False)
    np.testing.assert_allclose(mesh.center_of_mass, peer.center_mass, atol=1e-13)
    np.testing.assert_allclose(mesh.moment_of_inertia, peer.moment_inertia, atol=1e-11)
