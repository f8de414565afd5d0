"""Recordings of robots read without ROS: rosbag1, rosbag2 and MCAP."""
