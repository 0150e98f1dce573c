"""Parts of a section: claims, figures and tables, and their words."""
