"""What is derived of the records: sections, the story that they make, and names for people."""
