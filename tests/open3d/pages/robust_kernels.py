"""Open3D's documentation, "Robust kernels", on two frames of a synthetic room with noise."""

import copy

import numpy as np
import open3d as o3d

source = o3d.io.read_point_cloud("0.pcd").uniform_down_sample(3)
target = o3d.io.read_point_cloud("1.pcd").uniform_down_sample(3)
target.estimate_normals()
trans_init = np.identity(4)
trans_init[:3, 3] = [0.03, -0.02, 0.02]
np.random.seed(0)


mu, sigma = 0, 0.1  # mean and standard deviation
source_noisy = copy.deepcopy(source)
points = np.asarray(source_noisy.points)
points += np.random.normal(mu, sigma, size=points.shape)
source_noisy.points = o3d.utility.Vector3dVector(points)
o3d.visualization.draw_geometries([source_noisy])

threshold = 1.0
results = {"untouched": np.asarray(source.points), "noisy": np.asarray(source_noisy.points)}
p2l = o3d.pipelines.registration.TransformationEstimationPointToPlane()
reg = o3d.pipelines.registration
losses = {"vanilla": None, "tukey": reg.TukeyLoss(k=sigma), "huber": reg.HuberLoss(k=sigma)}
losses |= {"cauchy": reg.CauchyLoss(k=sigma), "gm": reg.GMLoss(k=sigma), "l1": reg.L1Loss()}
for name, loss in losses.items():
    print(f"Robust point-to-plane ICP, threshold={threshold}:", loss)
    if loss is not None:
        p2l = o3d.pipelines.registration.TransformationEstimationPointToPlane(loss)
        results[f"{name} weight"] = loss.weight(0.07)
        results[f"{name} text"] = repr(loss)
    reg_p2l = o3d.pipelines.registration.registration_icp(source_noisy, target, threshold, trans_init, p2l)
    print(reg_p2l)
    results[f"{name} fitness"] = reg_p2l.fitness
    if name != "l1":  # residuals near 0 have weights up to 1e9: rounding decides the result, in Open3D from run to run
        results[name] = reg_p2l.transformation
