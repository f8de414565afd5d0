import numpy as np
import open3d as o3d

im = o3d.io.read_image("color/0.jpg")
results = {"said": str(im)}
smooth = im.filter(o3d.geometry.ImageFilterType.Gaussian3)
results["smooth"] = np.asarray(smooth)
pyramid = im.create_pyramid(3, True)
results["levels"] = [np.asarray(level).shape for level in pyramid]
results["coarsest"] = np.asarray(pyramid[2])
kinds = o3d.geometry.ImageFilterType
for name, kind in (("dx", kinds.Sobel3dx), ("dy", kinds.Sobel3dy), ("seven", kinds.Gaussian7)):
    results[name] = np.asarray(o3d.geometry.Image.filter_pyramid(pyramid, kind)[1])
results["flipped"] = np.asarray(im.flip_vertical())
np.asarray(im)[:10] = 0
results["written through"] = np.asarray(im)[:20]
depth = o3d.io.read_image("depth/0.png")
camera = o3d.camera.PinholeCameraIntrinsic(640, 480, 525, 525, 319.5, 239.5)
cloud = o3d.geometry.PointCloud.create_from_depth_image(depth, camera, stride=4, depth_trunc=3.0)
results["cloud"] = np.asarray(cloud.points)
floats = o3d.geometry.Image(np.asarray(depth).astype(np.float32))
results["floats"] = np.asarray(o3d.geometry.PointCloud.create_from_depth_image(floats, camera, stride=8).points)
rgbd = o3d.geometry.RGBDImage()
rgbd.color, rgbd.depth = im, o3d.geometry.Image(np.asarray(depth).astype(np.float32) / 1000)
results["assembled"] = len(o3d.geometry.PointCloud.create_from_rgbd_image(rgbd, camera).points)
visual = o3d.geometry.LineSet.create_camera_visualization(640, 480, camera.intrinsic_matrix, np.eye(4), 0.5)
results["camera"] = np.asarray(visual.points)
