import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("./street.pcd")
results = {"points": np.asarray(pcd.points), "said": str(pcd)}
o3d.visualization.draw_geometries([pcd])
