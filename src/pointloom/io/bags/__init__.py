"""Robot recordings without ROS: rosbag1, rosbag2 and MCAP."""
