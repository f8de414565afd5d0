"""Depth of single pictures by networks that the user brings as ONNX files, and clouds from it."""
