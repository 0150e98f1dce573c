"""Write the site and check it."""
