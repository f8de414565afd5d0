"""pointloom's surface of the castle of Sceaux beside OpenMVS's from the same eleven photographs.

    pointloom video $POINTLOOM_DATA/mvs-sceaux/images -o castle.ply --work castle --max-size 800
    POINTLOOM_DATA=<folder> python benchmarks/mvs_beside_openmvs.py castle.ply castle

There is no ground truth: both estimate the cameras. Prints the differences of the cameras after the best
similarity, and
the distances of the vertices of each mesh from the other, all in percent of the median depth of the sparse points. The
scene and the mesh of OpenMVS are from that program's sample.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from openmvs_scene import Scene, read_openmvs_scene
from real_data import real_data

import pointloom as loom
from pointloom.registration.trajectories.similarity import fit_to_positions

FRACTIONS = (0.5, 0.9)


def median_depth(scene: Scene) -> float:
    """Median depth of the sparse points in the cameras."""
    T = scene.T_camera_world
    z = np.einsum("ni,ki->nk", T[:, 2, :3], scene.points) + T[:, 2, 3:]
    return float(np.median(z[z > 0]))


def distances(mesh: loom.TriangleMesh, other: loom.TriangleMesh) -> np.ndarray:
    """Distances from the vertices of a mesh to another mesh."""
    scene = loom.RaycastingScene()
    scene.add_triangles(other)
    return scene.compute_distance(mesh.vertices.astype(np.float32))


def main() -> None:
    """Print the comparison."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", type=Path, help="mesh of pointloom video")
    parser.add_argument("work", type=Path, help="its --work folder")
    given = parser.parse_args()
    scene = read_openmvs_scene(real_data("mvs-openmvs-sample/scene.mvs"))
    openmvs_mesh = loom.read_triangle_mesh(real_data("mvs-openmvs-sample/scene_mesh.ply"))
    model = loom.read_cameras(given.work / "mesh" / "sparse")
    # OpenMVS's sample numbers the photographs in their order.
    taken = sorted(path.stem for path in real_data("mvs-sceaux/images").glob("*.JPG"))
    positions = {name: scene.centers[taken.index(Path(name).stem)] for name in model.names}
    fit = fit_to_positions(model, positions)
    mesh = loom.read_triangle_mesh(given.mesh).transform(fit.transformation)
    unit = 100 / median_depth(scene)
    print(f"{len(model)} of {len(scene.names)} images; cameras differ by {fit.rmse * unit:.3f} % (RMS)")
    print(f"{len(mesh.triangles):,} triangles of pointloom, {len(openmvs_mesh.triangles):,} of OpenMVS")
    for name, d in (
        ("pointloom to OpenMVS", distances(mesh, openmvs_mesh)),
        ("OpenMVS to pointloom", distances(openmvs_mesh, mesh)),
    ):
        fractions = ", ".join(f"{100 * q:.0f} %: {np.quantile(d, q) * unit:.3f} %" for q in FRACTIONS)
        print(f"{name}: {fractions}; within 0.5 %: {100 * np.mean(d * unit < 0.5):.1f} %")


if __name__ == "__main__":
    main()
