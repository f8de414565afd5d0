import numpy as np
import open3d as o3d

prime_sense = o3d.camera.PinholeCameraIntrinsicParameters.PrimeSenseDefault
intrinsic = o3d.camera.PinholeCameraIntrinsic(prime_sense)
results = {"matrix": intrinsic.intrinsic_matrix, "empty": str(o3d.camera.PinholeCameraIntrinsic())}
x = o3d.camera.PinholeCameraIntrinsic(640, 480, 525, 525, 320, 240)
results["said"] = str(x)
o3d.io.write_pinhole_camera_intrinsic("test.json", x)
y = o3d.io.read_pinhole_camera_intrinsic("test.json")
results["read"] = np.asarray(y.intrinsic_matrix)
pcds = []
trajectory = o3d.io.read_pinhole_camera_trajectory("trajectory.log")
o3d.io.write_pinhole_camera_trajectory("traj.json", trajectory)
results["extrinsic"] = np.asarray(trajectory.parameters[0].extrinsic)
again = o3d.io.read_pinhole_camera_trajectory("traj.json")
results["again"] = [one.extrinsic for one in again.parameters]
results["cameras"] = [one.intrinsic.get_focal_length() for one in again.parameters]
for i in range(3):
    im1 = o3d.io.read_image("depth/" + str(i) + ".png")
    im2 = o3d.io.read_image("color/" + str(i) + ".jpg")
    im = o3d.geometry.RGBDImage.create_from_color_and_depth(im2, im1, 1000.0, 10.0, False)
    camera = trajectory.parameters[i]
    pcd = o3d.geometry.PointCloud.create_from_rgbd_image(im, camera.intrinsic, camera.extrinsic)
    pcds.append(pcd.voxel_down_sample(voxel_size=0.2))
results["voxels"] = [len(p.points) for p in pcds]
results["means"] = [np.asarray(p.points).mean(0) for p in pcds]
o3d.visualization.draw_geometries(pcds)
