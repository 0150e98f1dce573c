"""Files, the cache and processes: what all other rooms stand on."""
