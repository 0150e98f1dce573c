"""Define the parts of a section: claims, figures, tables and their wordings."""
