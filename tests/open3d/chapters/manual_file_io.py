import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("fragment.ply")
results = {"cloud": str(pcd)}
for name in ("copy_of_fragment.pcd", "copy_of_fragment.ply", "copy_of_fragment.xyz"):
    results[f"{name} is written"] = bool(o3d.io.write_point_cloud(name, pcd))
    results[name] = np.asarray(o3d.io.read_point_cloud(name).points)
np.savetxt("six.txt", np.hstack([np.asarray(pcd.points)[:50], np.asarray(pcd.colors)[:50]]))
results["format"] = np.asarray(o3d.io.read_point_cloud("six.txt", format="xyzrgb").colors)
mesh = o3d.io.read_triangle_mesh("bunny.ply")
results["mesh"] = str(mesh)
o3d.io.write_triangle_mesh("copy_of_bunny.ply", mesh)
results["vertices"] = np.asarray(o3d.io.read_triangle_mesh("copy_of_bunny.ply").vertices)
img = o3d.io.read_image("color/0.jpg")
results["image"] = np.asarray(img)
o3d.io.write_image("copy_of_color.png", img)
results["image again"] = np.asarray(o3d.io.read_image("copy_of_color.png"))
o3d.io.write_image("copy_of_color.jpg", img)
results["JPEG"] = str(o3d.io.read_image("copy_of_color.jpg"))
parameters = o3d.camera.PinholeCameraParameters()
parameters.extrinsic = np.diag([1.0, -1, -1, 1])
parameters.intrinsic.set_intrinsics(640, 480, 500, 510, 320, 240)
o3d.io.write_pinhole_camera_parameters("camera.json", parameters)
again = o3d.io.read_pinhole_camera_parameters("camera.json")
results["camera"] = [*again.extrinsic.ravel(), *again.intrinsic.intrinsic_matrix.ravel(), again.intrinsic.width]
feature = o3d.pipelines.registration.Feature()
feature.data = np.arange(12.0).reshape(3, 4)
o3d.io.write_feature("feature.bin", feature)
results["feature"] = o3d.io.read_feature("feature.bin").data
