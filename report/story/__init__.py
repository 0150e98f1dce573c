"""The front page and the story: what the sections found, put in an order for people, in claims of their own."""
