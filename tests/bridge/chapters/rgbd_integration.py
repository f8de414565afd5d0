"""Open3D's documentation, "RGBD integration", on three frames of a made room."""

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
    with open(filename, "r") as f:
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
volume = o3d.pipelines.integration.ScalableTSDFVolume(
    voxel_length=0.02, sdf_trunc=0.08, color_type=o3d.pipelines.integration.TSDFVolumeColorType.RGB8
)
for i in range(len(camera_poses)):
    print("Integrate {:d}-th image into the volume.".format(i))
    color = o3d.io.read_image("color/{}.jpg".format(i))
    depth = o3d.io.read_image("depth/{}.png".format(i))
    rgbd = o3d.geometry.RGBDImage.create_from_color_and_depth(
        color, depth, depth_trunc=4.0, convert_rgb_to_intensity=False
    )
    volume.integrate(rgbd, o3d.io.read_pinhole_camera_intrinsic("camera.json"), np.linalg.inv(camera_poses[i].pose))

print("Extract a triangle mesh from the volume and visualize it.")
mesh = volume.extract_triangle_mesh()
mesh.compute_vertex_normals()
o3d.visualization.draw_geometries([mesh])
cloud = volume.extract_point_cloud()

found = {
    "volume": f"{volume} {volume.voxel_length} {volume.sdf_trunc} {volume.color_type}",
    "lowest": mesh.get_min_bound(),
    "highest": mesh.get_max_bound(),
    "has colors": mesh.has_vertex_colors(),
    "has normals": cloud.has_normals(),
    "mean color": np.asarray(mesh.vertex_colors).mean(axis=0),
}
surface = {"mesh": np.asarray(mesh.vertices), "cloud": np.asarray(cloud.points)}
area = mesh.get_surface_area()
