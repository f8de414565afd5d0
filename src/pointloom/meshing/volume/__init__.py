"""TSDF volumes: fusion, their surface, views of them."""
