import numpy as np
import open3d as o3d

color_raw = o3d.io.read_image("./color/0.jpg")
depth_raw = o3d.io.read_image("./depth/0.png")
results = {"files": f"{color_raw} {depth_raw}", "raw": [np.asarray(color_raw).max(), np.asarray(depth_raw).max()]}
rgbd_image = o3d.geometry.RGBDImage.create_from_color_and_depth(
    color_raw, depth_raw, depth_scale=1000.0, depth_trunc=10, convert_rgb_to_intensity=False
)
results["said"] = str(rgbd_image)
results["largest"] = [np.max(np.asarray(rgbd_image.color)), np.max(np.asarray(rgbd_image.depth))]
prime_sense = o3d.camera.PinholeCameraIntrinsicParameters.PrimeSenseDefault
pcd = o3d.geometry.PointCloud.create_from_rgbd_image(rgbd_image, o3d.camera.PinholeCameraIntrinsic(prime_sense))
pcd.transform([[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]])
results["points"] = np.asarray(pcd.points)
results["colors"] = np.asarray(pcd.colors)
o3d.visualization.draw_geometries([pcd])

# Formats of other datasets, and 8-bit depth, which is an image of it.
for name in ("redwood", "tum", "sun", "nyu"):
    make = getattr(o3d.geometry.RGBDImage, f"create_from_{name}_format")
    depth_again = o3d.io.read_image("./depth/0.png")  # Open3D decodes sun and nyu in place
    results[name] = np.asarray(make(color_raw, depth_again).depth)
eight = o3d.geometry.Image((np.asarray(depth_raw) >> 5).astype(np.uint8))
gray = o3d.geometry.RGBDImage.create_from_color_and_depth(color_raw, eight, depth_scale=10, depth_trunc=10)
results["8 bits"] = np.asarray(gray.depth)
results["gray"] = np.asarray(gray.color)
