"""Points in groups: clusters, planes, patches, ground."""
