"""Registration of clouds: reserved for the ICP family, global registration, odometry and pose graphs."""
