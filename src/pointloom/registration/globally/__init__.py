"""Global registration: features, RANSAC, consensus, score."""
