"""Changes: what editions have differently."""
