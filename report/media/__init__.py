"""How pages show kept runs: clips and the replay."""
