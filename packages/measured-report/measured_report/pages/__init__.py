"""Turn findings and templates into the HTML of pages."""
