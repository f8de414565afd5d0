"""Clouds and search parameters as Open3D objects, for functions that compute its results (tests/oracle.py)."""

import numpy as np


def cloud_of(o3d, points, normals=None, colors=None):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points, np.float64)))
    for name, values in (("normals", normals), ("colors", colors)):
        if values is not None:
            setattr(cloud, name, o3d.utility.Vector3dVector(np.array(values, np.float64)))
    return cloud


def search_of(o3d, radius=None, max_nn=None):
    if radius is None:
        return o3d.geometry.KDTreeSearchParamKNN(max_nn)
    if max_nn is None:
        return o3d.geometry.KDTreeSearchParamRadius(radius)
    return o3d.geometry.KDTreeSearchParamHybrid(radius, max_nn)


def covariances_of(o3d, points, search):
    cloud = cloud_of(o3d, points)
    cloud.estimate_covariances(search_of(o3d, **search))
    return np.asarray(cloud.covariances)


def normals_of(o3d, points, search):
    cloud = cloud_of(o3d, points)
    cloud.estimate_normals(search_of(o3d, **search))
    return np.asarray(cloud.normals)


def features_of(o3d, points, normals, radius=None, max_nn=None):
    search = search_of(o3d, radius, max_nn)
    compute = o3d.pipelines.registration.compute_fpfh_feature
    return compute(cloud_of(o3d, points, normals), search).data.T.astype(np.float32)
