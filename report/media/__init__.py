"""Show kept runs on pages, as clips and in the replay."""
