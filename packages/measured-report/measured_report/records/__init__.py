"""Read and write records and traces, and find the code that they depend on."""
