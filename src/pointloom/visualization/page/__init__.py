"""Scripts, styles and pages of recordings and live pages, joined without a build step."""
