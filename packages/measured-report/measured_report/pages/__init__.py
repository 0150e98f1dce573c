"""Pages: from records to the text of a page."""
