"""Poses from no guess: features, RANSAC, consensus, belief."""
