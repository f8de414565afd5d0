"""Depth of single images by networks that the user brings as ONNX files, and clouds from it."""
