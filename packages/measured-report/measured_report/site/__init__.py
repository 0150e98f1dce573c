"""The site: written and checked."""
