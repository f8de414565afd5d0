"""Dense SLAM: camera trajectory and surface from RGB-D frames without poses."""
