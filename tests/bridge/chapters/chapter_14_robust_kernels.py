import copy

import numpy as np
import open3d as o3d

trans_init = np.identity(4)
source = o3d.io.read_point_cloud("0.pcd")
target = o3d.io.read_point_cloud("1.pcd")
source_cp = copy.deepcopy(source)
np.random.seed(0)


def apply_noise(pcd, mu, sigma):
    noisy_pcd = copy.deepcopy(pcd)
    points = np.asarray(pcd.points)
    points += np.random.normal(mu, sigma, size=points.shape)
    noisy_pcd.points = o3d.utility.Vector3dVector(points)
    return noisy_pcd


mu, sigma = 0, 0.05
source_noisy = apply_noise(source, mu, sigma)
found = {"noisy": np.asarray(source_noisy.points), "written through": np.asarray(source.points)}
found["the copy stays"] = bool(np.abs(np.asarray(source_cp.points) - np.asarray(source.points)).max() > 0.1)
threshold = 0.5
loss = o3d.pipelines.registration.TukeyLoss(k=sigma)
p2l = o3d.pipelines.registration.TransformationEstimationPointToPlane(loss)
target.estimate_normals()
reg_p2l = o3d.pipelines.registration.registration_icp(source_noisy, target, threshold, trans_init, p2l)
found["robust"] = [reg_p2l.fitness, reg_p2l.inlier_rmse]
found["pose"] = reg_p2l.transformation


def inverse_normal(pcd):
    normals = np.asarray(pcd.normals)
    normals = -1 * normals
    pcd.normals = o3d.utility.Vector3dVector(normals)


source = o3d.io.read_point_cloud("0.pcd")
source.estimate_normals()
source.orient_normals_towards_camera_location()
before = np.asarray(source.normals).copy()
inverse_normal(source)
found["inverted"] = bool(np.abs(before + np.asarray(source.normals)).max() == 0)
inverse_normal(source)
with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error) as cm:
    mesh, densities = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(source, depth=5)
found["Poisson's area"] = mesh.get_surface_area()
o3d.visualization.draw_geometries([mesh])
radii = [0.1, 0.2, 0.4]
rec_mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(source, o3d.utility.DoubleVector(radii))
found["balls' area"] = rec_mesh.get_surface_area()
