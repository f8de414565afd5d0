"""Stations of a file go from the reader to the registration and to the writer."""

import numpy as np

import pointloom as loom


def test_stations_of_a_file_are_registered_with_their_names_and_poses(tmp_path, rng):
    x, y = rng.uniform(-4, 4, (2, 9000))
    ground = np.column_stack([x, y, 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)])
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, :3, 3] = [[0, 0, 1.5], [1.0, 0.5, 1.6], [0.5, -1.0, 1.4]]
    clouds = [loom.PointCloud(ground[k::3] - poses[k, :3, 3]) for k in range(3)]
    loom.write_stations(tmp_path / "a.e57", clouds, poses, names=["A", "B", "C"], crs=25832)
    stations = loom.read_stations(tmp_path / "a.e57")
    found = loom.registration.register_stations(stations, voxel_size=0.2)
    given = loom.registration.register_stations(
        stations.clouds, poses=stations.poses, names=stations.names, voxel_size=0.2
    )
    assert found.names == ("A", "B", "C")
    np.testing.assert_array_equal(found.poses, given.poses)
    loom.write_stations(tmp_path / "b.e57", stations, found.poses)
    written = loom.read_stations(tmp_path / "b.e57")
    assert written.names == found.names and written.crs == 25832
    np.testing.assert_allclose(written.poses, found.poses, atol=1e-9)
    renamed = loom.registration.register_stations(stations, names=["D", "E", "F"], voxel_size=0.2)
    assert renamed.names == ("D", "E", "F")
