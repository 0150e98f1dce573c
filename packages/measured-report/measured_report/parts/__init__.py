"""Parts of a section: figures and tables."""
