"""Open3D's documentation, "RGBD integration", on three frames of a synthetic room."""

import numpy as np
import open3d as o3d

cameras = o3d.io.read_pinhole_camera_trajectory("trajectory.log").parameters
intrinsic = o3d.io.read_pinhole_camera_intrinsic("camera.json")
rgb8 = o3d.pipelines.integration.TSDFVolumeColorType.RGB8
volume = o3d.pipelines.integration.ScalableTSDFVolume(voxel_length=0.05, sdf_trunc=0.15, color_type=rgb8)
make = o3d.pipelines.integration.UniformTSDFVolume
cube = make(length=6.4, resolution=128, sdf_trunc=0.15, color_type=rgb8, origin=np.array([-3.2, -3.2, 0.0]))
for i in range(len(cameras)):
    color = o3d.io.read_image(f"color/{i}.jpg")
    depth = o3d.io.read_image(f"depth/{i}.png")
    make = o3d.geometry.RGBDImage.create_from_color_and_depth
    rgbd = make(color, depth, depth_trunc=4.0, convert_rgb_to_intensity=False)
    volume.integrate(rgbd, intrinsic, cameras[i].extrinsic)
    cube.integrate(rgbd, intrinsic, cameras[i].extrinsic)

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
