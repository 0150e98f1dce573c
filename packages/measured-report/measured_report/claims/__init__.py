"""Claims: tests on values, and the words for each outcome."""
