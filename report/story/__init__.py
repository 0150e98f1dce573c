"""The front page and the story: claims, tables and figures that combine several sections."""
