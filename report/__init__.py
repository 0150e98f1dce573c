"""Values and claims derived from the records: the sections, and the story that combines them."""
