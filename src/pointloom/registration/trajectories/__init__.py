"""Paths compared: ATE, RPE, similarities."""
