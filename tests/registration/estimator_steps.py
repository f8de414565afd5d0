"""What the tests of estimators share: clouds as Open3D's, and when two results are the same."""

import numpy as np

import pointloom as loom

reg = loom.registration

DISTANCE = 0.15


def tensor_cloud(cloud, **attributes):
    import open3d as o3d

    made = o3d.t.geometry.PointCloud(o3d.core.Tensor(cloud.points))
    if cloud.has_normals:
        made.point.normals = o3d.core.Tensor(cloud.normals.astype(np.float64))
    for name, values in attributes.items():
        made.point[name] = o3d.core.Tensor(np.ascontiguousarray(values, np.float64))
    return made


def on(device, cloud):
    return cloud.to(device)


def ours_after(device, pair, method, steps, init=None, **options):
    """Our result after so many steps: criteria of zero are never met."""
    source, target, rules = on(device, pair.source), on(device, pair.target), reg.ICPConvergenceCriteria(0, 0, steps)
    return reg.registration_icp(source, target, DISTANCE, init, method, rules, **options)


def tensor_after(tensor, method, steps, init=None):
    import open3d as o3d

    theirs = o3d.t.pipelines.registration
    init = o3d.core.Tensor(np.eye(4) if init is None else init)
    result = theirs.icp(*tensor, DISTANCE, init, method, theirs.ICPConvergenceCriteria(0, 0, steps))
    return result.transformation.numpy()


def tensor_kernel(name, scale, shape=1.0):
    from open3d.t.pipelines.registration import robust_kernel

    return robust_kernel.RobustKernel(getattr(robust_kernel.RobustKernelMethod, name), scale, shape)
