"""Open3D's documentation, "Multiway registration", on three frames of a synthetic room."""

import numpy as np
import open3d as o3d

voxel_size = 0.047  # not a multiple of 2 mm, the step of depth values: no point is on a voxel face
reg = o3d.pipelines.registration
to_the_end = reg.ICPConvergenceCriteria(1e-12, 1e-12, 300)
camera = o3d.io.read_pinhole_camera_intrinsic("camera.json")


def load_point_clouds(voxel_size=0.0):
    pcds = []
    for i in range(3):
        color = o3d.io.read_image(f"color/{i}.jpg")
        depth = o3d.io.read_image(f"depth/{i}.png")
        rgbd = o3d.geometry.RGBDImage.create_from_color_and_depth(color, depth, depth_trunc=5.0)
        pcd = o3d.geometry.PointCloud.create_from_rgbd_image(rgbd, camera)
        pcd_down = pcd.voxel_down_sample(voxel_size=voxel_size)
        pcd_down.estimate_normals()
        pcds.append(pcd_down)
    return pcds


pcds_down = load_point_clouds(voxel_size)
o3d.visualization.draw_geometries(pcds_down)


def pairwise_registration(source, target):
    coarse, fine = max_correspondence_distance_coarse, max_correspondence_distance_fine
    method = reg.TransformationEstimationPointToPlane()
    icp_coarse = reg.registration_icp(source, target, coarse, np.identity(4), method, to_the_end)
    icp_fine = reg.registration_icp(source, target, fine, icp_coarse.transformation, method, to_the_end)
    information_icp = reg.get_information_matrix_from_point_clouds(source, target, fine, icp_fine.transformation)
    return icp_fine.transformation, information_icp


def full_registration(pcds, max_correspondence_distance_coarse, max_correspondence_distance_fine):
    pose_graph = reg.PoseGraph()
    odometry = np.identity(4)
    pose_graph.nodes.append(reg.PoseGraphNode(odometry))
    n_pcds = len(pcds)
    for source_id in range(n_pcds):
        for target_id in range(source_id + 1, n_pcds):
            transformation_icp, information_icp = pairwise_registration(pcds[source_id], pcds[target_id])
            is_odometry = target_id == source_id + 1  # else a loop closure
            if is_odometry:
                odometry = np.dot(transformation_icp, odometry)
                pose_graph.nodes.append(reg.PoseGraphNode(np.linalg.inv(odometry)))
            edge = (source_id, target_id, transformation_icp, information_icp)
            pose_graph.edges.append(reg.PoseGraphEdge(*edge, uncertain=not is_odometry))
    return pose_graph


max_correspondence_distance_coarse = voxel_size * 15
max_correspondence_distance_fine = voxel_size * 1.5
pose_graph = full_registration(pcds_down, max_correspondence_distance_coarse, max_correspondence_distance_fine)
before = [np.array(node.pose) for node in pose_graph.nodes]
results = {"graph": str(pose_graph), "edges": [edge.transformation for edge in pose_graph.edges]}

option = reg.GlobalOptimizationOption(
    max_correspondence_distance=max_correspondence_distance_fine, edge_prune_threshold=0.25, reference_node=0
)
method, criteria = reg.GlobalOptimizationLevenbergMarquardt(), reg.GlobalOptimizationConvergenceCriteria()
reg.global_optimization(pose_graph, method, criteria, option)

for point_id in range(len(pcds_down)):
    print(pose_graph.nodes[point_id].pose)
    pcds_down[point_id].transform(pose_graph.nodes[point_id].pose)
o3d.visualization.draw_geometries(pcds_down)

pcds = load_point_clouds(voxel_size)
pcd_combined = o3d.geometry.PointCloud()
for point_id in range(len(pcds)):
    pcds[point_id].transform(pose_graph.nodes[point_id].pose)
    pcd_combined += pcds[point_id]
pcd_combined_down = pcd_combined.voxel_down_sample(voxel_size=voxel_size)
o3d.io.write_point_cloud("multiway_registration.pcd", pcd_combined_down)
o3d.io.write_pose_graph("multiway_registration.json", pose_graph)
again = o3d.io.read_pose_graph("multiway_registration.json")
o3d.visualization.draw_geometries([pcd_combined_down])

results |= {
    "poses": [node.pose for node in pose_graph.nodes],
    "moved by": np.abs(np.array(before) - [node.pose for node in pose_graph.nodes]).max(),
    "confidence": [edge.confidence for edge in pose_graph.edges],
    "again": [node.pose for node in again.nodes],
    "points": len(pcd_combined.points),
    "middle": pcd_combined.get_center(),
}
