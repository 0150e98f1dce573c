"""Derivations of the records: sections, and the story that they make."""
