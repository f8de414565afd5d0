"""Open3D's documentation, "RGBD integration", on three frames of a synthetic room."""

from pathlib import Path

import numpy as np
import open3d as o3d


class CameraPose:
    def __init__(self, meta, mat):
        self.metadata = meta
        self.pose = mat

    def __str__(self):
        return "Metadata : " + " ".join(map(str, self.metadata)) + "\n" + "Pose : " + "\n" + np.array_str(self.pose)


def read_trajectory(filename):
    traj = []
    with Path(filename).open() as f:
        metastr = f.readline()
        while metastr:
            metadata = list(map(int, metastr.split()))
            mat = np.zeros(shape=(4, 4))
            for i in range(4):
                matstr = f.readline()
                mat[i, :] = np.fromstring(matstr, dtype=float, sep=" \t")
            traj.append(CameraPose(metadata, mat))
            metastr = f.readline()
    return traj


camera_poses = read_trajectory("trajectory.log")
intrinsic = o3d.io.read_pinhole_camera_intrinsic("camera.json")
rgb8 = o3d.pipelines.integration.TSDFVolumeColorType.RGB8
volume = o3d.pipelines.integration.ScalableTSDFVolume(voxel_length=0.05, sdf_trunc=0.15, color_type=rgb8)
cube = o3d.pipelines.integration.UniformTSDFVolume(
    length=6.4, resolution=128, sdf_trunc=0.15, color_type=rgb8, origin=np.array([-3.2, -3.2, 0.0])
)
for i in range(len(camera_poses)):
    print(f"Integrate {i:d}-th image into the volume.")
    color = o3d.io.read_image(f"color/{i}.jpg")
    depth = o3d.io.read_image(f"depth/{i}.png")
    rgbd = o3d.geometry.RGBDImage.create_from_color_and_depth(
        color, depth, depth_trunc=4.0, convert_rgb_to_intensity=False
    )
    volume.integrate(rgbd, intrinsic, np.linalg.inv(camera_poses[i].pose))
    cube.integrate(rgbd, intrinsic, np.linalg.inv(camera_poses[i].pose))

print("Extract a triangle mesh from the volume and visualize it.")
mesh = cube.extract_triangle_mesh()
mesh.compute_vertex_normals()
o3d.visualization.draw_geometries([mesh])
cloud = cube.extract_point_cloud()

results = {
    "volume": f"{volume} {volume.voxel_length} {volume.sdf_trunc} {volume.color_type}",
    "cube": f"{cube} {cube.voxel_length} {cube.length} {cube.resolution}",
    "has colors": mesh.has_vertex_colors(),
    "has normals": cloud.has_normals() and mesh.has_vertex_normals(),
    "mean color": np.asarray(mesh.vertex_colors).mean(axis=0),
    "area": mesh.get_surface_area(),
    "surface": (np.asarray(mesh.vertices), np.asarray(mesh.triangles)),
    "cloud": np.asarray(cloud.points),
    "scalable": np.asarray(volume.extract_triangle_mesh().vertices),
}
