"""Pages: templates and Markdown made into HTML."""
