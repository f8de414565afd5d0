"""Open3D's documentation, "Customized visualization": windows with callbacks, on a cloud of a synthetic room."""

from pathlib import Path

import numpy as np
import open3d as o3d

results = {}


def opened(pcd, **size):
    vis = o3d.visualization.Visualizer()
    vis.create_window(**size)
    vis.add_geometry(pcd)
    return vis


def custom_draw_geometry_with_custom_fov(pcd, fov_step):
    vis = opened(pcd)
    ctr = vis.get_view_control()
    results[f"fov before {fov_step}"] = ctr.get_field_of_view()
    ctr.change_field_of_view(step=fov_step)
    results[f"fov after {fov_step}"] = ctr.get_field_of_view()
    vis.run()
    vis.destroy_window()


def custom_draw_geometry_with_rotation(pcd):
    frames = []

    def rotate_view(vis):
        ctr = vis.get_view_control()
        ctr.rotate(10.0, 0.0)
        frames.append(np.array(ctr.convert_to_pinhole_camera_parameters().extrinsic))
        return False

    o3d.visualization.draw_geometries_with_animation_callback([pcd], rotate_view)
    results["turned"] = frames[:30]


def custom_draw_geometry_load_option(pcd, render_option_path):
    vis = opened(pcd)
    vis.get_render_option().load_from_json(render_option_path)
    option = vis.get_render_option()
    results["option"] = [option.point_size, *option.background_color, option.show_coordinate_frame, option.line_width]
    vis.run()
    vis.destroy_window()


def custom_draw_geometry_with_camera_trajectory(pcd, camera_trajectory_path):
    trajectory = o3d.io.read_pinhole_camera_trajectory(camera_trajectory_path)
    state = {"index": -1}
    seen = []

    def move_forward(vis):
        ctr = vis.get_view_control()
        if state["index"] >= 0:
            depth = np.asarray(vis.capture_depth_float_buffer(False))
            image = np.asarray(vis.capture_screen_float_buffer(False))
            vis.capture_screen_image("captures/{:05d}.png".format(state["index"]), False)
            seen.append((depth, image))
        state["index"] = state["index"] + 1
        if state["index"] < len(trajectory.parameters):
            results[f"moved {state['index']}"] = bool(
                ctr.convert_from_pinhole_camera_parameters(trajectory.parameters[state["index"]], allow_arbitrary=True)
            )
        else:
            vis.register_animation_callback(None)
        return False

    vis = opened(pcd, width=320, height=240)
    vis.get_render_option().point_size = 1.0
    vis.register_animation_callback(move_forward)
    vis.run()
    vis.destroy_window()
    return seen


pcd = o3d.io.read_point_cloud("0.pcd")
Path("captures").mkdir(exist_ok=True)
custom_draw_geometry_with_custom_fov(pcd, 90.0)
custom_draw_geometry_with_custom_fov(pcd, -90.0)
custom_draw_geometry_with_rotation(pcd)
custom_draw_geometry_load_option(pcd, "renderoption.json")
seen = custom_draw_geometry_with_camera_trajectory(pcd, "cameras.json")
results["size"] = np.asarray(o3d.io.read_image("captures/00002.png")).shape
results["frames"] = len(seen)
results["depths"] = [depth for depth, image in seen]
