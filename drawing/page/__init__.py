"""What recordings and live pages show in a browser: plain scripts, styles and pages, joined without a build step."""
