"""Results of estimators after some steps, for pointloom and Open3D."""

import numpy as np

import pointloom as loom

reg = loom.registration

DISTANCE = 0.15


def result_after(device, pair, method, steps, init=None, **options):
    """The result after a given number of steps: criteria of zero are never met."""
    source, target, rules = pair.source.to(device), pair.target.to(device), reg.ICPConvergenceCriteria(0, 0, steps)
    return reg.registration_icp(source, target, DISTANCE, init, method, rules, **options)


def legacy_cloud(o3d, cloud):
    """A legacy cloud of Open3D with the normals and colors of a cloud."""
    made = o3d.geometry.PointCloud()
    made.points = o3d.utility.Vector3dVector(np.array(cloud.points, np.float64))
    made.normals = o3d.utility.Vector3dVector(np.array(cloud.normals, np.float64))
    if cloud.has_colors:
        made.colors = o3d.utility.Vector3dVector(np.array(cloud.colors, np.float64))
    return made


def tensor_cloud(o3d, cloud, **attributes):
    made = o3d.t.geometry.PointCloud(o3d.core.Tensor(cloud.points))
    if cloud.has_normals:
        made.point.normals = o3d.core.Tensor(cloud.normals.astype(np.float64))
    for name, values in attributes.items():
        made.point[name] = o3d.core.Tensor(np.ascontiguousarray(values, np.float64))
    return made


def tensor_after(o3d, clouds, method, steps):
    """The pose of Open3D's tensor implementation after a given number of steps."""
    theirs = o3d.t.pipelines.registration
    rules = theirs.ICPConvergenceCriteria(0, 0, steps)
    return theirs.icp(*clouds, DISTANCE, o3d.core.Tensor(np.eye(4)), method, rules).transformation.numpy()


def tensor_kernel(o3d, name, scale, shape=1.0):
    kernels = o3d.t.pipelines.registration.robust_kernel
    return kernels.RobustKernel(getattr(kernels.RobustKernelMethod, name), scale, shape)
