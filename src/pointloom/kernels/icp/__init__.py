"""ICP registration: correspondences, rows, steps, the loop."""
