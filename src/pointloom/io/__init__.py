"""Strict readers, which never invent data, and atomic writers."""
