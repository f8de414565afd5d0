"""RGB-D odometry: the motion between two depth camera frames, with reliability checks."""
