"""The lint: which contact parameters of a model do not do what they say, and how fast its contacts will slide."""
