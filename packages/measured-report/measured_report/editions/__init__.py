"""Find the environments and records of editions, and whether records are fresh."""
